// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_EdgeSplitter_h
#define geodesic_EdgeSplitter_h

#include "field/FaceDistance.h"
#include "field/SegmentEnvelope.h"
#include "refinement/DistanceAlongEdge.h"
#include "refinement/RefinedFaces.h"

#include <utility>
#include <vector>

namespace geodesic
{

/// How an edge is cut: its splits, one after another, and the deviations of the pieces in the end.
struct EdgeCuts
{
  std::vector<EdgeSplit> splits;
  std::vector<Deviation> pieces;
};

/// Measures the distance along edges. In an exact field the first refined face at an edge suffices,
/// as one face determines the whole distance along its edge. In an approximate field the refined
/// faces there may differ: the largest deviation counts, and a point has the least distance.
///
/// One object serves one edge after another and reuses its memory. Edges do not change meanwhile.
class EdgeSplitter
{
public:
  /// \param faces must outlive this.
  EdgeSplitter(const RefinedFaces& faces, double tolerance)
    : faces_(faces)
    , edges_(faces.edges)
    , tolerance_(tolerance)
    , face_(faces.field)
  {
  }

  /// The deviations of an edge's pieces, of which those not yet known are measured.
  std::vector<Deviation> measure(Id edge);
  /// The places that cut an edge without points into the fewest pieces within the tolerance; none
  /// if it is within the tolerance.
  EdgeCuts fewestCuts(Id edge);
  /// Adds the distance to a split.
  EdgeSplit split(Id edge, Id piece, double weight, bool isForShape);

private:
  template <typename Visit>
  void forEachFaceToMeasure(Id edge, const Visit& visit);
  const DistanceAlongEdge& along(Id edge);
  double distanceAt(Id edge, double at);
  void addSplits(Id edge, ArrayRange<double> places, double from, double to, Id piece,
    std::vector<EdgeSplit>& splits, std::vector<std::pair<double, double>>& points);
  double distanceAtEnd(Id edge, Id end) const;
  Deviation deviation(Id edge, double from, double to, const std::array<double, 2>& ends);

  const RefinedFaces& faces_;
  const CutEdges& edges_;
  double tolerance_;
  /// The last face, as neighbouring edges often ask for the same.
  FaceDistance face_;
  SegmentEnvelope envelope_;
  /// The distance along the last edge.
  DistanceAlongEdge along_;
  Id edge_ = NoId;
};

}

#endif
