// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_TestMeshes_h
#define geodesictest_TestMeshes_h

#include <array>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

/// Data and meshes that tests share. No header of this namespace includes the engine, so the truth
/// has no code in common with it.
namespace geodesictest
{

using Index = std::uint32_t;
using Vec2 = std::array<double, 2>;
using Vec3 = std::array<double, 3>;
using Triangle = std::array<Index, 3>;
using Barycentric = std::array<double, 3>;

struct PlainMesh
{
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
};

/// A point of a mesh: a face and barycentric coordinates of its corners. Exact zeros put it onto an
/// edge or a vertex.
struct MeshPoint
{
  Index face = 0;
  Barycentric weights = { 1.0, 0.0, 0.0 };
};

/// A straight segment inside one closed face.
struct MeshSegment
{
  Index face = 0;
  Barycentric from = { 1.0, 0.0, 0.0 };
  Barycentric to = { 0.0, 1.0, 0.0 };
};

Vec3 position(const PlainMesh& mesh, const MeshPoint& point);
double spaceDistance(const Vec3& a, const Vec3& b);

/// Random numbers, the same on every platform for a seed.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : engine_(seed)
  {
  }

  /// Uniform in [0, 1).
  double uniform();
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * this->uniform(); }
  /// Uniform in 0 ... count - 1.
  Index below(std::size_t count);
  /// Uniform in low ... high, both included.
  Index between(Index low, Index high) { return low + this->below(high - low + 1); }
  bool chance(double probability) { return this->uniform() < probability; }

private:
  std::mt19937_64 engine_;
};

/// \name Points on a mesh
///@{
MeshPoint randomFacePoint(const PlainMesh& mesh, Random& random);
MeshPoint randomEdgePoint(const PlainMesh& mesh, Random& random);
MeshPoint randomVertexPoint(const PlainMesh& mesh, Random& random);
/// A point in a face, on an edge or at a vertex, or within rounding of an edge or a vertex.
MeshPoint randomPoint(const PlainMesh& mesh, Random& random);
/// A random point of one closed face: inside, on an edge or at a corner.
Barycentric randomWeights(Random& random);
/// A vertex as a point of one of its faces; there must be one.
MeshPoint vertexPoint(const PlainMesh& mesh, Index vertex);
///@}

/// \name Surfaces
/// Grids have cells of unit size unless told otherwise; random ones depend on their Random alone.
///@{
/// Moves all points at random, by up to the noise along each axis.
void addNoise(PlainMesh& mesh, double noise, Random& random);
/// A flat grid of nx x ny squares, each cut along the same diagonal: distances tie exactly.
PlainMesh regularGrid(Index nx, Index ny);
/// A random triangulation of the rectangle [0, nx] x [0, ny]: jittered vertices, random diagonals,
/// random edge flips.
PlainMesh randomPlanar(Index nx, Index ny, Random& random);
/// An L: the grid without its upper right quarter; nx and ny are even.
PlainMesh lShape(Index nx, Index ny);
/// The random rectangle with about `holes` polygonal holes, where blocks of cells are removed.
PlainMesh planarWithHoles(Index nx, Index ny, Index holes, Random& random);
/// planarWithHoles with random heights in [-amplitude, amplitude].
PlainMesh bumpySheet(Index nx, Index ny, Index holes, double amplitude, Random& random);
/// A bumpy sheet stretched by aspect along one axis.
PlainMesh needleSheet(Index nx, Index ny, double aspect, double amplitude, Random& random);
/// A sphere from an octahedron whose edges are cut in n; symmetric bit by bit.
PlainMesh octasphere(Index n);
/// Pages of n x m bumpy cells on one spine of n edges; page p holds faces 2 p n m ... With
/// amplitude 0 the pages are flat rectangles [0, m] x [0, n].
PlainMesh book(Index pages, Index n, Index m, double amplitude, Random& random);
/// A band of n x m cells with one half twist, not orientable.
PlainMesh moebius(Index n, Index m);
/// The surface of the box [0, size] with n[k] cells along axis k.
PlainMesh box(const Vec3& size, const std::array<Index, 3>& n);
/// A prism's side: `sides` x rows cells on a regular polygon of edge length 1, open at both ends.
PlainMesh openCylinder(Index sides, Index rows, double height);
/// Rows x sides cells around a tube of radius 1 whose centre line is a circle of radius `ratio`.
PlainMesh torus(Index sides, Index rows, double ratio);
/// A cone over a regular polygon of edge length 1, open below, with triangles around its apex.
PlainMesh roundCone(Index sides, Index rows, double height);
/// `sectors` isosceles triangles with this angle and legs of length 1 around an apex, each cut into
/// n x n faces. The apex is vertex 0, sector s holds faces s n^2 ... (s + 1) n^2 - 1. A total angle
/// over 2 pi gives a saddle fan (an even number of sectors is needed), under it a cone.
PlainMesh fan(Index sectors, double angle, Index n);
/// A regular tetrahedron of edge length 1, each face cut into n x n; face k of the tetrahedron (the
/// one opposite to its vertex k) holds faces k n^2 ... (k + 1) n^2 - 1.
PlainMesh tetrahedron(Index n);
/// The corners of tetrahedron().
std::array<Vec3, 4> tetrahedronCorners();
///@}

/// \name Changes
///@{
/// Both meshes side by side, nothing joined.
PlainMesh merged(const PlainMesh& a, const PlainMesh& b);
/// Both meshes joined at only one vertex, to which b is moved: a bow-tie.
PlainMesh joinedAtVertex(const PlainMesh& a, Index vertexOfA, const PlainMesh& b, Index vertexOfB);
/// New numbers for vertices and faces, and another first corner for each face. Old vertex i becomes
/// vertexMap[i], old face f becomes faceMap[f], and its corner k becomes (k + cornerShift[f]) % 3.
struct Renumbered
{
  PlainMesh mesh;
  std::vector<Index> vertexMap;
  std::vector<Index> faceMap;
  std::vector<Index> cornerShift;
};
Renumbered renumbered(const PlainMesh& mesh, Random& random);
/// Flips the orientation of a random half of the faces (swaps corners 1 and 2; `flipped` marks
/// them).
PlainMesh withFlippedFaces(
  const PlainMesh& mesh, Random& random, std::vector<bool>* flipped = nullptr);
/// Splits some faces at their centroids; old vertices keep their numbers.
PlainMesh withSplitFaces(const PlainMesh& mesh, double fraction, Random& random);
/// Splits some edges at their midpoints, in all faces around; old vertices keep their numbers.
PlainMesh withSplitEdges(const PlainMesh& mesh, double fraction, Random& random);
/// Splits each face in four, on the same surface.
PlainMesh subdivided(const PlainMesh& mesh);
PlainMesh scaled(const PlainMesh& mesh, double factor);
/// A random rotation and a shift by about the mesh's size.
PlainMesh moved(const PlainMesh& mesh, Random& random);
/// Removes vertices that no face uses.
PlainMesh compacted(const PlainMesh& mesh);
///@}

/// Edges with one face, as pairs of vertices.
std::vector<std::pair<Index, Index>> boundaryEdges(const PlainMesh& mesh);

/// The inner vertices whose total angle exceeds 2 pi by more than rounding.
std::size_t countSaddles(const PlainMesh& mesh);

}

#endif
