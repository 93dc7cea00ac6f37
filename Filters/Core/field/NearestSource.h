// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_NearestSource_h
#define geodesic_NearestSource_h

#include "field/FootFinder.h"

#include <unordered_map>
#include <vector>

namespace geodesic
{

/// Finds the nearest source of any point whose distance is known. Windows store their origins; a
/// path that comes from a pseudo-source has the foot of the pseudo-source. If several shortest
/// paths tie, the foot is that of one of them.
///
/// If ranks share the surface, each rank answers for the points of the faces that it owns.
///
/// Takes 16 bytes a vertex.
class NearestSource : public FootFinder
{
public:
  /// All ranks call this together, as paths come over seams. Later each rank asks for itself.
  ///
  /// \param field exact, with arrivals (FrontOptions::keepArrivals); must outlive this.
  /// \param patch that the curves lie on; in one process the field's mesh.
  /// \param curves those that the field was solved for.
  NearestSource(const DistanceField& field, const ReplicatedPatch& patch,
    const std::vector<SourceCurve>& curves, const Job& job = {});

  /// The foot of the shortest path to a vertex.
  Foot atVertex(Id vertex) const { return this->footOf(this->origins_[vertex]); }
  /// The foot of a path that ends with a piece, from incomingSegmentTo() of the same field. Not
  /// thread-safe.
  Foot of(const IncomingSegment& piece);

private:
  void follow(Id vertex);
  bool isFromCurve(const IncomingSegment& piece) const;
  PathOrigin ofVertex(GlobalId id) const;

  /// The origin of the path to each vertex.
  std::vector<PathOrigin> origins_;
  /// Those of vertices that other ranks count; none in one process.
  std::unordered_map<GlobalId, PathOrigin> elsewhere_;
};

}

#endif
