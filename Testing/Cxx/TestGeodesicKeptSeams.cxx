// SPDX-License-Identifier: BSD-3-Clause
// On a kept seam (MergeCoincidentPoints off) several points lie at one place. A source or a target
// that names its point of the surface (vtkOriginalPointIds) is that point. Against the plane and
// the brute-force solver; GEODESIC_TEST_SEEDS=FIRST,COUNT takes other random meshes.
#include "LineTesting.h"

#include "Seeds.h"
#include "truth/BruteForce.h"
#include "truth/RandomMeshKinds.h"

#include "vtkIdTypeArray.h"
#include "vtkMultiBlockDataSet.h"

#include <numeric>

using namespace GeodesicTesting;

namespace
{

using geodesictest::Random;

constexpr double Infinite = std::numeric_limits<double>::infinity();

/// Says which points of a surface some points are.
void Name(vtkPolyData* data, const std::vector<vtkIdType>& ids)
{
  AddArray<vtkIdTypeArray>(data->GetPointData(), "vtkOriginalPointIds", ids);
}

/// Points of a surface that know which ones they are.
vtkSmartPointer<vtkPolyData> Named(
  vtkPolyData* surface, const std::vector<vtkIdType>& ids, int dataType = VTK_DOUBLE)
{
  auto data = PointSources(PlacesOf(surface, ids), dataType);
  Name(data, ids);
  return data;
}

std::vector<vtkIdType> AllIds(vtkPolyData* surface)
{
  std::vector<vtkIdType> ids(static_cast<std::size_t>(surface->GetNumberOfPoints()));
  std::iota(ids.begin(), ids.end(), 0);
  return ids;
}

//------------------------------------------------------------------------------
/// Cuts a mesh along some of its edges: faces around a vertex keep it in common if they are
/// neighbors across an edge that is whole.
geodesictest::PlainMesh Cut(const geodesictest::PlainMesh& mesh, double share, Random& random)
{
  using Edge = std::pair<geodesictest::Index, geodesictest::Index>;
  std::map<Edge, bool> isCut;
  std::map<Edge, std::vector<std::size_t>> facesAt;
  std::vector<std::vector<std::size_t>> facesAround(mesh.points.size());
  for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Edge edge = std::minmax({ mesh.triangles[f][k], mesh.triangles[f][(k + 1) % 3] });
      facesAt[edge].push_back(f);
      if (isCut.find(edge) == isCut.end())
      {
        isCut[edge] = random.chance(share);
      }
      facesAround[mesh.triangles[f][k]].push_back(f);
    }
  }
  geodesictest::PlainMesh result = mesh;
  for (geodesictest::Index vertex = 0; vertex < mesh.points.size(); ++vertex)
  {
    std::set<std::size_t> left(facesAround[vertex].begin(), facesAround[vertex].end());
    for (bool isFirst = true; !left.empty(); isFirst = false)
    {
      std::vector<std::size_t> fan = { *left.begin() };
      left.erase(left.begin());
      for (std::size_t i = 0; i < fan.size(); ++i)
      {
        for (const geodesictest::Index other : mesh.triangles[fan[i]])
        {
          const Edge edge = std::minmax({ vertex, other });
          for (const std::size_t next :
            other == vertex || isCut[edge] ? std::vector<std::size_t>() : facesAt[edge])
          {
            if (left.erase(next) > 0)
            {
              fan.push_back(next);
            }
          }
        }
      }
      const auto copy = isFirst ? vertex : static_cast<geodesictest::Index>(result.points.size());
      if (!isFirst)
      {
        result.points.push_back(mesh.points[vertex]);
      }
      for (const std::size_t f : fan)
      {
        for (std::size_t k = 0; k < 3; ++k)
        {
          result.triangles[f][k] = mesh.triangles[f][k] == vertex ? copy : result.triangles[f][k];
        }
      }
    }
  }
  return result;
}

void CheckField(Check& check, vtkPolyData* surface, vtkPolyData* source,
  const std::vector<double>& truth, const std::string& what)
{
  const auto filter = PlainField(surface, source);
  filter->MergeCoincidentPointsOff();
  RunWithoutError(check, filter, what);
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    check.Near(Distances(filter)->GetTuple1(static_cast<vtkIdType>(i)), truth[i],
      1e-10 * surface->GetLength(), what + ": distance");
  }
}

void CheckMatrixAndPaths(Check& check, vtkPolyData* surface, vtkPolyData* source,
  const std::vector<double>& truth, const std::string& what)
{
  const auto targets = Named(surface, AllIds(surface));
  const auto matrix = FilterOn<vtkGeodesicDistanceMatrix>(surface, source);
  const auto paths = FilterOn<vtkGeodesicPaths>(surface, source);
  matrix->SetTargetsData(targets);
  paths->SetTargetsData(targets);
  matrix->MergeCoincidentPointsOff();
  paths->MergeCoincidentPointsOff();
  matrix->Update();
  RunWithoutError(check, paths, what);
  std::vector<double> lengths(truth.size(), Infinite);
  vtkPolyData* output = paths->GetOutput();
  for (vtkIdType i = 0; i < output->GetNumberOfLines(); ++i)
  {
    lengths[static_cast<std::size_t>(CellValue(output, "TargetId", i))] =
      CellValue(output, "GeodesicDistance", i);
  }
  const double tolerance = 1e-10 * surface->GetLength();
  for (std::size_t i = 0; i < truth.size(); ++i)
  {
    check.Near(matrix->GetOutput()->GetValue(static_cast<vtkIdType>(i), 1).ToDouble(), truth[i],
      tolerance, what + ": matrix");
    check.Near(lengths[i], truth[i], tolerance, what + ": the length of a path");
  }
}

/// A vertex and an edge of a random cut mesh, by the ids of their points.
void CheckRandomSeams(Check& check)
{
  const geodesictest::Seeds seeds = geodesictest::seedsOfTest(4);
  for (const geodesictest::MeshKind& kind : geodesictest::meshKinds())
  {
    for (std::uint64_t seed = seeds.first; seed < seeds.end(); ++seed)
    {
      const std::string what = std::string(kind.name) + ", seed " + std::to_string(seed);
      Random random(seed);
      const geodesictest::PlainMesh mesh =
        Cut(kind.make(random.between(20, 80), random), random.uniform(0.1, 0.6), random);
      const auto surface = Mesh(mesh.points, mesh.triangles);
      const geodesictest::Index face = random.below(mesh.triangles.size());
      const vtkIdType a = mesh.triangles[face][0];
      const vtkIdType b = mesh.triangles[face][1];
      const auto fromVertex = geodesictest::bruteForceDistances(
        mesh, { { geodesictest::vertexPoint(mesh, mesh.triangles[face][0]) }, {} });
      const auto vertex = Named(surface, { a });
      CheckField(check, surface, vertex, fromVertex.vertices, what + ", a vertex");
      CheckMatrixAndPaths(check, surface, vertex, fromVertex.vertices, what);

      auto edge = Named(surface, { a, b });
      edge->SetLines(CellArray({ { 0, 1 } }));
      const auto fromEdge = geodesictest::bruteForceDistances(
        mesh, { {}, { { face, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } } } });
      CheckField(check, surface, edge, fromEdge.vertices, what + ", an edge");
    }
  }
}

//------------------------------------------------------------------------------
/// Two squares side by side, apart along x = 1 or joined at the lower end of that seam. Points 1
/// and 4 (there one point), 2 and 7 are at one place.
vtkSmartPointer<vtkPolyData> TwoSquares(bool areJoined)
{
  const vtkIdType lower = areJoined ? 1 : 4;
  auto surface = Mesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 1, 0, 0 },
                        { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 } },
    { { 0, 1, 2, 3 }, { lower, 5, 6, 7 } });
  return surface;
}

void CheckTwoSquares(Check& check)
{
  for (const bool areJoined : { false, true })
  {
    const std::string what = areJoined ? "squares joined at a corner" : "squares apart";
    const auto surface = TwoSquares(areJoined);
    const double around = areJoined ? 2.0 : Infinite;
    for (const int dataType : { VTK_DOUBLE, VTK_FLOAT })
    {
      const auto matrix =
        FilterOn<vtkGeodesicDistanceMatrix>(surface, Named(surface, { 2, 7 }, dataType));
      matrix->MergeCoincidentPointsOff();
      matrix->Update();
      const std::array<double, 4> expected = { 0.0, around, around, 0.0 };
      for (vtkIdType i = 0; i < 4; ++i)
      {
        check.Equal(matrix->GetOutput()->GetValue(i / 2, 1 + i % 2).ToDouble(),
          expected[static_cast<std::size_t>(i)], what + ": matrix");
      }
    }
    // From the right square.
    const double root = std::sqrt(2.0);
    const double far = areJoined ? 2.0 : Infinite;
    CheckField(check, surface, Named(surface, { 7 }),
      { far, areJoined ? 1.0 : Infinite, around, areJoined ? 1.0 + root : Infinite,
        areJoined ? Infinite : 1.0, root, 1.0, 0.0 },
      what);
    // A line from one to the other at one place leads around.
    auto line = Named(surface, { 2, 7 });
    line->SetLines(CellArray({ { 0, 1 } }));
    const auto filter = PlainField(surface, line);
    filter->MergeCoincidentPointsOff();
    Messages messages(filter);
    messages.Update();
    check.That(
      areJoined ? Distances(filter)->GetTuple1(1) == 0.0 : Contains(messages.Error(), "component"),
      what + ": a line between two points at one place");
  }
}

/// Numbers that do not fit are ignored, as are those of several blocks and where points are merged.
void CheckIgnored(Check& check)
{
  const auto surface = TwoSquares(false);
  const auto distancesFrom = [&](vtkDataObject* input, vtkIdType id, bool isMerged)
  {
    auto source = PointSources({ { 1, 1, 0 } });
    Name(source, { id });
    const auto matrix = FilterOn<vtkGeodesicDistanceMatrix>(input, source);
    matrix->SetMergeCoincidentPoints(isMerged);
    matrix->SetTargetsData(PointSources({ { 0, 0, 0 }, { 2, 0, 0 } }));
    Messages messages(matrix);
    messages.Update();
    check.That(messages.Error().empty(), messages.Error());
    return std::pair(matrix->GetOutput()->GetValue(0, 1).ToDouble(),
      matrix->GetOutput()->GetValue(1, 1).ToDouble());
  };
  const double root = std::sqrt(2.0);
  const auto holds = [&check](const std::pair<double, double>& found,
                       const std::pair<double, double>& expected, const std::string& what)
  {
    check.Near(found.first, expected.first, 1e-10, what);
    check.Near(found.second, expected.second, 1e-10, what);
  };
  const std::pair<double, double> left = { root, Infinite };
  for (const vtkIdType id :
    { vtkIdType(8), vtkIdType(-1), vtkIdType(6), vtkIdType(4), vtkIdType(1) << 40U, vtkIdType(2) })
  {
    holds(distancesFrom(surface, id, false), left, "the first point at the place");
  }
  holds(distancesFrom(surface, 7, false), { Infinite, root }, "the point that it is");
  holds(distancesFrom(surface, 7, true), { root, root }, "points are merged");
  const auto blocks = Blocks({ surface });
  const auto far = Moved(Square(1), MovedBy(0.0, 0.0, 5.0));
  blocks->SetBlock(1, far);
  holds(distancesFrom(blocks, 7, false), left, "several blocks");
}

/// Lines meet at a point of the surface, not at a place where the seam has two.
void CheckLines(Check& check)
{
  const auto surface = TwoSquares(true);
  auto lines = Named(surface, { 3, 2, 7, 6, 5 });
  lines->SetLines(CellArray({ { 0, 1 }, { 2, 3 }, { 3, 4 } }));
  const auto filter = PlainField(surface, lines);
  filter->MergeCoincidentPointsOff();
  filter->Update();
  check.Equal(
    OutputOf(filter, 1)->GetNumberOfLines(), 2.0, "lines that end on both sides of a seam");
}

}

int TestGeodesicKeptSeams(int, char*[])
{
  Check check;
  CheckTwoSquares(check);
  CheckIgnored(check);
  CheckLines(check);
  CheckRandomSeams(check);
  return check.Result();
}
