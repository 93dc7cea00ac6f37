// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Gradients_h
#define geodesic_Gradients_h

#include "field/IncomingSegment.h"
#include "mesh/MeshPartition.h"

#include <vector>

namespace geodesic
{

/// Finds the gradients at points that are given one after another: gradientOf(). The direction of a
/// path is known in the last face that has an area. Behind faces without area, this face may belong
/// to another rank.
class Gradients
{
public:
  /// \param field must outlive this.
  /// \param result to which each point's gradient is appended.
  Gradients(const DistanceField& field, std::vector<Vec3>& result)
    : field_(field)
    , result_(result)
  {
  }

  void add(const IncomingSegment& piece);
  /// All ranks call this together, once.
  void finish();

private:
  /// A ray that is followed back over ranks.
  struct Traveller
  {
    /// The rank that asks, and the number of the point there.
    int rank;
    std::size_t point;
    IncomingRay ray;
    /// Detects a cycle of the faces at which the ray is handed over (R. P. Brent 1980): a face that
    /// it has passed, how many it has passed since then, and after how many the mark moves on.
    RankAddress mark;
    std::size_t passed;
    std::size_t limit;
  };
  struct Answer
  {
    std::size_t point;
    Vec3 gradient;
  };

  bool goesOnElsewhere(const IncomingRay& ray) const;
  bool isInCircle(Traveller& traveller) const;
  void handOver(Exchange& exchange);
  void answer(Exchange& exchange);

  const DistanceField& field_;
  std::vector<Vec3>& result_;
  /// Rays that continue on other ranks.
  std::vector<Traveller> travellers_;
  /// Rays that ended on this rank.
  std::vector<Traveller> arrived_;
};

}

#endif
