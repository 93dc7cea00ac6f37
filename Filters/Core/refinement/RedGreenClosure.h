// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RedGreenClosure_h
#define geodesic_RedGreenClosure_h

#include "refinement/RedGreenMesh.h"

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
class RedGreenClosure
{
public:
  /// \param mesh, rules must outlive this.
  RedGreenClosure(RedGreenMesh& mesh, SplitRules& rules)
    : mesh_(mesh)
    , rules_(rules)
  {
  }

  /// Splits an edge that is not split yet.
  void split(Id edge);
  /// Splits a leaf into four, and those of its edges that are whole.
  void splitIntoFour(Id triangle);

  /// Splits leaves into four: those with an edge that was split twice, those with two split edges
  /// or more that may not be closed, and in two rounds bisected ones that may not be: what the
  /// second bisects in turn stays, so that it does not spread.
  ///
  /// \returns the leaves that are new or whose edges were split since the last call, ascending.
  std::vector<Id> close();

private:
  void closeTouched(std::vector<Id>& changed);

  RedGreenMesh& mesh_;
  SplitRules& rules_;
};

}

#endif
