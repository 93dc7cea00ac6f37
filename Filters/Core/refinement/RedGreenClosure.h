// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RedGreenClosure_h
#define geodesic_RedGreenClosure_h

#include "refinement/RedGreenMesh.h"
#include "refinement/SeamSplits.h"

#include <unordered_set>
#include <vector>

namespace geodesic
{

/// What a refinement decides about splits.
class SplitRules
{
public:
  virtual ~SplitRules() = default;
  /// Where an edge that is to be split now is split.
  virtual RedGreenMesh::Placement place(Id edge) = 0;
  /// Whether a leaf with split edges, each of them split once, may stay a leaf.
  virtual bool mayClose(Id triangle) = 0;
};

/// The loop of splitting and closing: splits edges of a mesh and what has to be split in turn, so
/// that between splits no leaf has an edge that was split twice, nor split edges with which the
/// rules do not let it be closed.
///
/// On a part of a surface that ranks have together some edges are decided about by other ranks,
/// which are asked then. A leaf that is to be split into four waits for them: the mesh is closed
/// once no rank has asked for anything.
class RedGreenClosure
{
public:
  /// \param mesh, rules must outlive this.
  /// \param seams null: this rank decides about all edges.
  RedGreenClosure(RedGreenMesh& mesh, SplitRules& rules, SeamSplits* seams = nullptr)
    : mesh_(mesh)
    , rules_(rules)
    , seams_(seams)
  {
  }

  /// Splits an edge that is not split yet, or asks for it. \returns whether it is split.
  bool split(Id edge, int round = 0);
  /// Splits a leaf into four, and those of its edges that are whole.
  void splitIntoFour(Id triangle, int round = 0);

  /// Splits leaves into four: those with an edge that was split twice, those with two split edges
  /// or more that may not be closed, and in two rounds bisected ones that may not be: what the
  /// second bisects in turn stays, so that it does not spread.
  ///
  /// \param round the first one: that in which another rank has made the splits, 0 for one's own.
  /// \returns the leaves that are new or whose edges were split since the last call, ascending.
  std::vector<Id> close(int round = 0);

  /// No leaf waits any more: the mesh was rolled back.
  void forget() { this->waiting_.clear(); }

private:
  bool isWaiting(Id triangle) const { return this->waiting_.count(triangle) != 0; }
  void closeTouched(int round, std::vector<Id>& changed);

  RedGreenMesh& mesh_;
  SplitRules& rules_;
  SeamSplits* seams_;
  /// Leaves that are to be split into four when their edges are.
  std::unordered_set<Id> waiting_;
};

}

#endif
