// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SplitsOfEdges_h
#define geodesic_SplitsOfEdges_h

#include "Exchange.h"
#include "Job.h"
#include "refinement/EdgeSplitter.h"

#include <array>
#include <memory>
#include <unordered_map>
#include <vector>

namespace geodesic
{

/// Puts points on edges, as faces have asked for them. Of several ranks with faces at an edge, one
/// that refines a face there decides for all.
class SplitsOfEdges
{
public:
  /// The faces and the job must outlive this.
  SplitsOfEdges(RefinedFaces& faces, double tolerance, const Job& job)
    : faces_(faces)
    , edges_(faces.edges)
    , tolerance_(tolerance)
    , job_(job)
  {
  }

  /// Measures the edges that have been added or split since the last call. \returns for each edge
  /// without points that is over the tolerance a request to split it.
  std::vector<EdgeSplit> measureNew();
  /// Makes the splits that any rank asks for: of several for one piece, the most urgent one. An
  /// edge without points that is over the tolerance is cut into the fewest pieces at once. A
  /// collective call of all ranks.
  void split(std::vector<EdgeSplit> requests);

private:
  template <typename Item>
  void run(std::size_t count, const Item& item);
  int deciderOf(Id edge) const;
  void tell(int rank, const EdgeSplit& split, std::vector<Message>& messages) const;
  std::vector<EdgeSplit> exchange(std::vector<Message> messages);
  EdgeCuts decide(EdgeSplitter& splitter, ArrayRange<EdgeSplit> requests) const;
  void cut(const std::vector<EdgeCuts>& cuts);

  RefinedFaces& faces_;
  CutEdges& edges_;
  double tolerance_;
  const Job& job_;
  /// One for each task that has run.
  std::array<std::unique_ptr<EdgeSplitter>, Job::MostTasks> splitters_;
  /// How many edges and points have been measured.
  Id measured_ = 0;
  std::size_t measuredPoints_ = 0;
  /// For edges over the tolerance that have just been measured.
  std::unordered_map<Id, EdgeCuts> fewest_;
};

}

#endif
