// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_TargetSets_h
#define geodesic_TargetSets_h

#include "Job.h"
#include "field/DistanceField.h"
#include "mesh/SurfacePoint.h"
#include "source/SourceCurve.h"

#include <vector>

namespace geodesic
{

/// Curves, points and regions in sets, each of which is one source, or one target.
using CurveSets = std::vector<std::vector<SourceCurve>>;

/// Targets that are sets of points, lines and regions. The distance of a set is the least of its
/// points, along its lines and along the outlines of its regions; 0 if the source has a point in
/// one of its regions.
class TargetSets
{
public:
  /// \param mesh must outlive this.
  TargetSets(const TriangleMesh& mesh, const CurveSets& sets);

  std::size_t size() const { return this->size_; }

  /// Solves from a source until the sets are settled.
  ///
  /// \param first the sets before this one are left out.
  /// \returns the distance of each set; infinite if it is empty, left out, beyond the maximum, or
  ///          no path leads to it.
  /// \throws Aborted
  std::vector<double> distancesFrom(
    const std::vector<SourceCurve>& source, Id first, double maximumDistance, const Job& job) const;

private:
  /// From a point to the next one, in a face that has both. The number of the curve is that of the
  /// set, the first parameter that of the point.
  struct Segment : SourceInFace
  {
    double length;
  };
  struct CoveredFace
  {
    Id set;
    Id face;
  };

  void addCurve(Id set, const SourceCurve& curve);
  std::vector<double> zeroWhereInside(const std::vector<SourceCurve>& source) const;
  void shorten(
    const DistanceField& field, Id first, double known, std::vector<double>& least) const;

  const TriangleMesh& mesh_;
  std::size_t size_;
  /// Ascending by set.
  std::vector<SurfacePoint> points_;
  std::vector<Id> setOfPoint_;
  std::vector<Segment> segments_;
  std::vector<CoveredFace> covered_;
};

}

#endif
