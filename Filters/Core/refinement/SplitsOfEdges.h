// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SplitsOfEdges_h
#define geodesic_SplitsOfEdges_h

#include "Job.h"
#include "refinement/EdgeSplitter.h"
#include "refinement/FaceRefiner.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace geodesic
{

/// Puts points on edges, as faces have asked for them. Faces of several ranks at an edge get the
/// same points, bit for bit: one rank that refines a face there decides for all.
class SplitsOfEdges
{
public:
  /// All ranks construct this together. The faces and the job must outlive it.
  SplitsOfEdges(RefinedFaces& faces, double tolerance, const Job& job);

  /// Measures the edges that have been added since the last call. \returns for each one over the
  /// tolerance a request to split it.
  std::vector<SplitRequest> measureNew();
  /// Makes the splits that any rank asks for: of several for one piece, the most urgent one. An
  /// edge without points that is over the tolerance is cut into the fewest pieces at once. A
  /// collective call of all ranks.
  ///
  /// \returns the edges that have new points, ascending.
  std::vector<Id> split(std::vector<SplitRequest> requests);

private:
  template <typename Item>
  void run(std::size_t count, const Item& item);
  int deciderOf(Id edge) const;
  std::vector<SplitRequest> gather(std::vector<SplitRequest> requests);
  EdgeCuts decide(EdgeSplitter& splitter, const SplitRequest* first, const SplitRequest* last);
  std::vector<Id> share(const std::vector<Id>& edges, const std::vector<EdgeCuts>& cuts);
  void measure(const std::vector<Id>& edges);

  RefinedFaces& faces_;
  CutEdges& edges_;
  /// On several ranks, for each face of another rank, not 0 if its owner does not refine it.
  std::vector<std::uint8_t> isFrozenThere_;
  double tolerance_;
  const Job& job_;
  std::vector<std::unique_ptr<EdgeSplitter>> splitters_;
  Id measured_ = 0;
  /// For edges over the tolerance that have just been measured.
  std::unordered_map<Id, EdgeCuts> fewest_;
};

}

#endif
