// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Gradients_h
#define geodesic_Gradients_h

#include "field/IncomingSegment.h"
#include "mesh/MeshPartition.h"

#include <vector>

namespace geodesic
{

/// The gradients at points that are given one after another: gradientOf(). Where ranks have the
/// surface together, the last face of a path that has an area may be another rank's, behind faces
/// without area.
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
  /// On a part all ranks call this together, once.
  void finish();

private:
  /// A ray on its way back over ranks.
  struct Traveller
  {
    /// Who asks: the rank, and the number of the point there.
    int rank;
    std::size_t point;
    IncomingRay ray;
    /// Of the faces at which it was handed over: one that it has passed, how many since, and after
    /// how many the mark moves on. So a way in a circle is noticed (R. P. Brent 1980).
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
  /// Whose rays go on on other ranks.
  std::vector<Traveller> travellers_;
  /// Whose rays ended here.
  std::vector<Traveller> arrived_;
};

}

#endif
