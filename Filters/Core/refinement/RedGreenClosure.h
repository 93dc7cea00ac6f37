// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RedGreenClosure_h
#define geodesic_RedGreenClosure_h

#include "refinement/RedGreenMesh.h"
#include "refinement/SeamSplits.h"

#include <unordered_set>
#include <vector>

namespace geodesic
{

/// How a refinement decides about splits.
class SplitRules
{
public:
  virtual ~SplitRules() = default;
  /// Where to split an edge now.
  virtual RedGreenMesh::Placement place(Id edge) = 0;
  /// Whether a leaf with split edges, each split once, may stay a leaf.
  virtual bool mayClose(Id triangle) = 0;
};

/// The loop of splitting and closing: splits edges of a mesh and whatever must be split in
/// consequence. Afterwards no leaf has an edge that was split twice, or split edges with which the
/// rules forbid closing it.
///
/// If ranks share the surface, other ranks decide about some edges and are asked to split them. A
/// leaf that is to be split into four waits for them: the mesh is closed when no rank has asked for
/// anything.
class RedGreenClosure
{
public:
  /// All arguments must outlive this.
  RedGreenClosure(RedGreenMesh& mesh, SplitRules& rules, SeamSplits& seams)
    : mesh_(mesh)
    , rules_(rules)
    , seams_(seams)
  {
  }

  /// Splits an edge that is not split yet, or asks for the split. \returns whether the edge is
  /// split.
  bool split(Id edge, int round = 0);
  /// Splits a leaf into four, together with its unsplit edges.
  void splitIntoFour(Id triangle, int round = 0);

  /// Splits leaves into four: those with an edge that was split twice; those with two or more split
  /// edges that must not be closed; and, in two rounds, bisected ones that must not be closed.
  /// Whatever the second round bisects stays, so that splitting does not spread.
  ///
  /// \param round the first round: the one in which another rank has made the splits, 0 for this
  ///        rank's own.
  /// \returns the leaves that are new or have newly split edges since the last call, ascending.
  std::vector<Id> close(int round = 0);

  /// Forgets all waiting leaves, as the mesh was rolled back.
  void forget() { this->waiting_.clear(); }

private:
  bool isWaiting(Id triangle) const { return this->waiting_.count(triangle) != 0; }
  void closeTouched(int round, std::vector<Id>& changed);

  RedGreenMesh& mesh_;
  SplitRules& rules_;
  SeamSplits& seams_;
  /// Leaves that will be split into four once their edges are split.
  std::unordered_set<Id> waiting_;
};

}

#endif
