// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Gradients_h
#define geodesic_Gradients_h

#include "field/IncomingSegment.h"
#include "mesh/MeshPartition.h"

#include <set>
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
  /// A ray that comes from another rank: the face that it enters, on the rank that owns it, and the
  /// ray by that rank's numbers.
  struct Hop
  {
    RankAddress face = { -1, NoId };
    IncomingRay ray;

    bool isOne() const { return this->face.rank >= 0; }
  };
  /// A point whose ray is followed back over ranks, and the faces that it has entered there.
  struct Open
  {
    std::size_t point;
    Hop hop;
    std::set<RankAddress> passed;
  };
  struct Answer
  {
    Vec3 gradient;
    Hop hop;
  };

  Hop hopBefore(IncomingRay ray) const;

  const DistanceField& field_;
  std::vector<Vec3>& result_;
  std::vector<Open> open_;
};

}

#endif
