// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Tolerance_h
#define geodesic_Tolerance_h

#include <cfloat>
#include <limits>

#if defined(__FAST_MATH__) || defined(_M_FP_FAST)
#error                                                                                             \
  "Compile without fast math, which changes roundings (see Filters/Package/FloatingPoint.cmake)"
#endif

/// All tolerances of the engine. Each is relative; its comment says to what, and gives the reason
/// for the size.
namespace geodesic::tolerance
{

/// Rounding of one operation in double precision.
constexpr double Rounding = std::numeric_limits<double>::epsilon();
static_assert(FLT_EVAL_METHOD >= 0 && FLT_EVAL_METHOD != 2,
  "Operations on double are not rounded to double: on 32-bit x86 compile with -msse2 -mfpmath=sse");

/// A face is without area if its height over its longest edge is below this fraction h of the edge.
/// The place where a ray of the corner there crosses the edge is rounded to a fraction Rounding of
/// the edge, and so turns the ray by Rounding / h: a path behind the edge may be longer by the
/// square of that. With h at 1e-13, some distances were wrong by 1e-3, at 5e-12 by at most 5e-9, a
/// few in 10,000. To cut the faces at the edge moves the surface by no more than h.
constexpr double WithoutArea = 5e-12;

/// A face without area that conducts by itself gets this height, as a fraction of its shortest
/// edge. A path from its longest edge to the corner over it becomes longer by as much, of the order
/// of rounding. No path goes on behind that corner, so that rays need not keep their directions
/// there (see WithoutArea).
constexpr double RaisedHeight = 1e-12;

/// A face is thin if one of its altitudes is below this fraction of its edge: many times longer
/// than high, as scans have hardly any face. From there on windows come again and again to the
/// halfedges of its vertices.
constexpr double ThinFace = 1.0 / 32.0;

/// A vertex is flat if its total angle exceeds the straight angle by less than this fraction: the
/// sum of a fan's angles leaves some roundings, and a gap of this angle behind the vertex changes
/// no distance by more than this fraction.
constexpr double FlatAngle = 1e-13;

/// A window narrower than this fraction of its halfedge is dropped: rounding makes its ends equal,
/// and a gap of this width changes no distance by more than the width.
constexpr double LeastWidth = 4.0 * Rounding;

/// A path through a vertex beats a window only if the window is longer by this fraction: distances
/// carry the rounding of every unfolding on their way, and a tie must stay.
constexpr double Tie = 1e-12;

/// A vertex emits again, from the way that its distance then has, if the distance becomes shorter
/// by this fraction: some unfoldings with a few roundings each lead the same way there. Ways that
/// differ by a tie are many times farther apart in direction, by the root of the tie, and a shadow
/// that starts at the wrong one would leave a gap, in which paths bend.
constexpr double SameEmission = 64.0 * Rounding;

/// Of two ways to one place, within a tie, rounding alone tells which is shorter if their lengths
/// differ by no more than this fraction: each is a sum.
constexpr double SameLength = 2.0 * Rounding;

/// Where two windows are cut against each other, and of two straight ways to a vertex, distances
/// that differ by no more than this fraction are equal: both carry the rounding of a sum and a
/// root.
constexpr double Evaluation = 8.0 * Rounding;

/// Neighbouring windows are one if their sources differ by no more than this fraction of the
/// source's distance. A vertex in a flat part of the surface splits a pencil in two; some
/// unfoldings around the vertex, each with a few roundings, lead both parts back to one source.
constexpr double SameSource = 64.0 * Rounding;

/// A curve's point belongs to a vertex or an edge if it is nearer than this many roundings of the
/// largest coordinate around. A filter that cuts the surface interpolates along an edge and rounds
/// each coordinate once: sqrt(3)/2 of a rounding in space. An earlier transform may have rounded
/// the surface's own points, and the filter's arithmetic adds about as much again.
constexpr double SnapRoundings = 4.0;

/// The limit of SnapRoundings, as a fraction of an edge (towards a vertex) or of an altitude
/// (towards an edge): far from the origin roundings may be as large as faces, and a curve must not
/// collapse there.
constexpr double SnapFraction = 0.1;

/// A curve's point between two walls may go to the farther one if that is no more than this many
/// times as far as the nearer one: so it lies in the middle half of the gap, and noise of the curve
/// up to three quarters of a wall's thickness is recognised. A point that is meant for the nearer
/// wall is much nearer to it.
constexpr double AboutAsNear = 3.0;

/// Two faces are about parallel, whichever way they are oriented, if the cosine between their
/// normals is at least this; and two directions are about opposite if it is at most minus this.
/// That is 60 degrees: bent and tapering walls are within it, the two sides of a square edge are
/// not.
constexpr double AboutParallel = 0.5;

/// Two places are on different sides of a wall if one lies off the other's side by more than this
/// fraction of the wall's thickness: places on one side do by little, on both by all of it.
constexpr double OtherSide = 0.5;

/// A segment put onto the surface that is longer than this many times the straight distance between
/// its ends is a detour, which a curve on one side of a body hardly makes: half around a sphere it
/// is 1.6 times.
constexpr double Detour = 3.0;

/// Segments of curves in one face lie on each other if they are nearer than this fraction of its
/// longest edge. Shortest paths there and back are traced separately and differ by a tie, which
/// moves places along edges by up to its root, but mostly by some roundings. Curves that are meant
/// to lie beside each other are farther apart.
constexpr double OnEachOther = 1e-9;

/// Points on the boundary of a surface, or of its pieces, are one if they are nearer than this many
/// roundings of the largest coordinate around: each has been computed or stored separately for the
/// same place, with a few roundings.
constexpr double SeamRoundings = 4.0;

/// The limit of SeamRoundings, as a fraction of the edges at either point: far from the origin
/// roundings may be as large as faces, and an edge must not collapse there.
constexpr double SeamFraction = 0.1;

/// The limit of a length that the user gives for joining points of the boundary, as a fraction of
/// the edges at either point. At most half of an edge: points nearer than that to one point are no
/// two ends of an edge, nor two ends of a row of edges, which would be folded.
constexpr double MergeFraction = 0.5;

/// Edges of the boundary that lie beside each other, nearer than this fraction of the surface's
/// diagonal, look like a crack: formats with six or seven digits leave such gaps, and nobody makes
/// them on purpose.
constexpr double CrackWidth = 1e-6;

/// The limit of CrackWidth, as a fraction of the edge: the next edge of the boundary comes as near
/// around a corner.
constexpr double CrackFraction = 0.1;

/// A traced path that comes nearer to a vertex than this fraction of its length passes through the
/// vertex, not an edge beside it: such is the rounding of unfolding it through some dozens of
/// faces.
constexpr double PathAtVertex = 64.0 * Rounding;

/// A traced path is straight in the unfolding, and its length is right to a fraction Tie. It
/// reaches its end, or passes it at no more than this fraction of its length, about the root of
/// Tie.
constexpr double BesideEnd = 1e-6;

/// A traced path may be longer than the distance by this fraction, a tie: each of its points at
/// edges is rounded. In needles unfolding may round more; such a path is found in windows instead.
constexpr double TracedLength = 1e-12;

/// The relative error of the fronts that find the strip of faces around a path between two points.
/// The strip is as wide as the root of the error: with a smaller error these fronts take longer,
/// with a larger one the exact search in the strip does.
constexpr double CorridorSearch = 1e-3;

/// Lengths between two places in a face are rounded to this fraction of its longest edge: places
/// are stored as barycentric coordinates.
constexpr double PlaceRounding = 16.0 * Rounding;

/// The place of a point of a face in space is rounded to this many roundings of the largest
/// coordinate, in each coordinate: it is the sum of a corner and two fractions of edges.
constexpr double PositionRoundings = 4.0;

/// An upper bound of a distance, summed along mesh edges, is raised by this fraction, so that the
/// rounding of millions of terms cannot put it below the distance.
constexpr double BoundMargin = 1e-9;

/// A source lies at least this fraction of a halfedge's length below the halfedge through which its
/// rays enter: the rays of a nearer one would have no direction. This moves the source by rounding.
constexpr double SourceDepth = 8.0 * Rounding;

/// A vertex nearer to a source's point than this fraction of a face emits as a pseudo-source. The
/// ends of the point's windows are rounded to a fraction Rounding of a halfedge, so gaps of an
/// angle Rounding / NearVertex, as seen from the vertex, may open between them. The vertex covers
/// these gaps.
constexpr double NearVertex = 1e-5;

/// A merged window's source lies at least this fraction of its width below the halfedge:
/// sourceDepth determines the directions of its rays, and near the halfedge rounding would turn
/// them.
constexpr double MergedDepth = 1e-6;

/// An edge is short if it is below this fraction of another edge of its face. Rays pass the place
/// where the longer edge ends, and places rounded along the longer edge would turn rays at the
/// short one by an angle of Rounding / ShortEdge. The vertices at the ends of a short edge emit, as
/// rays from one end past the other end have no better direction.
constexpr double ShortEdge = 1e-6;

/// A source's point is near a halfedge if it is nearer than this fraction of the halfedge's length.
/// The ends of windows on the halfedge are rounded to a fraction Rounding of it, an angle of
/// Rounding / NearEdge as seen from the point. The rays of a nearer point are sent through the face
/// behind the halfedge in one step.
constexpr double NearEdge = 1e-6;

/// Distances from the windows of one face are compared up to this fraction: each is off by a tie,
/// and a few are summed up.
constexpr double FaceRounding = 8.0 * Tie;

/// A window's part of a segment in a face is extended by this fraction of the segment at both ends:
/// adjacent rays of neighbours are cut with the segment separately, and rounding would leave gaps.
/// Narrower parts are left to their neighbours. This changes no distance by more than about the
/// fraction itself.
constexpr double PencilMargin = 1e-12;

/// Neighbours in an envelope along a segment may differ by this fraction of its length where they
/// meet, and so may an envelope and the distance; a larger difference reveals a gap. It is well
/// over PencilMargin, as a joint's place carries the rounding of the crossing that was solved for
/// it.
constexpr double JointFraction = 1e-9;

/// An isoline is drawn where the distance is smaller than its value by this fraction. Vertices at
/// exactly the value, which carry the rounding of every unfolding on their way, then lie beyond the
/// line, and it passes on one side of them.
constexpr double BelowValue = 1e-13;

/// A point of an isoline on an edge is at a vertex if it is nearer than this fraction of the value
/// and the edge: the points of all edges around a vertex at exactly the value are then one place.
constexpr double IsolineAtVertex = 4.0 * BelowValue;

/// The side of a chord of an isoline is asked this fraction of the chord from its ends: at the ends
/// themselves two sides may meet.
constexpr double BesideChordEnd = 1e-6;

/// Inside a face the level curves of two ways of equal length may coincide. Each further curve is
/// drawn for a value that is smaller by this fraction of the value and the face, a few roundings of
/// evaluating a distance, so that rounding does not decide which of them is in front.
constexpr double CurveOffset = 8.0 * Rounding;

/// But where the face is longer than so many values, it counts as long as these: along a very thin
/// strip one would see the offsets in the line, and curves behind others would appear.
constexpr double OffsetFaceInValues = 1e8;

/// CurveOffset for curves that are just that far apart.
constexpr double LargerCurveOffset = 40.0 * CurveOffset;

/// Two ends of an isoline's pieces in a face are one point if they are nearer than this fraction of
/// the face, or if the distance is the value, up to IsolineValue, between the ends: where curves or
/// edges are tangent, their meeting point is known only to the root of the rounding.
constexpr double IsolineGap = 1e-9;

/// Level curves of neighbours may overlap by IsolineGap where they meet, but by no more than this
/// fraction of a curve: in faces that are hardly higher than the gap, curves are as short.
constexpr double CurveEndShare = 1e-3;

/// The largest difference of distance and value between two ends that meet, as a fraction of the
/// value and the face: the rounding of every unfolding on the way.
constexpr double IsolineValue = Tie;

/// The share of a source's face that faces of the surface in it may leave out: the rounding of
/// areas where coordinates have single precision. A face that is only partly in it is larger.
constexpr double CoveredArea = 1e-6;

/// Rays that meet their halfedge at a smaller angle (about the root of the rounding) run along it:
/// the cosine of such an angle is 1 to the last digit, and rounding alone would decide where they
/// go.
constexpr double GrazingAngle = 1e-8;

}

#endif
