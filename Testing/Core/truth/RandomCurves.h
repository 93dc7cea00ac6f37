// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_RandomCurves_h
#define geodesictest_RandomCurves_h

#include "truth/BruteForce.h"
#include "truth/TestMeshes.h"

#include <map>
#include <utility>
#include <vector>

namespace geodesictest
{

/// A polyline on a mesh: each segment lies in one face and begins where the previous one ends. A
/// single point is a segment without length.
struct Polyline
{
  std::vector<MeshSegment> segments;
  /// Whether segment i continues straight (in the unfolding) into the next one, across an edge of
  /// two faces: the joint merely cuts the line at that edge. Empty: none does.
  std::vector<bool> isCutAfter;

  bool isPoint() const;
  bool isCut(std::size_t segment) const;
};

/// Makes polylines on one mesh, of any topology.
class CurveMaker
{
public:
  CurveMaker(const PlainMesh& mesh, Random& random);

  Polyline point();
  Polyline point(const MeshPoint& place) const;
  /// From a random point to a random point of a face around it, and so on: along edges, through
  /// vertices, back over itself.
  Polyline walk(Index segments);
  /// Straight in the unfolding, through at most this many faces.
  Polyline straight(Index faces);
  /// A triangle inside a face, or the face's outline.
  Polyline closed();
  /// To the end and back along the same way.
  Polyline thereAndBack(Index segments);
  /// A random one of these.
  Polyline any();
  /// One to four of these, or a single point.
  std::vector<Polyline> anySource();

private:
  std::vector<Index> facesWith(Index face, const Barycentric& weights) const;
  Barycentric inFace(Index face, Index other, const Barycentric& weights) const;

  const PlainMesh& mesh_;
  Random& random_;
  std::map<std::pair<Index, Index>, std::vector<Index>> facesOfEdge_;
  std::vector<std::vector<Index>> facesOfVertex_;
};

/// The same curves as points and segments.
Sources toSources(const std::vector<Polyline>& curves);

/// The same polyline from its other end.
Polyline reversed(const Polyline& curve);

}

#endif
