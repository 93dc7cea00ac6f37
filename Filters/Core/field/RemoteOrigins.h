// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RemoteOrigins_h
#define geodesic_RemoteOrigins_h

#include "field/DistanceField.h"
#include "source/CurveSectors.h"

#include <utility>
#include <vector>

namespace geodesic
{

/// Finds the origins of paths that come from vertices counted by other ranks. A chain of
/// pseudo-sources may lead through many ranks. In each round, every rank asks for the origin of the
/// vertex that it has followed a chain to. As the ranks asked follow their own chains at the same
/// time, each round doubles the known length of the chains.
class RemoteOrigins
{
public:
  /// All ranks call this together.
  ///
  /// \param field on this rank's part, with arrivals. Origins are found for the vertices of the
  ///        part that are not counted here, and for the vertices that its windows name.
  /// \param atVertices for each vertex of the part. Of a vertex counted here: its origin on the
  ///        source, as in Window; NoId if there is none; or, still open, the vertex counted
  ///        elsewhere that its path comes from. Open origins are replaced, those of vertices
  ///        counted elsewhere are set.
  RemoteOrigins(const DistanceField& field, std::vector<CurveOrigin>& atVertices);

  /// \param vertex the global id of one that is not counted here.
  CurveOrigin of(Id vertex) const;

private:
  void collect();
  bool isOpen(const CurveOrigin& origin) const
  {
    return origin.origin < this->field_.surface().numberOfGlobalVertices();
  }
  void ask(std::vector<CurveOrigin>& atVertices);

  const DistanceField& field_;
  /// Global ids, ascending, and the origin of each.
  std::vector<Id> numbers_;
  std::vector<CurveOrigin> origins_;
};

}

#endif
