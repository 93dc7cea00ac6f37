// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_UnmeshedTriangles_h
#define geodesic_UnmeshedTriangles_h

#include "PolyData/reading/PolyDataSurface.h"
#include "refinement/RefinedMesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace geodesic
{

/// A face of the mesh, of any rank, at an edge of a triangle.
struct FaceAtEdge
{
  static constexpr Id None = 3;

  RankAddress address{ -1, NoId };
  /// Which corner of the triangle each of the face's corners is, or None.
  Triangle corners{ None, None, None };

  bool isThere() const { return this->address.id != NoId; }
  /// Which of its corners is this one of the triangle; None if none is.
  Id find(std::size_t corner) const
  {
    const auto found = std::find(this->corners.begin(), this->corners.end(), corner);
    return static_cast<Id>(found - this->corners.begin());
  }
  /// Which of its edges is the triangle's from corner k to the next.
  Id edge(std::size_t k) const
  {
    const Id i = this->find(k);
    return this->corners[(i + 1) % 3] == (k + 1) % 3 ? i : (i + 2) % 3;
  }
};

/// A part of this rank that is not a face of the mesh.
struct UnmeshedTriangle
{
  Id part;
  /// The face at each edge, from corner k to the next. If there is a face on the same three
  /// vertices, it is the first, and the others are not set.
  std::array<FaceAtEdge, 3> faces{};

  bool isOnFace() const { return this->faces[0].find(FaceAtEdge::None) == FaceAtEdge::None; }
};

/// The parts of a surface that are not faces of its mesh: barriers, segments, copies, and all but
/// one of several parts on the same vertices. The faces at their edges show how to cut them where
/// the mesh is refined.
class UnmeshedTriangles
{
public:
  /// All ranks call this together, and the functions below.
  ///
  /// \param surface must outlive this.
  explicit UnmeshedTriangles(const PolyDataSurface& surface);

  const PolyDataSurface& surface() const { return this->surface_; }
  /// In the order of the parts.
  const std::vector<UnmeshedTriangle>& ofThisRank() const { return this->triangles_; }
  bool areOnAnyRank() const
  {
    return this->surface_.exchange().isTrueAnywhere(!this->triangles_.empty());
  }
  /// How many of them are at each edge of the mesh, for RefinementOptions::trianglesBeside. Each
  /// triangle of any rank counts once at each of its edges. Copies do not count, nor do triangles
  /// that get the parts of a face.
  std::unordered_map<Id, Id> countAtEdges() const;

  /// A vertex that PolyDataSurface::vertexOf() names; this rank alone may ask.
  GlobalVertex vertex(Id number) const
  {
    const Id inMesh = this->surface_.mesh().numberOfVertices();
    return number < inMesh ? this->surface_.vertexOfMesh(number) : this->remote_[number - inMesh];
  }

private:
  void findFaces();
  /// \param vertex of this rank's mesh.
  /// \param ids a triangle's vertices.
  /// \param k the triangle's edge.
  FaceAtEdge faceAround(Id vertex, const GlobalTriangle& ids, std::size_t k) const;

  const PolyDataSurface& surface_;
  std::vector<GlobalVertex> remote_;
  std::vector<UnmeshedTriangle> triangles_;
};

/// Adds the triangles of a surface that are not faces of its mesh.
///
/// The mesh has one of several faces on the same vertices, the surface has all of them: the others
/// get the parts of the first, which any rank may own, so that they still fit to their neighbors.
/// If all ranks together would have more than maximumFaces triangles (0: no limit), they stay
/// whole. Copies by ghost arrays do not count, and always look like their originals.
///
/// Barriers and segments are cut where refinement has split edges of faces there, and are whole
/// elsewhere. No other points are added to them: they have no distances inside.
///
/// All ranks call this together.
///
/// \param cornerPoints those of the refinement.
/// \param vertexDistances of the mesh's vertices, for the surface's cut points.
/// \param refined what refinement made.
/// \returns all triangles of the surface, before it is divided into blocks. Its faces have numbers
///          of the surface's triangles.
RefinedMesh addUnmeshedTriangles(const UnmeshedTriangles& unmeshed, std::uint64_t maximumFaces,
  const std::vector<Triangle>& cornerPoints, const std::vector<double>& vertexDistances,
  RefinedMesh refined);

}

#endif
