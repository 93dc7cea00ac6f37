// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RedGreenClosure_h
#define geodesic_RedGreenClosure_h

#include "mesh/MeshPartition.h"
#include "refinement/RedGreenMesh.h"

#include <cstdint>
#include <functional>
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
  /// Whether a leaf with split edges, which is not thin, may stay a leaf.
  virtual bool mayClose(Id triangle) = 0;
  /// The part of a thin leaf's edges that must be split before the leaf can be closed; NoId if
  /// there is none.
  virtual Id edgeToSplit(Id triangle) = 0;
  /// The part of a thin leaf's edges to split before the leaf can be divided into the triangles
  /// that close it; NoId if there is none.
  virtual Id edgeToSplitBeforeParts(Id triangle) = 0;
};

/// The loop of splitting and closing: splits edges of a mesh and whatever must be split in
/// consequence. Afterwards no leaf has split edges with which the rules forbid closing it.
///
/// If ranks share the surface, one rank decides where an edge of faces of several ranks, and in
/// turn each of its halves, is split: the lowest rank that owns a refined face there. It tells the
/// others the place and the distance there, so that points on seams are the same on all ranks, bit
/// for bit. Other ranks ask it for the splits that they need; a leaf that is to be split into four
/// waits for them. The deciding rank never refuses and never waits for another rank to split an
/// edge, so there is no deadlock.
class RedGreenClosure
{
public:
  /// A collective call of all ranks. All arguments must outlive this.
  ///
  /// \param mesh where the faces of other ranks are frozen.
  RedGreenClosure(const MeshPartition& part, RedGreenMesh& mesh, SplitRules& rules);

  /// Splits an edge that is not split yet, or asks for the split. \returns whether the edge is
  /// split.
  bool split(Id edge);
  /// Splits a leaf into four, together with its unsplit edges.
  void splitIntoFour(Id triangle);
  /// Makes new edges inside a leaf: splits it into four or, if it is thin, divides it or splits its
  /// longest edge.
  void splitInside(Id triangle);

  /// Splits leaves into four: those with two or more points on their edges that must not be closed;
  /// and, in two rounds, bisected ones that must not be closed.
  /// Whatever the second round bisects stays, so that splitting does not spread. Splits the edges
  /// of thin leaves as the rules require.
  void close();

  /// A collective call of all ranks, which makes the splits that other ranks have decided or ask
  /// for, until no rank sends any: only then is the mesh closed. It ends early if a rank has too
  /// many triangles; the ranks then have to roll back.
  ///
  /// \param most the number of triangles that this rank can have.
  /// \param report called after each split that another rank has decided.
  /// \returns whether no rank has too many triangles.
  bool exchangeSplits(std::uint64_t most, const std::function<void()>& report);

  /// The leaves that are new or have newly split edges since the last call, ascending.
  std::vector<Id> takeChanged();
  /// Forgets all waiting and changed leaves, as the mesh was rolled back.
  void forget();

private:
  enum class Kind : std::uint32_t
  {
    Decision,
    Request
  };
  struct SplitMessage
  {
    Kind kind;
    int round;
    /// The input edge: the face with its lowest halfedge, which all ranks that own a face at the
    /// edge have, and the halfedge's number there.
    RankAddress face;
    Id halfedge;
    /// How often it is halved.
    Id depth;
  };

  void closeTouched(std::vector<Id>& changed);
  Id firstRefinedFaceAt(Id edge) const;
  void send(int rank, Kind kind, Id edge);
  Id takeEdge(const SplitMessage& split, MessageReader& reader);

  const MeshPartition& part_;
  RedGreenMesh& mesh_;
  SplitRules& rules_;
  /// Whether each face is frozen on the rank that owns it.
  std::vector<std::uint8_t> frozen_;
  /// To each rank, the decisions and requests that have not been sent yet.
  std::vector<Message> messages_;
  /// Leaves that will be split into four once their edges are split.
  std::unordered_set<Id> waiting_;
  std::vector<Id> changed_;
  /// The round of the closure that is going on; 0 before the first. A split that another rank has
  /// made or asks for belongs to the round in which that rank needs it.
  int round_ = 0;
};

}

#endif
