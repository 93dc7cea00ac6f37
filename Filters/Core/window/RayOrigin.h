// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RayOrigin_h
#define geodesic_RayOrigin_h

#include "Errors.h"
#include "Types.h"

namespace geodesic
{

/// Where the rays of a window start, in 32 bits: at a vertex, which is a pseudo-source, on a side
/// of a curve, or at a point of a curve on one of the curve's sides. Left and right are as seen
/// along the curve by a viewer towards whom the normal of the segment's face points.
///
/// An origin on a curve also knows whether the frame of the window's halfedge is mirrored, so that
/// left is right there and angles around the point grow clockwise.
class RayOrigin
{
public:
  /// How many curves, and how many points of curves, can be numbered.
  static constexpr Id MaximumOnCurves = Id(1) << 28;

  /// No origin.
  constexpr RayOrigin() = default;
  /// \param id below MaximumVertices.
  static constexpr RayOrigin vertex(GlobalId id) { return RayOrigin(static_cast<Id>(id)); }
  static RayOrigin curveSide(Id curve, bool isRight)
  {
    return RayOrigin(OnCurve | packed(curve, isRight, false));
  }
  /// \param point number among those of all curves (CurveChains::pointAt()).
  static RayOrigin pointSide(Id point, bool isRight, bool isMirrored = false)
  {
    return RayOrigin(OnCurve | AtPoint | packed(point, isRight, isMirrored));
  }

  bool isKnown() const { return this->bits_ != MaximumVertices; }
  bool isVertex() const { return this->bits_ < MaximumVertices; }
  /// Whether it is a side of a curve or of a curve's point.
  bool isOnCurve() const { return (this->bits_ & OnCurve) != 0; }
  bool isPoint() const { return (this->bits_ & (OnCurve | AtPoint)) == (OnCurve | AtPoint); }

  GlobalId vertex() const { return GlobalId{ this->bits_ }; }
  Id curve() const { return this->number(); }
  Id point() const { return this->number(); }
  bool isRight() const { return (this->bits_ & Right) != 0; }
  bool isMirrored() const { return (this->bits_ & Mirrored) != 0; }

  /// The same origin for a halfedge that runs the other way, whose frame is a mirror image.
  RayOrigin mirrored() const
  {
    return RayOrigin(this->isOnCurve() ? this->bits_ ^ Mirrored : this->bits_);
  }

  /// A length across the rays, to the right in the frame of the window's halfedge, as a length
  /// along the curve.
  double alongCurve(double toTheRight) const
  {
    return this->isRight() == this->isMirrored() ? toTheRight : -toTheRight;
  }
  /// A turn, counterclockwise in the frame of the window's halfedge, as an angle around the curve's
  /// point.
  double aroundPoint(double turn) const { return this->isMirrored() ? -turn : turn; }

  bool operator==(RayOrigin other) const { return this->bits_ == other.bits_; }
  bool operator!=(RayOrigin other) const { return this->bits_ != other.bits_; }

private:
  // Vertices have the numbers below MaximumVertices, the largest number of 31 bits, which says that
  // there is no origin. The others: two bits for the kind, 28 for the number, two for the flags.
  static constexpr Id OnCurve = Id(1) << 31;
  static constexpr Id AtPoint = Id(1) << 30;
  static constexpr Id Right = 2;
  static constexpr Id Mirrored = 1;

  explicit constexpr RayOrigin(Id bits)
    : bits_(bits)
  {
  }

  /// \throws SourceError
  static Id packed(Id number, bool isRight, bool isMirrored)
  {
    if (number >= MaximumOnCurves)
    {
      throw SourceError("The source has too many points. Use one of at most " +
        std::to_string(MaximumOnCurves) + " points, as it lies on the surface.");
    }
    return number << 2 | (isRight ? Right : 0) | (isMirrored ? Mirrored : 0);
  }
  Id number() const { return this->bits_ >> 2 & (MaximumOnCurves - 1); }

  Id bits_ = MaximumVertices;
};

static_assert(sizeof(RayOrigin) == sizeof(Id), "windows store it");

/// Where at its RayOrigin a ray starts: a number whose meaning depends on the kind of the origin.
class RayStart
{
public:
  RayStart() = default;
  /// On a side of a curve: the parameter, a length along the curve from its beginning.
  static RayStart atParameter(double parameter) { return RayStart(parameter); }
  /// At a point of a curve: an angle around the point (FanAround::angleOf()).
  static RayStart atAngle(double angle) { return RayStart(angle); }

  double parameter() const { return this->number_; }
  double angle() const { return this->number_; }

private:
  explicit RayStart(double number)
    : number_(number)
  {
  }

  double number_ = 0.0;
};

}

#endif
