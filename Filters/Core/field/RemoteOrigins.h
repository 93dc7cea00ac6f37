// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RemoteOrigins_h
#define geodesic_RemoteOrigins_h

#include "field/DistanceField.h"
#include "mesh/GlobalVertices.h"
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
  /// \param field on this rank's part, with arrivals. Finds the origins of all vertices of the part
  ///        that are not counted here, and of the vertices that its windows name.
  /// \param vertices of that part.
  /// \param atVertices for each vertex of the part: of those counted here the source, as Window has
  ///        it, NoId where there is none, or the vertex counted elsewhere from which the path comes
  ///        on. What is open is replaced, for all of the part's vertices.
  RemoteOrigins(const DistanceField& field, const GlobalVertices& vertices,
    std::vector<CurveOrigin>& atVertices);

  /// \param vertex its number in the whole; not counted here.
  CurveOrigin of(Id vertex) const;

private:
  void collect();
  bool isOpen(const CurveOrigin& origin) const
  {
    return origin.origin < this->field_.surface().numberOfGlobalVertices();
  }
  void ask(std::vector<CurveOrigin>& atVertices);

  const DistanceField& field_;
  const GlobalVertices& vertices_;
  /// Numbers in the whole, ascending, and what is known of each.
  std::vector<Id> numbers_;
  std::vector<CurveOrigin> origins_;
};

}

#endif
