// SPDX-License-Identifier: BSD-3-Clause
// Isolines that ranks draw together, each in its own faces: joined at equal coordinates they are
// those of one process, and brute force finds the value at their points.
#include "RanksSupport.h"
#include "contours/IsolineSupport.h"

#include "contours/IsolineSides.h"
#include "contours/SolveForIsolines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <mutex>

using namespace geodesictest;
using geodesic::Id;
using geodesic::Isoline;
using geodesic::Isolines;

namespace
{

constexpr std::uint64_t MeshesOfAKind = 2;
constexpr std::size_t PointsTried = 20; // in each cut
constexpr double ChordFraction = 1e-4;
/// Ranks may cut windows, and so arcs into chords, at other places.
constexpr double LengthFraction = 1e-4;

class IsolinesOnRanks : public ::testing::TestWithParam<MeshKind>
{
};

/// A line as places in space, and each of its points in a face of the whole mesh.
struct PlainLine
{
  std::size_t value;
  std::vector<geodesic::Vec3> places;
  std::vector<MeshPoint> points;
};

/// \param wholeFace maps a face of the isolines' mesh to the whole mesh.
std::vector<PlainLine> plainLines(const geodesic::TriangleMesh& mesh, const Isolines& isolines,
  const std::function<Index(Id)>& wholeFace)
{
  std::vector<PlainLine> lines;
  for (const Isoline& line : isolines.lines)
  {
    PlainLine& plain = lines.emplace_back();
    plain.value = line.value;
    for (std::size_t i = 0; i < line.points.size(); ++i)
    {
      const geodesic::SurfacePoint& point = isolines.points[line.points[i]];
      const Id face = line.faces[std::min(i, line.faces.size() - 1)];
      plain.places.push_back(geodesic::position(mesh, point));
      plain.points.push_back({ wholeFace(face), geodesic::barycentric(mesh, point, face) });
    }
  }
  return lines;
}

double lengthOf(const std::vector<PlainLine>& lines, std::size_t value)
{
  double length = 0.0;
  for (const PlainLine& line : lines)
  {
    for (std::size_t i = 1; i < line.places.size() && line.value == value; ++i)
    {
      length += geodesic::norm(geodesic::operator-(line.places[i], line.places[i - 1]));
    }
  }
  return length;
}

/// Lines that are joined where exactly two ends have the same coordinates.
LineCount countJoined(const std::vector<PlainLine>& lines, std::size_t value)
{
  LineCount count;
  std::map<geodesic::Vec3, std::vector<std::size_t>> linesAt;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    if (lines[i].value == value)
    {
      linesAt[lines[i].places.front()].push_back(i);
      linesAt[lines[i].places.back()].push_back(i);
    }
  }
  std::vector<std::size_t> group(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    group[i] = i;
  }
  const auto root = [&](std::size_t i)
  {
    while (group[i] != i)
    {
      i = group[i];
    }
    return i;
  };
  for (const auto& [place, at] : linesAt)
  {
    if (at.size() == 2)
    {
      group[root(at[0])] = root(at[1]);
    }
  }
  std::map<std::size_t, bool> isOpen;
  for (const auto& [place, at] : linesAt)
  {
    for (const std::size_t i : at)
    {
      bool& open = isOpen[root(i)];
      open = open || at.size() != 2;
    }
  }
  for (const auto& [line, open] : isOpen)
  {
    ++(open ? count.open : count.closed);
  }
  return count;
}

/// A random mesh with sources, and ascending values: some anywhere, some at a vertex's distance.
struct CaseWithValues
{
  RandomCase plain;
  double largest;
  std::vector<double> values;

  CaseWithValues(const MeshKind& kind, std::uint64_t seed)
    : plain(randomCase(kind, seed + 79000, 0))
    , largest(largestFinite(this->plain.truth.vertices))
  {
    Random random(seed);
    const geodesic::TriangleMesh mesh = engineMesh(this->plain.mesh);
    const std::vector<double> distances =
      geodesic::solve(mesh, engineCurves(mesh, this->plain.curves)).vertexDistances();
    this->values = randomValues(distances, this->largest, { 0.01, 0.3, 0.8 }, random);
  }

  geodesic::IsolineOptions options() const
  {
    geodesic::IsolineOptions options;
    options.values = this->values;
    options.chordTolerance = ChordFraction * this->largest;
    return options;
  }
};

/// The parts of the lines on the left-hand side of the curves.
std::vector<geodesic::SidedValue> leftOnly(const std::vector<double>& values)
{
  std::vector<geodesic::SidedValue> sided;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    sided.push_back({ i, geodesic::SidedValue::None });
  }
  return sided;
}

bool isRight(const geodesic::Foot& foot)
{
  return foot.isRight;
}

geodesic::FrontOptions withArrivals()
{
  geodesic::FrontOptions options;
  options.keepArrivals = true;
  return options;
}

std::vector<PlainLine> linesInOnePiece(const CaseWithValues& c, bool sided)
{
  const geodesic::TriangleMesh mesh = engineMesh(c.plain.mesh);
  const std::vector<geodesic::SourceCurve> curves = engineCurves(mesh, c.plain.curves);
  const geodesic::DistanceField field = solveForIsolines(mesh, curves, c.values, withArrivals());
  Isolines isolines = drawIsolines(field, c.options());
  if (sided)
  {
    geodesic::NearestSource nearest(field, geodesic::ReplicatedPatch(field.mesh()), curves);
    isolines = linesOnSides(field, nearest, isRight, isolines, leftOnly(c.values));
  }
  return plainLines(mesh, isolines, [&](Id face) { return mesh.inputFace(face); });
}

std::vector<PlainLine> linesOnRanks(
  const CaseWithValues& c, const CutMesh& cut, bool sided, bool keepAll = false)
{
  std::vector<PlainLine> lines;
  std::mutex mutex;
  onRanks(cut, c.plain.curves, 0,
    [&](const RankOfRun& rank)
    {
      const geodesic::TriangleMesh& mesh = rank.part.mesh();
      const geodesic::DistanceField field = keepAll
        ? solveKeeping(rank.part, rank.sources, withArrivals(), rank.part.ownFaces())
        : solveForIsolines(rank.part, rank.sources, c.values, withArrivals());
      Isolines isolines = drawIsolines(field, c.options());
      if (sided)
      {
        geodesic::NearestSource nearest(field, rank.patch, rank.curvesOnPatch);
        isolines = linesOnSides(field, nearest, isRight, isolines, leftOnly(c.values));
      }
      const std::lock_guard<std::mutex> lock(mutex);
      expectChordsInFaces(mesh, isolines);
      for (const Isoline& line : isolines.lines)
      {
        for (const Id face : line.faces)
        {
          EXPECT_TRUE(rank.part.isOwn(face));
        }
      }
      const std::vector<PlainLine> own = plainLines(mesh, isolines,
        [&](Id face) {
          return wholeFaceOf(rank, { rank.exchange.rank(), face });
        });
      lines.insert(lines.end(), own.begin(), own.end());
    });
  return lines;
}

void expectAtValues(
  const CaseWithValues& c, const std::vector<PlainLine>& lines, double accuracy, Random& random)
{
  std::vector<MeshPoint> places;
  std::vector<double> values;
  for (std::size_t n = 0; n < PointsTried && !lines.empty(); ++n)
  {
    const PlainLine& line = lines[random.below(lines.size())];
    places.push_back(line.points[random.below(line.points.size())]);
    values.push_back(c.values[line.value]);
  }
  const std::vector<double> truth =
    bruteForceDistances(c.plain.mesh, toSources(c.plain.curves), places).queries;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    EXPECT_LE(std::abs(truth[i] - values[i]), accuracy * c.largest);
  }
}

void expectSame(
  const CaseWithValues& c, const std::vector<PlainLine>& lines, const std::vector<PlainLine>& whole)
{
  for (std::size_t value = 0; value < c.values.size(); ++value)
  {
    EXPECT_NEAR(lengthOf(lines, value), lengthOf(whole, value), LengthFraction * c.largest)
      << "value " << value;
    const LineCount joined = countJoined(lines, value);
    const LineCount expected = countJoined(whole, value);
    EXPECT_TRUE(joined == expected)
      << "value " << c.values[value] << " of " << c.largest << ": " << joined.open << " open and "
      << joined.closed << " closed lines instead of " << expected.open << " and "
      << expected.closed;
  }
}

}

TEST_P(IsolinesOnRanks, JoinToThoseOfOnePiece)
{
  std::size_t compared = 0;
  for (std::uint64_t seed = 0; seed < MeshesOfAKind; ++seed)
  {
    const CaseWithValues c(GetParam(), seed);
    if (!(c.largest > 0.0))
    {
      continue; // the source goes through all vertices
    }
    const std::vector<PlainLine> whole = linesInOnePiece(c, false);
    Random random(seed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    forEachCut(c.plain.mesh, someWaysToCut(), random,
      [&](const CutMesh& cut)
      {
        const std::vector<PlainLine> lines = linesOnRanks(c, cut, false);
        expectSame(c, lines, whole);
        expectAtValues(c, lines, std::max(1e-12, accuracyOn(GetParam())), random);
        compared += lines.size();
      });
    expectSame(c, linesOnRanks(c, cutInSpace(c.plain.mesh, 3, random), false, true), whole);
  }
  EXPECT_GT(compared, 0U);
}

TEST_P(IsolinesOnRanks, OnOneSideOfTheSourceJoinToThoseOfOnePiece)
{
  const geodesic::TriangleMesh mesh = engineMesh(randomCase(GetParam(), 79000, 0).mesh);
  for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
  {
    if (!mesh.isBoundary(halfedge) && mesh.acrossOriented(halfedge) == geodesic::NoId)
    {
      GTEST_SKIP() << "surfaces of this kind have no sides";
    }
  }
  const CaseWithValues c(GetParam(), 0);
  const std::vector<PlainLine> whole = linesInOnePiece(c, true);
  Random random(0);
  for (const int ranks : { 2, 4 })
  {
    const std::vector<PlainLine> lines =
      linesOnRanks(c, cutInSpace(c.plain.mesh, ranks, random), true);
    for (std::size_t value = 0; value < c.values.size(); ++value)
    {
      EXPECT_NEAR(lengthOf(lines, value), lengthOf(whole, value), LengthFraction * c.largest)
        << "value " << value << ", " << ranks << " ranks";
    }
  }
}

TEST(IsolinesOnSeams, HaveNoDirectionWhereFacesOfOppositeOrientationMeet)
{
  for (const bool isTurned : { false, true })
  {
    // Around a corner of a square; each rank has one half of the square.
    PlainMesh mesh = regularGrid(4, 4);
    CutMesh cut{ mesh, 2, {} };
    for (Triangle& triangle : mesh.triangles)
    {
      const bool isLeft =
        mesh.points[triangle[0]][0] + mesh.points[triangle[1]][0] + mesh.points[triangle[2]][0] <
        6.0;
      cut.rankOfFace.push_back(isLeft ? 0 : 1);
      if (isTurned && !isLeft)
      {
        std::swap(triangle[1], triangle[2]);
      }
    }
    MeshPoint corner = { 0, {} };
    for (std::size_t k = 0; k < 3; ++k)
    {
      corner.weights[k] = mesh.triangles[0][k] == 0 ? 1.0 : 0.0;
    }
    geodesic::IsolineOptions options;
    options.values = { 3.1 };
    options.chordTolerance = 1e-3;
    onRanks(cut, { { { { corner.face, corner.weights, corner.weights } }, {} } }, 0,
      [&](const RankOfRun& rank)
      {
        const Isolines isolines = drawIsolines(
          solveForIsolines(rank.part, rank.sources, options.values, withArrivals()), options);
        EXPECT_EQ(isolines.lines.size(), 1U);
        EXPECT_EQ(isolines.linesWithoutDirection, isTurned ? 1U : 0U);
      });
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, IsolinesOnRanks, ::testing::ValuesIn(meshKinds()),
  [](const auto& kind) { return std::string(kind.param.name); });
