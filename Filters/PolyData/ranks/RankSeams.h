// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RankSeams_h
#define geodesic_RankSeams_h

#include "Exchange.h"
#include "PolyData/ranks/SeamMerger.h"
#include "Types.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace geodesic
{

/// What one rank knows of the vertices of its piece that other ranks may have, too. One process
/// needs no tables.
struct RankLabels
{
  using Label = std::uint64_t;

  /// One a vertex. Vertices of all ranks that are one have the same label, and no others.
  std::vector<Label> labels;
  /// Whether another rank has the vertex, too.
  std::vector<std::uint8_t> isShared;

  Label of(Id vertex) const { return this->labels.empty() ? vertex : this->labels[vertex]; }
  bool isSharedAt(Id vertex) const { return !this->isShared.empty() && this->isShared[vertex]; }
};

/// Finds the vertices of several ranks' pieces of a surface that are one. Each vertex has a label:
/// the rank and the number of a vertex that it is one with. All ranks call all of these functions,
/// in the same order.
class RankSeams
{
public:
  using Label = RankLabels::Label;

  /// \param vertices of this rank's piece; they and the exchange must outlive this.
  RankSeams(const std::vector<Vec3>& vertices, Exchange& exchange);

  /// Makes vertices at exactly one place one, and those with the same global id.
  ///
  /// \param byPlace the same on all ranks.
  /// \param globalIds a global id and a vertex each; empty where there are none.
  void joinSame(bool byPlace, const std::vector<std::pair<std::int64_t, Id>>& globalIds);

  /// Makes vertices one that are on the boundaries of two pieces, or at ghosts, and within the
  /// precision of their coordinates, by the rule for blocks (SeamMerger.h). After joinSame().
  ///
  /// \param piece the faces of this rank.
  /// \returns how many vertices were joined with others, on all ranks. Vertices that only ghosts
  ///          have do not count.
  std::uint64_t joinNear(SeamBlock piece);

  RankLabels take() { return std::move(this->labels_); }

  /// The rank with the lowest vertex of those with a label.
  static int rankOf(Label label) { return static_cast<int>(label >> BitsOfVertex); }

private:
  static constexpr int BitsOfVertex = 40;

  static Label makeLabel(int rank, Id vertex)
  {
    return (static_cast<Label>(rank) << BitsOfVertex) | vertex;
  }
  std::vector<Id> verticesNearOthers() const;
  template <typename Key>
  bool shareLeast(const std::vector<std::pair<Key, Id>>& items);
  SeamBlock facesNearOthers(SeamBlock piece) const;
  GhostPlaces gatherGhosts(const SeamBlock& piece) const;
  std::vector<SeamVertex> gatherSeams(const SeamBlock& piece) const;

  const std::vector<Vec3>& vertices_;
  Exchange& exchange_;
  RankLabels labels_;
};

}

#endif
