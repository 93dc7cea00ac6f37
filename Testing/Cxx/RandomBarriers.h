// SPDX-License-Identifier: BSD-3-Clause
// Random surfaces with random barriers, their sources, and what the brute-force solver needs of
// them.
#ifndef RandomBarriers_h
#define RandomBarriers_h

#include "GeodesicTesting.h"

#include "truth/BruteForce.h"
#include "truth/CappedMeshes.h"
#include "truth/RandomCurves.h"
#include "truth/RandomMeshKinds.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <optional>
#include <set>

namespace GeodesicTesting
{

/// A random mesh with random barriers, and what is left without them.
struct RandomBarriers
{
  /// What the filter gets, and which of its faces are barriers.
  geodesictest::PlainMesh surface;
  std::vector<bool> isBarrier;
  /// The same without its faces that have no area.
  geodesictest::PlainMesh whole;
  /// Without barriers.
  geodesictest::PlainMesh open;
  /// For each point of the surface the one of the whole at its place.
  std::vector<geodesictest::Index> pointOfWhole;
};

/// For each point of the surface whether a face that is no barrier has it.
inline std::vector<bool> PointsOutsideBarriers(const RandomBarriers& made)
{
  std::vector<bool> isOutside(made.surface.points.size(), false);
  for (std::size_t f = 0; f < made.surface.triangles.size(); ++f)
  {
    for (const geodesictest::Index point : made.surface.triangles[f])
    {
      isOutside[point] = isOutside[point] || !made.isBarrier[f];
    }
  }
  return isOutside;
}

/// The true distance at a point of the surface: infinite where barriers alone have it. There is
/// none at a second point of barriers at a place.
///
/// \param isOutside by PointsOutsideBarriers().
/// \param truth at the points of the whole.
inline std::optional<double> TruthAt(const RandomBarriers& made, const std::vector<bool>& isOutside,
  const std::vector<double>& truth, std::size_t point)
{
  const geodesictest::Index ofWhole = made.pointOfWhole[point];
  return isOutside[point] ? std::optional<double>(truth[ofWhole])
    : ofWhole == point    ? std::optional<double>(INFINITY)
                          : std::nullopt;
}

/// Single faces, patches around vertices, or nearly all.
inline std::vector<bool> RandomFaces(
  const geodesictest::PlainMesh& mesh, geodesictest::Random& random)
{
  const std::size_t faces = mesh.triangles.size();
  std::vector<bool> chosen(faces, false);
  const double share = random.uniform(0.02, 0.5);
  const bool arePatches = random.chance(0.5);
  std::vector<bool> isMarked(mesh.points.size(), false);
  for (std::size_t i = 0; i < isMarked.size(); ++i)
  {
    isMarked[i] = random.chance(0.3 * share);
  }
  for (std::size_t f = 0; f < faces; ++f)
  {
    const geodesictest::Triangle& t = mesh.triangles[f];
    chosen[f] =
      arePatches ? isMarked[t[0]] || isMarked[t[1]] || isMarked[t[2]] : random.chance(share);
  }
  chosen[random.below(faces)] = false;
  return chosen;
}

inline void AddOpenFaces(RandomBarriers& made, const std::vector<bool>& isBarrierOfWhole)
{
  made.open.points = made.whole.points;
  for (std::size_t f = 0; f < made.whole.triangles.size(); ++f)
  {
    if (!isBarrierOfWhole[f])
    {
      made.open.triangles.push_back(made.whole.triangles[f]);
    }
  }
}

inline RandomBarriers MakeBarriers(const geodesictest::MeshKind& kind, geodesictest::Random& random)
{
  RandomBarriers made;
  made.whole = kind.make(random.between(30, 200), random);
  made.surface = made.whole;
  made.isBarrier = RandomFaces(made.whole, random);
  AddOpenFaces(made, made.isBarrier);
  for (geodesictest::Index i = 0; i < made.whole.points.size(); ++i)
  {
    made.pointOfWhole.push_back(i);
  }
  return made;
}

/// The same with faces without area. They are barriers where all faces at their edge are, and may
/// be where only one is none and they lie exactly on its edge, where a source may be.
inline RandomBarriers MakeBarriersWithFlatFaces(
  const geodesictest::MeshKind& kind, geodesictest::Random& random)
{
  const geodesictest::PlainMesh before = kind.make(random.between(8, 60), random);
  const double offset = random.chance(0.5) ? 0.0 : std::pow(10.0, random.uniform(-17.0, -12.0));
  geodesictest::CappedMesh both = geodesictest::withCaps(
    before, geodesictest::Caps::AnyAndLoose, random.uniform(0.1, 1.0), random, offset);
  geodesictest::addNeedles(both, random.uniform(0.0, 0.5), random, offset);
  const std::vector<bool> isBarrier = random.chance(0.3)
    ? std::vector<bool>(before.triangles.size(), false)
    : RandomFaces(before, random);
  RandomBarriers made;
  std::map<std::vector<geodesictest::Index>, bool> isClosed; // all on an edge together
  for (const std::vector<geodesictest::Index>& faces : both.facesBefore)
  {
    const auto open = std::count_if(
      faces.begin(), faces.end(), [&](geodesictest::Index f) { return !isBarrier[f]; });
    const bool mayBeBarrier = offset == 0.0 && open == 1 && faces.size() > 1;
    const bool isBarrierHere = open == 0 || (mayBeBarrier && random.chance(0.5));
    made.isBarrier.push_back(isClosed.emplace(faces, isBarrierHere).first->second);
  }
  std::vector<bool> isBarrierOfWhole;
  for (const geodesictest::Index f : both.faceBefore)
  {
    isBarrierOfWhole.push_back(isBarrier[f]);
  }
  made.surface = both.mesh;
  made.whole = both.conforming;
  made.pointOfWhole = both.vertexOf;
  AddOpenFaces(made, isBarrierOfWhole);
  return made;
}

/// \param isWanted which faces; empty: all.
inline vtkSmartPointer<vtkPolyData> SurfaceOf(
  const RandomBarriers& made, const std::vector<bool>& isWanted = {})
{
  std::vector<geodesictest::Triangle> faces;
  std::vector<int> barriers;
  for (std::size_t f = 0; f < made.surface.triangles.size(); ++f)
  {
    if (isWanted.empty() || isWanted[f])
    {
      faces.push_back(made.surface.triangles[f]);
      barriers.push_back(made.isBarrier[f] ? -3 : 0);
    }
  }
  auto surface = Mesh(made.surface.points, faces);
  AddArray<vtkIntArray>(surface->GetCellData(), "barrier", barriers);
  return surface;
}

inline Point PositionOf(const geodesictest::PlainMesh& mesh, const geodesictest::MeshPoint& point)
{
  return geodesictest::position(mesh, point);
}

/// Segments of faces that are no barriers, and points of these.
inline geodesictest::Sources RandomSources(
  const geodesictest::PlainMesh& open, geodesictest::Random& random)
{
  geodesictest::Sources sources;
  const geodesictest::Index points = random.below(3);
  for (geodesictest::Index i = 0; i < points; ++i)
  {
    sources.points.push_back(random.chance(0.5) ? geodesictest::randomVertexPoint(open, random)
                                                : geodesictest::randomFacePoint(open, random));
  }
  const geodesictest::Index segments = random.between(points == 0 ? 1 : 0, 2);
  for (geodesictest::Index i = 0; i < segments; ++i)
  {
    sources.segments.push_back({ random.below(open.triangles.size()),
      geodesictest::randomWeights(random), geodesictest::randomWeights(random) });
  }
  return sources;
}

inline vtkSmartPointer<vtkPolyData> SourceOf(
  const geodesictest::PlainMesh& open, const geodesictest::Sources& sources)
{
  auto source = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkCellArray> lines;
  for (const geodesictest::MeshPoint& point : sources.points)
  {
    vertices->InsertNextCell({ points->InsertNextPoint(PositionOf(open, point).data()) });
  }
  for (const geodesictest::MeshSegment& segment : sources.segments)
  {
    const vtkIdType from =
      points->InsertNextPoint(PositionOf(open, { segment.face, segment.from }).data());
    const vtkIdType to =
      points->InsertNextPoint(PositionOf(open, { segment.face, segment.to }).data());
    lines->InsertNextCell({ from, to });
  }
  source->SetPoints(points);
  source->SetVerts(vertices);
  source->SetLines(lines);
  return source;
}

/// What faces without barriers have of the boundary of the whole: edges, and single vertices.
inline void AddBoundary(const RandomBarriers& made, geodesictest::Sources& sources)
{
  std::map<std::pair<geodesictest::Index, geodesictest::Index>,
    std::pair<geodesictest::Index, geodesictest::Index>>
    faceAt;
  std::map<geodesictest::Index, geodesictest::Index> faceOfVertex;
  for (geodesictest::Index f = 0; f < made.open.triangles.size(); ++f)
  {
    const geodesictest::Triangle& t = made.open.triangles[f];
    for (geodesictest::Index k = 0; k < 3; ++k)
    {
      faceAt[std::minmax({ t[k], t[(k + 1) % 3] })] = { f, k };
      faceOfVertex[t[k]] = f;
    }
  }
  for (const auto& [a, b] : geodesictest::boundaryEdges(made.whole))
  {
    const auto at = faceAt.find(std::minmax({ a, b }));
    if (at != faceAt.end())
    {
      geodesictest::MeshSegment edge{ at->second.first, { 0, 0, 0 }, { 0, 0, 0 } };
      edge.from[at->second.second] = 1.0;
      edge.to[(at->second.second + 1) % 3] = 1.0;
      sources.segments.push_back(edge);
    }
    for (const geodesictest::Index vertex : { a, b })
    {
      if (faceOfVertex.count(vertex) > 0)
      {
        sources.points.push_back(geodesictest::vertexPoint(made.open, vertex));
      }
    }
  }
}

/// Whether vertices of faces are at one place, as where two fans coincide: which of them a source
/// is put onto is open then.
///
/// \param within places that differ by less are one; 0: by nothing.
inline bool TouchesItself(const geodesictest::PlainMesh& mesh, double within = 0.0)
{
  std::set<geodesictest::Index> vertices;
  std::set<geodesictest::Vec3> places;
  for (const geodesictest::Triangle& t : mesh.triangles)
  {
    for (const geodesictest::Index vertex : t)
    {
      geodesictest::Vec3 place = mesh.points[vertex];
      for (double& x : place)
      {
        x = within > 0.0 ? within * std::round(x / within) : x;
      }
      vertices.insert(vertex);
      places.insert(place);
    }
  }
  return places.size() < vertices.size();
}

/// Whether a point of the open faces lies in space on another face, too, which does not have it:
/// which of them a source is put onto is open then.
inline bool IsOnOtherFace(const geodesictest::PlainMesh& open, const geodesictest::MeshPoint& point)
{
  const geodesictest::Triangle& own = open.triangles[point.face];
  const Point p = PositionOf(open, point);
  const auto hasIt = [&](const geodesictest::Triangle& other)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (point.weights[k] != 0.0 && std::find(other.begin(), other.end(), own[k]) == other.end())
      {
        return false;
      }
    }
    return true;
  };
  vtkNew<vtkTriangle> face;
  for (const geodesictest::Triangle& other : open.triangles)
  {
    if (hasIt(other))
    {
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      face->GetPoints()->SetPoint(static_cast<vtkIdType>(k), open.points[other[k]].data());
    }
    Point closest;
    Point coordinates;
    Point weights;
    int subId = 0;
    double squared = 1.0;
    const bool isKnown = face->EvaluatePosition(p.data(), closest.data(), subId, coordinates.data(),
                           squared, weights.data()) >= 0;
    const double scale = face->GetLength2() + p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
    if (isKnown && squared < 1e-18 * scale)
    {
      return true;
    }
  }
  return false;
}

/// Each face in a random block. Blocks have all points.
inline vtkSmartPointer<vtkMultiBlockDataSet> BlocksOf(
  const RandomBarriers& made, geodesictest::Index count, geodesictest::Random& random)
{
  std::vector<std::vector<bool>> isInBlock(
    count, std::vector<bool>(made.surface.triangles.size(), false));
  for (std::size_t f = 0; f < made.surface.triangles.size(); ++f)
  {
    isInBlock[random.below(count)][f] = true;
  }
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (geodesictest::Index i = 0; i < count; ++i)
  {
    blocks->SetBlock(i, SurfaceOf(made, isInBlock[i]));
  }
  return blocks;
}

/// A filter for a random surface with barriers and a random source.
struct RandomCase
{
  std::string name;
  RandomBarriers made;
  geodesictest::Sources sources;
  vtkNew<vtkGeodesicDistanceField> filter;
  /// Of the largest distance.
  double accuracy;

  /// \param hasFlatFaces the surface has faces without area, maybe in several blocks. The source is
  ///        not its boundary: barriers without area have one of their own.
  RandomCase(const geodesictest::MeshKind& kind, std::uint64_t seed, bool hasFlatFaces = false)
    : name(std::string(kind.name) + ", seed " + std::to_string(seed))
    , accuracy(Contains(kind.name, "Needles") ? 5e-10
          : hasFlatFaces                      ? 1e-10
                                              : 2e-12)
  {
    geodesictest::Random random(seed);
    this->made =
      hasFlatFaces ? MakeBarriersWithFlatFaces(kind, random) : MakeBarriers(kind, random);
    this->filter->SetSourceType(hasFlatFaces
        ? static_cast<int>(vtkGeodesicDistanceField::SOURCE_CURVE)
        : static_cast<int>(random.below(3)));
    if (this->filter->GetSourceType() != vtkGeodesicDistanceField::SURFACE_BOUNDARY)
    {
      this->sources = RandomSources(this->made.open, random);
      this->filter->SetSourceData(SourceOf(this->made.open, this->sources));
    }
    if (this->filter->GetSourceType() != vtkGeodesicDistanceField::SOURCE_CURVE)
    {
      AddBoundary(this->made, this->sources);
    }
    this->filter->MergeCoincidentPointsOff();
    this->filter->SetBarrierArrayName("barrier");
    this->filter->SetInputData(SurfaceOf(this->made));
    if (hasFlatFaces && random.chance(0.6) && !TouchesItself(this->made.whole, 1e-9))
    {

      this->filter->MergeCoincidentPointsOn();
      this->filter->SetInputDataObject(0, BlocksOf(this->made, random.between(1, 4), random));
    }
  }

  /// Whether there is a source, and it is clear where it lies.
  bool CanRun(Check& check)
  {
    Messages messages(this->filter);
    if (TouchesItself(this->made.whole))
    {
      std::cout << this->name << " touches itself: left out\n";
      return false;
    }
    messages.Update();
    if (this->sources.points.empty() && this->sources.segments.empty())
    {
      check.That(Contains(messages.Error(), "boundary"), this->name + ": " + messages.Error());
      return false;
    }
    check.That(messages.Error().empty(), this->name + ": " + messages.Error());
    return messages.Error().empty();
  }

  /// Whether it depends on the order of the faces where a source lies.
  bool IsSourceOpen() const
  {
    std::vector<geodesictest::MeshPoint> ends = this->sources.points;
    for (const geodesictest::MeshSegment& segment : this->sources.segments)
    {
      ends.push_back({ segment.face, segment.from });
      ends.push_back({ segment.face, segment.to });
    }
    return std::any_of(ends.begin(), ends.end(),
      [this](const geodesictest::MeshPoint& end) { return IsOnOtherFace(this->made.open, end); });
  }

  double DistanceAt(std::size_t point) const
  {
    return Distances(this->filter)->GetTuple1(static_cast<vtkIdType>(point));
  }
};

inline double LargestFinite(const std::vector<double>& values)
{
  double largest = 0.0;
  for (const double value : values)
  {
    largest = std::isinf(value) ? largest : std::max(largest, value);
  }
  return largest;
}

inline double ErrorOf(double actual, double expected)
{
  return std::isinf(actual) && std::isinf(expected) ? 0.0 : std::abs(actual - expected);
}

}

#endif
