// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_RefinementSupport_h
#define geodesictest_RefinementSupport_h

#include "EngineSupport.h"

#include "refinement/AdaptiveRefinement.h"

/// Shared by the tests of refined meshes.
namespace geodesictest
{

geodesic::RefinedMesh refineTo(
  const geodesic::DistanceField& field, double tolerance, std::uint64_t maximumFaces = 0);

/// A result's data at one of its points, without labels: points are the mesh's vertices.
class Points
{
public:
  Points(const geodesic::DistanceField& field, const geodesic::RefinedMesh& refined)
    : field_(field)
    , refined_(refined)
  {
  }

  geodesic::SurfacePoint place(geodesic::Id point) const
  {
    return this->isNew(point) ? this->newPoint(point).place
                              : geodesic::SurfacePoint::atVertex(point);
  }
  double distance(geodesic::Id point) const
  {
    return this->isNew(point) ? this->newPoint(point).distance
                              : this->field_.vertexDistances()[point];
  }
  Vec3 position(geodesic::Id point) const
  {
    return this->isNew(point) ? this->newPoint(point).position : this->field_.mesh().point(point);
  }
  Barycentric weights(geodesic::Id point, geodesic::Id face) const
  {
    return barycentric(this->field_.mesh(), this->place(point), face);
  }

private:
  bool isNew(geodesic::Id point) const { return point >= this->refined_.numberOfInputPoints; }
  const geodesic::RefinedPoint& newPoint(geodesic::Id point) const
  {
    return this->refined_.points[point - this->refined_.numberOfInputPoints];
  }

  const geodesic::DistanceField& field_;
  const geodesic::RefinedMesh& refined_;
};

/// Random places of a refined mesh and its interpolant there.
struct Samples
{
  std::vector<MeshPoint> places;
  std::vector<double> interpolant;
};
Samples sample(const geodesic::DistanceField& field, const geodesic::RefinedMesh& refined,
  std::size_t count, Random& random);

/// The distances at points that refinement has added equal the brute-force solver's.
void expectRefinedPointsRight(const geodesic::TriangleMesh& engine,
  const geodesic::RefinedMesh& refined, const PlainMesh& mesh, const Sources& sources,
  double accuracy);

/// Those whose faces are marked.
Samples samplesIn(const Samples& samples, const std::vector<bool>& faces);

/// Whether each face has exact values, by a field with a limit and all windows kept.
std::vector<bool> completeFaces(const geodesic::DistanceField& field);

/// Checks that faces that are neither complete nor beside a complete face are not cut. \returns the
/// number of such faces.
std::size_t expectLeftAsTheyAre(const geodesic::TriangleMesh& mesh,
  const geodesic::RefinedMesh& refined, const std::vector<bool>& complete);

/// Places that both report as unreached are skipped.
double largestDifference(const Samples& samples, const std::vector<double>& truth);

/// The largest difference between interpolant and distance at this many random points of each
/// triangle.
///
/// \param field with all windows kept.
double largestDifferenceInside(const geodesic::DistanceField& field,
  const geodesic::RefinedMesh& refined, int inEachTriangle, Random& random);

/// The fraction of a face that a triangle in it covers; negative where it is turned over.
double determinant(const Barycentric& a, const Barycentric& b, const Barycentric& c);

/// Checks that each face is cut into triangles of its orientation that cover it once.
void expectFacesPartitioned(
  const geodesic::TriangleMesh& mesh, const geodesic::RefinedMesh& refined, const Points& points);

/// Checks that each edge has as many triangles as the input edge that it lies on, or two inside a
/// face, and that the boundary is as long as before.
void expectWatertight(
  const geodesic::TriangleMesh& mesh, const geodesic::RefinedMesh& refined, const Points& points);

/// Both, and new points have earlier parents, lie between them and on the surface, and carry the
/// distance there; none is at the place of another.
///
/// \param field with all windows kept.
void expectSameSurface(const geodesic::DistanceField& field, const geodesic::RefinedMesh& refined);

}

#endif
