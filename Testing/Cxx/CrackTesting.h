// SPDX-License-Identifier: BSD-3-Clause
// Random surfaces that fall into pieces, each stored on its own with roundings.
#ifndef CrackTesting_h
#define CrackTesting_h

#include "GeodesicTesting.h"
#include "Seeds.h"
#include "truth/BruteForce.h"
#include "truth/TestMeshes.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace GeodesicTesting
{

/// A surface with cracks, and its distances without them.
struct Cracked
{
  std::string Name;
  vtkSmartPointer<vtkPolyData> Surface;
  vtkSmartPointer<vtkPolyData> Source;
  /// How many points have to be joined with others.
  vtkIdType PointsToJoin = 0;
  /// How much roundings may change a distance, as a fraction of the largest.
  double Tolerance = 0.0;
  std::map<Point, double> Truth;

  /// The largest error of the distances at the points of the surface, or of a piece of it, as a
  /// fraction of the largest distance.
  double ErrorOf(vtkPolyData* output) const
  {
    vtkDataArray* distances = output->GetPointData()->GetArray("GeodesicDistance");
    double worst = distances ? 0.0 : std::numeric_limits<double>::infinity();
    double largest = 0.0;
    for (const auto& [place, distance] : this->Truth)
    {
      largest = std::isfinite(distance) ? std::max(largest, distance) : largest;
    }
    for (vtkIdType i = 0; distances && i < output->GetNumberOfPoints(); ++i)
    {
      const Point p = PointAt(output, i);
      const double truth = this->Truth.at(p);
      if (distances->GetTuple1(i) != truth)
      {
        const double error = std::abs(distances->GetTuple1(i) - truth) / largest;
        worst =
          std::isnan(error) ? std::numeric_limits<double>::infinity() : std::max(worst, error);
      }
    }
    return worst;
  }
};

/// How a surface with cracks is stored.
struct Storage
{
  bool IsSingle;
  int DataType;

  double Rounded(double x) const { return this->IsSingle ? double(static_cast<float>(x)) : x; }
  double Next(double x, double towards) const
  {
    return this->IsSingle
      ? double(std::nextafterf(static_cast<float>(x), static_cast<float>(towards)))
      : std::nextafter(x, towards);
  }
};

/// A mesh of fair triangles, with or without boundary, with edges of three faces or one-sided.
inline geodesictest::PlainMesh MakeFairMesh(geodesictest::Random& random, std::string& name)
{
  using namespace geodesictest;
  const Index n = random.between(3, 8);
  const Index kind = random.below(9);
  const char* const names[] = { "planar", "holes", "bumpy", "book", "moebius", "box", "octasphere",
    "cylinder", "torus" };
  name = names[kind];
  switch (kind)
  {
    case 0:
      return moved(randomPlanar(n, n + 1, random), random);
    case 1:
      return moved(planarWithHoles(n + 2, n + 2, 3, random), random);
    case 2:
      return moved(bumpySheet(n, n, 1, .4, random), random);
    case 3:
      return moved(book(random.between(3, 5), n, 3, .2, random), random);
    case 4:
      return moved(moebius(3 * n, 3), random);
    case 5:
      return box({ 1, 2, 3 }, { 2, 3, n });
    case 6:
      return moved(octasphere(n), random);
    case 7:
      return openCylinder(n + 2, n, 1.0 * n);
    default:
      return moved(torus(6, 2 * n, 3.0), random);
  }
}

inline double ShortestEdge(const geodesictest::PlainMesh& mesh)
{
  double shortest = std::numeric_limits<double>::infinity();
  for (const geodesictest::Triangle& t : mesh.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      shortest = std::min(
        shortest, geodesictest::spaceDistance(mesh.points[t[k]], mesh.points[t[(k + 1) % 3]]));
    }
  }
  return shortest;
}

/// Gives each corner of each face (3 * face + k) the number of the piece of its vertex that it
/// belongs to: corners that are joined by edges that are not cut.
inline std::vector<std::size_t> PiecesOfCorners(
  const geodesictest::PlainMesh& mesh, const std::function<bool()>& isCut)
{
  std::vector<std::size_t> piece(3 * mesh.triangles.size());
  std::iota(piece.begin(), piece.end(), std::size_t(0));
  const auto rootOf = [&piece](std::size_t i)
  {
    while (piece[i] != i)
    {
      i = piece[i];
    }
    return i;
  };
  std::map<std::pair<geodesictest::Index, geodesictest::Index>, std::vector<std::size_t>> edges;
  for (std::size_t corner = 0; corner < piece.size(); ++corner)
  {
    const geodesictest::Triangle& t = mesh.triangles[corner / 3];
    edges[std::minmax(t[corner % 3], t[(corner + 1) % 3])].push_back(corner / 3);
  }
  for (const auto& [edge, faces] : edges)
  {
    const bool isKept = !isCut();
    for (const auto vertex : { edge.first, edge.second })
    {
      const auto cornerAt = [&, vertex = vertex](std::size_t face)
      {
        const geodesictest::Triangle& t = mesh.triangles[face];
        return 3 * face +
          static_cast<std::size_t>(std::find(t.begin(), t.end(), vertex) - t.begin());
      };
      for (const std::size_t face : faces)
      {
        if (isKept)
        {
          piece[rootOf(cornerAt(face))] = rootOf(cornerAt(faces.front()));
        }
      }
    }
  }
  for (std::size_t& of : piece)
  {
    of = rootOf(of);
  }
  return piece;
}

/// One of the points that a vertex has become.
struct Copy
{
  geodesictest::Index Vertex;
  Point Place;
};

/// Where copies coincide, sheets at an edge of three and more faces can be whole without the
/// others: their vertices are inside of the surface, where nothing is joined. All copies of such a
/// vertex are put to its place.
///
/// \param corners of each face the copies.
inline void MendInnerCopies(const geodesictest::PlainMesh& mesh,
  const std::vector<std::size_t>& corners, std::vector<Copy>& copies)
{
  for (bool hasChanged = true; hasChanged;)
  {
    std::map<std::array<Point, 2>, int> faces;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      std::array<Point, 2> edge = { copies[corners[i]].Place,
        copies[corners[i % 3 == 2 ? i - 2 : i + 1]].Place };
      std::sort(edge.begin(), edge.end());
      ++faces[edge];
    }
    std::set<Point> onBoundary;
    for (const auto& [edge, count] : faces)
    {
      if (count == 1)
      {
        onBoundary.insert(edge.begin(), edge.end());
      }
    }
    hasChanged = false;
    std::set<geodesictest::Index> inside;
    for (const Copy& copy : copies)
    {
      if (onBoundary.count(copy.Place) == 0)
      {
        inside.insert(copy.Vertex);
      }
    }
    for (Copy& copy : copies)
    {
      const Point& place = mesh.points[copy.Vertex];
      if (inside.count(copy.Vertex) > 0 && copy.Place != place)
      {
        copy.Place = place;
        hasChanged = true;
      }
    }
  }
}

/// The same surface for the same seed.
inline Cracked MakeCracked(std::uint64_t seed)
{
  using namespace geodesictest;
  Random random(seed);
  Cracked cracked;
  PlainMesh mesh = MakeFairMesh(random, cracked.Name);
  const bool isSingle = random.chance(.5);
  const Storage storage{ isSingle, isSingle && random.chance(.5) ? VTK_FLOAT : VTK_DOUBLE };
  cracked.Name +=
    isSingle ? (storage.DataType == VTK_FLOAT ? ", single" : ", single as double") : ", double";
  // So many roundings make an edge, at the origin or far from it.
  const double epsilon = isSingle ? 1.2e-7 : 2.3e-16;
  const double edgeInRoundings = std::pow(10.0, random.uniform(2.5, 5.0));
  const double far = random.chance(.5) ? 1e6 : 0.0;
  const double scale = far > 0.0 ? edgeInRoundings * epsilon * far / ShortestEdge(mesh)
                                 : std::pow(10.0, random.uniform(-3.0, 3.0));
  cracked.Name += far > 0.0 ? ", far from the origin" : "";
  double largest = 0.0;
  for (Vec3& p : mesh.points)
  {
    for (double& x : p)
    {
      x = storage.Rounded(x * scale + far);
      largest = std::max(largest, std::abs(x));
    }
  }
  cracked.Tolerance = 16.0 * epsilon * largest / ShortestEdge(mesh) + 1e-12;

  const double cut = std::array<double, 4>{ .1, .3, .6, 1. }[random.below(4)];
  const std::vector<std::size_t> pieces = PiecesOfCorners(mesh, [&] { return random.chance(cut); });
  const MeshPoint source = randomVertexPoint(mesh, random);
  Sources sources;
  sources.points = { source };
  const std::vector<double> truth = bruteForceDistances(mesh, sources).vertices;

  std::map<std::size_t, std::size_t> numbers;
  std::vector<Copy> copies;
  std::vector<std::size_t> corners;
  for (std::size_t corner = 0; corner < pieces.size(); ++corner)
  {
    const Index vertex = mesh.triangles[corner / 3][corner % 3];
    const auto [number, isNew] = numbers.emplace(pieces[corner], copies.size());
    if (isNew)
    {
      const bool isExact = random.chance(.3);
      copies.push_back({ vertex, mesh.points[vertex] });
      for (double& x : copies.back().Place)
      {
        const double step = isExact ? 0.0 : random.between(0, 2) - 1.0;
        x = step == 0.0 ? x : storage.Next(x, step * 1e30);
      }
    }
    corners.push_back(number->second);
  }
  MendInnerCopies(mesh, corners, copies);

  vtkNew<vtkPoints> points;
  points->SetDataType(storage.DataType);
  std::map<Index, std::set<Point>> places;
  for (const Copy& copy : copies)
  {
    points->InsertNextPoint(copy.Place.data());
    places[copy.Vertex].insert(copy.Place);
    cracked.Truth[copy.Place] = truth[copy.Vertex];
  }
  for (const auto& [vertex, of] : places)
  {
    cracked.PointsToJoin += static_cast<vtkIdType>(of.size()) - 1;
  }
  vtkNew<vtkCellArray> polys;
  for (std::size_t i = 0; i < corners.size(); i += 3)
  {
    polys->InsertNextCell({ static_cast<vtkIdType>(corners[i]),
      static_cast<vtkIdType>(corners[i + 1]), static_cast<vtkIdType>(corners[i + 2]) });
  }
  cracked.Surface = vtkSmartPointer<vtkPolyData>::New();
  cracked.Surface->SetPoints(points);
  cracked.Surface->SetPolys(polys);
  cracked.Source = PointSources({ position(mesh, source) }, storage.DataType);
  return cracked;
}

/// Checks that the cracks of a surface are closed.
///
/// \param piece what this process has of the surface.
/// \returns the largest error, as a fraction of what roundings explain.
inline double CheckClosed(
  Check& check, const Cracked& cracked, vtkPolyData* piece, const std::string& what)
{
  const auto filter = PlainField(piece, cracked.Source);
  Messages(filter).ExpectNothing(check, what);
  check.Equal(filter->GetSeamPointsJoined(), cracked.PointsToJoin, what + ": joined points");
  const double error = cracked.ErrorOf(filter->GetOutput());
  check.That(error <= cracked.Tolerance,
    what + ": wrong by " + std::to_string(error) + " of the largest distance, allowed " +
      std::to_string(cracked.Tolerance));
  return error / cracked.Tolerance;
}

}

#endif
