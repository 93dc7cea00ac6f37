// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Tolerance_h
#define geodesic_Tolerance_h

#include <limits>

/// Every tolerance of the engine. All are relative; each says to what, and why it has its size.
namespace geodesic::tolerance
{

/// Rounding of one operation in double precision.
constexpr double Rounding = std::numeric_limits<double>::epsilon();

/// A face has zero area when twice its area is below this fraction of its longest halfedge squared:
/// the cross product of collinear corners leaves a few roundings. A corner over that edge is put
/// onto it.
constexpr double ZeroArea = 8.0 * Rounding;

/// A vertex whose total angle is over the straight angle by less than this fraction is flat: the
/// sum of a fan's angles leaves some roundings, and a gap of this angle behind it moves no distance
/// by more than this fraction.
constexpr double FlatAngle = 1e-13;

/// A window narrower than this fraction of its halfedge is not kept: its ends cannot be told apart
/// after rounding, and a gap of this width moves no distance by more than itself.
constexpr double LeastWidth = 4.0 * Rounding;

/// A window is dropped for a path through a vertex only when it is longer by this fraction:
/// distances carry the rounding of every unfolding on their way, and a tie must stay.
constexpr double Tie = 1e-12;

/// Distances of two windows that differ by no more than this fraction are equal where they would
/// be cut against each other: both carry the rounding of a sum and a root.
constexpr double Evaluation = 8.0 * Rounding;

/// Neighbouring windows whose sources differ by no more than this fraction of the source's distance
/// are one: a pencil that a vertex in a flat part of the surface has split goes on in two, which
/// some unfoldings around the vertex, each of a few roundings, bring to one source again.
constexpr double SameSource = 64.0 * Rounding;

/// A curve's point belongs to a vertex or an edge when nearer than this many roundings of the
/// largest coordinate around. A filter that cuts the surface interpolates along an edge and rounds
/// each coordinate once: sqrt(3)/2 of a rounding in space. The surface's own points may have been
/// rounded by an earlier transform, and the filter's arithmetic adds about as much again.
constexpr double SnapRoundings = 4.0;

/// But never farther than this fraction of an edge (towards a vertex) or of an altitude (towards an
/// edge): far from the origin roundings may be as large as faces, and a curve must not collapse
/// there.
constexpr double SnapFraction = 0.1;

/// Points on the boundaries of two parts of a surface are one when nearer than this many roundings
/// of the largest coordinate around: each part has computed or stored the same place on its own,
/// with a few roundings.
constexpr double SeamRoundings = 4.0;

/// But never farther than this fraction of an edge of the boundary at either: far from the origin
/// roundings may be as large as faces, and an edge must not collapse there.
constexpr double SeamFraction = 0.1;

/// A traced path passes a vertex, not an edge beside it, when nearer than this fraction of its
/// length: the rounding of unfolding it through some dozens of faces.
constexpr double PathAtVertex = 64.0 * Rounding;

/// A traced path is straight in the unfolding, and its length right to a fraction Tie: it comes to
/// its end, or beside it by no more than this fraction of its length, about the root of that.
constexpr double BesideEnd = 1e-6;

/// A traced path may be longer than the distance by this fraction, a tie: the points at its edges
/// are each rounded. In needles what unfolding rounds may be more: such a path is found in windows.
constexpr double TracedLength = 1e-12;

/// Lengths between two places in a face are rounded to this fraction of its longest edge: places
/// are kept as barycentric coordinates.
constexpr double PlaceRounding = 16.0 * Rounding;

/// An upper bound of a distance, summed along mesh edges, is raised by this fraction, so that the
/// rounding of millions of terms cannot put it below the distance.
constexpr double BoundMargin = 1e-9;

/// A source is taken to lie at least this fraction of a halfedge's length below the halfedge it
/// shines through: in a face without area its rays would otherwise have no direction. Moves it by
/// rounding.
constexpr double SourceDepth = 8.0 * Rounding;

/// A vertex nearer to a source's point than this fraction of a face emits as a pseudo-source.
/// Windows of the point have ends rounded to a fraction Rounding of a halfedge, so that as seen
/// from the vertex gaps of an angle Rounding / NearVertex may open between them; the vertex covers
/// these.
constexpr double NearVertex = 1e-5;

/// A merged window's source lies at least this fraction of its width below the halfedge: the
/// directions of its rays are told from sourceDepth, and near the halfedge rounding would turn
/// them.
constexpr double MergedDepth = 1e-6;

/// An edge shorter than this fraction of another one of its face sees rays pass from where that one
/// ends: places rounded along the longer one would turn them by an angle of Rounding / ShortEdge.
/// The vertices at its ends emit, as rays from one past the other have no better direction.
constexpr double ShortEdge = 1e-6;

/// A source's point is near a halfedge when nearer than this fraction of its length. The ends of
/// windows on the halfedge are rounded to a fraction Rounding of it, which seen from the point is
/// an angle of Rounding / NearEdge: from nearer its rays are sent through the face behind in one
/// step.
constexpr double NearEdge = 1e-6;

/// In one face, distances from its windows are compared up to this fraction: each is a tie off, and
/// a few are added up.
constexpr double FaceRounding = 8.0 * Tie;

/// A window's part of a segment in a face is taken longer by this fraction of the segment at both
/// ends: rays of neighbours that meet in one point are cut with it separately, and rounding would
/// leave gaps. Narrower parts are left to their neighbours. Moves no distance by more than about
/// itself.
constexpr double PencilMargin = 1e-12;

/// Neighbours in an envelope along a segment may differ by this fraction of its length where they
/// meet, and so may an envelope and the distance; more tells of a gap. Well over PencilMargin, as a
/// joint's place carries the rounding of the crossing that was solved for it.
constexpr double JointFraction = 1e-9;

/// An isoline is drawn where the distance is smaller than its value by this fraction: so vertices
/// at exactly the value, which carry the rounding of every unfolding on their way, are all beyond
/// the line, and it passes on one side of them.
constexpr double BelowValue = 1e-13;

/// A point of an isoline on an edge is at a vertex when nearer than this fraction of the value and
/// the edge: so the points of all edges around a vertex at exactly the value are one place.
constexpr double IsolineAtVertex = 4.0 * BelowValue;

/// Inside a face the curves on which two ways have one length may coincide. Each further one is
/// drawn for a value that is smaller by this fraction of the value and the face, a few roundings of
/// evaluating a distance, so that which of them is in front is not left to rounding.
constexpr double CurveOffset = 8.0 * Rounding;

/// The same where that is just what the curves are apart.
constexpr double LargerCurveOffset = 40.0 * CurveOffset;

/// Two ends of an isoline's pieces in a face are one when nearer than this fraction of the face, or
/// when between them the distance is the value up to IsolineValue: where curves or edges are
/// tangent, the place where they meet is known only to the root of the rounding.
constexpr double IsolineGap = 1e-9;

/// How much the distance may differ from the value between such ends, as a fraction of the value
/// and the face: the rounding of every unfolding on the way.
constexpr double IsolineValue = Tie;

/// Rays that meet their halfedge at a smaller angle (about the root of the rounding) run along it:
/// the cosine of such an angle is 1 to the last digit, so that rounding alone would tell where they
/// go.
constexpr double GrazingAngle = 1e-8;

}

#endif
