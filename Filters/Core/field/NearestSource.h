// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_NearestSource_h
#define geodesic_NearestSource_h

#include "field/LastPiece.h"
#include "source/CurveChains.h"
#include "source/CurveSectors.h"
#include "source/SourceCurve.h"
#include "source/VerticesOnCurves.h"

#include <utility>
#include <vector>

namespace geodesic
{

/// Where on the source a shortest path ends, and from which side of the curve it comes.
struct Foot
{
  /// Number of the curve among those of the field; NoId where a point was not reached.
  Id curve = NoId;
  /// Whether the path comes from the curve's right-hand side, seen with the normals of the faces
  /// towards the viewer and along the curve. At an open end the sides part behind the curve. A
  /// point has a left-hand side only; on the curve it is either.
  bool isRight = false;
  /// The chain that the curve is in, and where along it, as the length from the chain's beginning.
  Id chain = NoId;
  double place = 0.0;

  bool isKnown() const { return this->curve != NoId; }
};

/// Which of the sources is nearest, for any point whose distance is known: windows know what they
/// come from, and what comes from a pseudo-source has the pseudo-source's own foot. Where several
/// shortest paths tie it is that of one of them.
///
/// Takes 16 bytes a vertex.
class NearestSource
{
public:
  /// \param field an exact one, with arrivals (FrontOptions::keepArrivals); must outlive this.
  /// \param curves those that the field was solved for.
  /// \param progress called now and then; returning false throws Aborted.
  NearestSource(const DistanceField& field, const std::vector<SourceCurve>& curves,
    const ProgressCallback& progress = {});

  /// The foot of the shortest path to a vertex.
  Foot atVertex(Id vertex) const { return this->footOf(this->origins_[vertex]); }
  /// That of a path that ends with a piece: lastPieceTo() of the same field.
  Foot of(const LastPiece& piece);

  /// A foot's place on the surface.
  SurfacePoint pointOf(const Foot& foot) const;

private:
  void findBesideVertices(const LoopProgress& progress);
  void findOthers(const LoopProgress& progress);
  LastPiece originTo(Id vertex) const;
  void follow(Id vertex);
  bool isFromCurve(const LastPiece& piece) const;
  CurveOrigin originOf(const LastPiece& piece);
  CurveOrigin atSource(const LastPiece& piece);
  void goToVertex(Id vertex);
  void goToPoint(Id curve, std::size_t i);
  Foot footOf(const CurveOrigin& origin) const;

  const DistanceField& field_;
  const TriangleMesh& mesh_;
  /// The curves, whose numbers windows have.
  CurveChains chains_;
  VerticesOnCurves onCurves_;
  /// Those of each vertex.
  std::vector<CurveOrigin> origins_;
  /// Around the curve's point that was asked for last.
  CurveSectors sectors_;
  Id sectorsVertex_ = NoId;
};

}

#endif
