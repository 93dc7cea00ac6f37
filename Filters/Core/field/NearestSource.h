// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_NearestSource_h
#define geodesic_NearestSource_h

#include "field/IncomingSegment.h"
#include "mesh/GlobalVertices.h"
#include "mesh/ReplicatedPatch.h"
#include "source/CurveChains.h"
#include "source/CurveSectors.h"
#include "source/DirectionsAround.h"
#include "source/SourceCurve.h"
#include "source/SourceFrame.h"
#include "source/VerticesOnCurves.h"

#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace geodesic
{

class RemoteOrigins;

/// Where on the source a shortest path ends, and from which side of the curve it comes.
struct Foot
{
  /// Number of the curve among those of the field; NoId where a point was not reached.
  Id curve = NoId;
  /// Whether the path comes from the curve's right-hand side, seen along the curve and with the
  /// normal of the face in which it leaves the curve towards the viewer. At an open end the sides
  /// part behind the curve. A point has a left-hand side only; on the curve it is either.
  bool isRight = false;
  /// The chain that the curve is in, and where along it, as the length from the chain's beginning.
  Id chain = NoId;
  double place = 0.0;
  /// If the path leaves a point of the curve: its angle around the point, not scaled
  /// (DirectionsAround::around()). NaN if it leaves a segment at a right angle, infinite if it has
  /// no direction.
  double around = std::numeric_limits<double>::quiet_NaN();

  bool isKnown() const { return this->curve != NoId; }
};

/// Which of the sources is nearest, for any point whose distance is known: windows know what they
/// come from, and what comes from a pseudo-source has the pseudo-source's own foot. Where several
/// shortest paths tie it is that of one of them.
///
/// Where ranks have the surface together, each tells it of the points of the faces that it owns.
///
/// Takes 16 bytes a vertex.
class NearestSource
{
public:
  /// All ranks together find the feet of what comes over their seams; asking is each rank's own
  /// then.
  ///
  /// \param field an exact one, with arrivals (FrontOptions::keepArrivals); must outlive this.
  /// \param patch that the curves lie on; in one process the field's mesh.
  /// \param curves those that the field was solved for.
  /// \param progress called now and then; returning false throws Aborted.
  NearestSource(const DistanceField& field, const ReplicatedPatch& patch,
    const std::vector<SourceCurve>& curves, const ProgressCallback& progress = {});
  ~NearestSource();

  /// What curves and feet are points of: the field's mesh, or that of the patch.
  const TriangleMesh& meshOfCurves() const { return this->patch_.mesh(); }

  /// The foot of the shortest path to a vertex.
  Foot atVertex(Id vertex) const { return this->footOf(this->origins_[vertex]); }
  /// That of a path that ends with a piece: incomingSegmentTo() of the same field.
  Foot of(const IncomingSegment& piece);

  /// A foot's place on the surface, a point of meshOfCurves().
  SurfacePoint pointOf(const Foot& foot) const;

  /// The length along the foot's curve from the curve's first point to pointOf(); 0 for a point.
  double arcLengthOf(const Foot& foot) const;
  /// The same of each point of a curve, with the bits that a foot there has. The last point of a
  /// closed curve has the whole length.
  std::vector<double> arcLengthsOf(Id curve) const;

  /// The direction in which the shortest path leaves the source, as an angle in radians.
  ///
  /// From a source that is a single point, as seen with the face's normal towards the viewer:
  /// - inside a face: counterclockwise from the face's first edge (corner 0 to 1), in (-pi, pi];
  /// - on an edge: the same in the first of the edge's faces in the order of the input, continued
  ///   over the edge by unfolding;
  /// - at a vertex whose faces form one closed fan: the angle around it, scaled so that the total
  ///   is 2 pi, from the edge that leaves the vertex in the first of its faces in the order of the
  ///   input, in (-pi, pi];
  /// - at any other vertex: from the edge where the fan begins, from 0 to its own total, not
  /// scaled;
  ///   several fans follow one another in the order of their first faces.
  ///
  /// From a curve, counterclockwise from its direction: pi / 2 on the left-hand side and -pi / 2 on
  /// the right-hand side of a segment. Around a point of the curve, the forward segment has the
  /// angle 0, the backward one -pi and pi, and each sector between them is scaled to pi; at an end
  /// of the curve the whole angle is scaled to 2 pi. On the boundary, and between different curves
  /// that meet in the point, angles are not scaled, but measured from the nearer segment. A fan
  /// without a segment has the angles of a single point.
  ///
  /// Behind a pseudo-source it is the angle of the path to the pseudo-source. On the source itself
  /// it has no meaning.
  ///
  /// Not thread-safe.
  ///
  /// \throws Error if the field's windows carry no angles (FrontOptions::keepAngles).
  double angleOf(const Foot& foot) const;
  /// Angle 0 of a single point is the frame's x axis: the direction that angleOf() measures from.
  /// Of a curve, the frame is that of its first segment: x along it, y to the left.
  SourceFrame frameOf(Id curve) const;

private:
  void find(const ProgressCallback& progress);
  template <typename Visit>
  void forEachVertex(const LoopProgress& progress, const Visit& visit) const;
  void findBesideVertices(const LoopProgress& progress);
  void findOthers(const LoopProgress& progress);
  IncomingSegment originTo(Id vertex) const;
  void follow(Id vertex);
  bool isFromCurve(const IncomingSegment& piece) const;
  CurveOrigin originOf(const IncomingSegment& piece);
  CurveOrigin atSource(const IncomingSegment& piece);
  CurveOrigin inSector(const IncomingSegment& piece) const;
  CurveOrigin atPoint(const CurveSide& side, double place, double around) const;
  bool isPoint(Id origin) const { return CurveSide::isOne(origin, this->firstPoint_); }
  void goAround(Id point) const;
  CurveOrigin ofVertex(Id globalId) const;
  bool isElsewhere(Id globalId) const;
  const VertexOnCurve* onCurveAt(Id globalId) const;
  void goToVertex(Id vertex);
  void goToPoint(Id curve, std::size_t i);
  Foot footOf(const CurveOrigin& origin) const;

  const DistanceField& field_;
  const TriangleMesh& mesh_;
  ReplicatedPatch patch_;
  /// The curves, whose numbers windows have.
  CurveChains chains_;
  VerticesOnCurves onCurves_;
  /// The first PointSide, by numbers of the whole.
  Id firstPoint_;
  /// Of each vertex, by numbers of the whole. A number that is a vertex's: see RemoteOrigins.
  std::vector<CurveOrigin> origins_;
  GlobalVertices vertices_;
  /// Null in one process.
  std::unique_ptr<RemoteOrigins> elsewhere_;
  /// Around the curve's point that was asked for last.
  CurveSectors sectors_;
  Id sectorsVertex_ = NoId;
  /// Around the point with this number.
  mutable DirectionsAround directions_;
  mutable Id directionsPoint_ = NoId;
};

}

#endif
