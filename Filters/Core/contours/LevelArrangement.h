// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LevelArrangement_h
#define geodesic_LevelArrangement_h

#include "Job.h"
#include "contours/LevelCurves.h"

#include <array>
#include <vector>

namespace geodesic
{

/// A value in a face, and the lengths there that rounding decides about.
struct FaceLevel
{
  /// \param distance must outlive this.
  FaceLevel(const FaceDistance& distance, double value);

  const FaceDistance& face;
  double value;
  std::array<Vec2, 3> corners;
  /// The face's longest edge, and how far apart two ends of lines may be that meet.
  double size;
  double gap;
  /// By how much rounding may change the distance at the value.
  double slack;
};

/// The points that each distance candidate reaches within a value are a region of the face. The
/// isoline is the outline of their union: the parts of the regions' level curves outside all of
/// them, the remainders. Reuses its memory for the next level.
class LevelArrangement
{
public:
  /// What remains of a level curve.
  struct Remainder
  {
    const LevelCurve* curve;
    double begin;
    double end;
  };

  /// \param job looked at for each curve that is cut; must outlive this.
  explicit LevelArrangement(const Job& job)
    : job_(job)
  {
  }

  /// Makes the regions of the candidates, each for a slightly different value
  /// (tolerance::CurveOffset).
  ///
  /// \param level must outlive the use of the arrangement.
  /// \param withBent whether to add the paths that bend at the ends of windows and at regular
  ///        corners, which no shortest path does.
  /// \param offset of the curves from each other, as a fraction.
  void assign(const FaceLevel& level, bool withBent, double offset);

  /// Whether the face lies in one region, which is convex.
  bool isWithinOneRegion() const;

  /// The remainders in the face.
  std::vector<Remainder> remainders();

private:
  void addRegion(const DistanceCandidate& candidate, double offset);
  void findExtents();
  void cut(const LevelCurve& curve, const std::array<PlaneLine, 3>& edges,
    std::vector<Remainder>& remainders);
  void cutByRegions(
    const CurvePart& part, double first, double last, std::vector<Remainder>& remainders);
  bool isScrap(const Remainder& remainder) const;

  const Job& job_;
  const FaceLevel* level_ = nullptr;
  std::vector<LevelRegion> regions_;
  std::vector<LevelCurve> curves_;
  /// Where each region lies along an axis across most rays.
  Vec2 axis_;
  std::vector<Interval> extents_;
  /// Where the curve that is cut meets edges and regions, and the regions near its part.
  std::vector<double> atEdges_;
  std::vector<double> atRegions_;
  std::vector<const LevelRegion*> near_;
};

}

#endif
