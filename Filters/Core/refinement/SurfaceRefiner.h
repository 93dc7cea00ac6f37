// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfaceRefiner_h
#define geodesic_SurfaceRefiner_h

#include "refinement/AdaptiveRefinement.h"
#include "refinement/FaceRefiner.h"
#include "refinement/RefinedFaces.h"
#include "refinement/SplitsOfEdges.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace geodesic
{

/// Refines a surface to a tolerance, in rounds. In a round faces with new points on their edges
/// work, each by itself, and ask for more points on edges; then edges get those. All ranks
/// construct and call this together.
class SurfaceRefiner
{
public:
  /// The stretch of the job that ends with run(); the output follows.
  static constexpr double JobOfRun = 0.9;

  /// All arguments must outlive this.
  SurfaceRefiner(const DistanceField& field, const RefinementOptions& options, double tolerance);

  /// \returns whether there is room for the result.
  bool run();
  /// The share of the room beside the surface's own faces that is taken, after run().
  double shareOfRoom() const;
  RefinedMesh result(const Job& job);

private:
  void assessFaces();
  bool isAtBorder(Id face, const Triangle& corners) const
  {
    return this->faces_.lengthAtBorder(face, corners, *this->options_.regions, this->tolerance_) >
      0.0;
  }
  void findBorders();
  bool refineFaces(SourceRegions* regions);
  void openDue();
  bool isAnythingLeft(const std::vector<EdgeSplit>& requests);
  void takeNewPoints();
  std::vector<EdgeSplit> work(SourceRegions* regions);
  void makeRefiners(std::size_t count);
  void report(const std::vector<EdgeSplit>& requests);
  std::vector<Id> unknownAtBorders();

  const RefinementOptions& options_;
  const MeshPartition& surface_;
  double tolerance_;
  RefinedFaces faces_;
  SplitsOfEdges splits_;
  std::vector<std::unique_ptr<FaceRefiner>> refiners_;
  /// Faces with work to do.
  std::vector<Id> due_;
  /// How many points on edges have been counted.
  std::size_t points_ = 0;
  std::uint64_t numberOfTriangles_;
  std::uint64_t trianglesOfAll_ = 0;
  bool isOverfull_ = false;
  double bound_;
  double worstAtFirst_ = 0.0;
};

}

#endif
