// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RankSeams_h
#define geodesic_RankSeams_h

#include "Exchange.h"
#include "PolyData/ranks/BorrowedValues.h"
#include "Types.h"
#include "mesh/Box.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace geodesic
{

/// What one rank knows of the vertices of its piece that other ranks may have, too.
struct RankLabels
{
  /// The rank and the number of a vertex.
  using Label = std::uint64_t;
  static constexpr Label Shared = Label(1) << 63;

  /// One a vertex. Vertices of all ranks that are one have the same label, and no others. The bit
  /// Shared is set where another rank has the vertex, too. Empty in one process, where a vertex's
  /// label is its number.
  std::vector<Label> labels;

  Label of(Id vertex) const
  {
    return this->labels.empty() ? vertex : this->labels[vertex] & ~Shared;
  }
  bool isSharedAt(Id vertex) const
  {
    return !this->labels.empty() && (this->labels[vertex] & Shared) != 0;
  }
};

/// Finds the vertices of several ranks' pieces of a surface that are one: those at exactly one
/// place, and those with the same global id. All ranks call this together.
///
/// \param vertices of this rank's piece.
/// \param byPlace whether places count; the same on all ranks.
/// \param globalIds a global id and a vertex each; empty where there are none.
RankLabels joinSameVertices(const std::vector<Vec3>& vertices, bool byPlace,
  const std::vector<std::pair<std::int64_t, Id>>& globalIds, Exchange& exchange);

/// One block of a surface, for mergeSeams().
struct SeamBlock
{
  /// Its triangles, as vertices.
  std::vector<Triangle> triangles;
  /// Those that a ghost array marks as duplicates.
  std::vector<Triangle> ghosts;
  /// The relative precision of its coordinates.
  double precision = 0.0;
};

/// Vertices that are one.
struct JoinedVertices
{
  /// The label of each vertex that is one with others, and the label of the one that stands for it:
  /// the lowest of those that are no corners of ghosts only, if there are any.
  std::map<RankLabels::Label, RankLabels::Label> same;
  /// How many were joined with others, not counting those that only ghosts have.
  std::uint64_t count = 0;
};

/// Where blocks of one surface meet, their points may differ by roundings, and ghosts may differ
/// from what they duplicate: each block may have computed or stored them on its own. Finds the
/// vertices that are one within the precision of the coordinates (tolerance::SeamRoundings,
/// SeamFraction), the nearest first: two on boundaries, or one at a ghost and any other. Two with
/// triangles of one block are never made one.
///
/// \param vertices points at exactly one place are one vertex already.
/// \param labels of the vertices.
/// \param blocks those of one process; of several ranks, which call this together, one each.
/// \param largest the largest coordinate of a vertex of any rank's triangles.
/// \returns the same on all ranks.
JoinedVertices mergeSeams(const std::vector<Vec3>& vertices, const RankLabels& labels,
  std::vector<SeamBlock> blocks, double largest, Exchange& exchange);

/// Finds values for the vertices of a rank's points that no own face has: corners of duplicates of
/// other ranks' faces, and points that no face uses here. The values come from the lowest rank that
/// has a face there. All ranks call this together.
///
/// \param labels of all vertices of this rank.
/// \param ownNumbers of each vertex its number among those with faces; NoId without faces. Empty in
///        one process.
/// \returns one value for each vertex without faces, in their order.
BorrowedValues findValuesElsewhere(
  const RankLabels& labels, const std::vector<Id>& ownNumbers, Exchange& exchange);

/// \param margin to all sides of the point.
inline Box boxAround(const Vec3& point, double margin)
{
  const Vec3 margins = { margin, margin, margin };
  return { point - margins, point + margins };
}

/// The bounding boxes of what the other ranks have.
class OtherRanks
{
public:
  /// All ranks make theirs together.
  ///
  /// \param own of what this rank has.
  OtherRanks(const Box& own, Exchange& exchange)
    : boxes_(valuesOfRanks(exchange, own))
  {
    this->boxes_.erase(this->boxes_.begin() + exchange.rank());
  }

  bool areNear(const Vec3& point, double margin) const
  {
    const Box around = boxAround(point, margin);
    return std::any_of(this->boxes_.begin(), this->boxes_.end(),
      [&around](const Box& box) { return box.meets(around); });
  }

private:
  std::vector<Box> boxes_;
};

}

#endif
