// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_EdgeSplitter_h
#define geodesic_EdgeSplitter_h

#include "field/FaceDistance.h"
#include "field/SegmentEnvelope.h"
#include "refinement/RefinedFaces.h"

#include <array>
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

/// Measures the distance along edges. In an exact field the first refined face at an edge suffices.
/// In an approximate field the refined faces there may differ: the largest deviation counts, and a
/// point has the least distance.
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
  /// The splits that cut an edge without points into the fewest pieces within the tolerance; none
  /// if it is within the tolerance, or if there would be hundreds. If one cut suffices at the
  /// largest deviation, such as a kink, it is there; else deviations of the pieces are about equal.
  EdgeCuts fewestCuts(Id edge);
  /// Adds the distance to a split, and moves it away from the ends of the piece.
  void complete(EdgeSplit& split);

private:
  template <typename Visit>
  void forEachFaceToMeasure(Id edge, const Visit& visit);
  void enter(Id edge);
  double distanceAt(Id edge, double at);
  double distanceAtEnd(Id edge, Id end) const;

  // Along the last edge, where places are lengths from its begin.
  Deviation deviation(double from, double to, const std::array<double, 2>* ends) const;
  bool isWithin(double from, double to, double limit) const
  {
    return this->deviation(from, to, nullptr).largest() <= limit;
  }
  double furthest(double from, double to, double guess, double limit) const;
  std::vector<double> stepsWithin(double from, double to, double limit, std::size_t most) const;
  std::vector<double> evenCuts(double limit, const std::vector<double>& forward) const;
  std::vector<double> cuts(double limit) const;

  Deviation ofPiece(double from, double to, const std::array<double, 2>& ends) const;
  void addSplits(ArrayRange<double> places, double from, double to, Id piece,
    std::vector<EdgeSplit>& splits, std::vector<std::pair<double, double>>& points);

  const RefinedFaces& faces_;
  const CutEdges& edges_;
  double tolerance_;
  /// The last face, as neighbouring edges often ask for the same.
  FaceDistance face_;
  SegmentEnvelope envelope_;
  Id edge_ = NoId;
  double length_ = 0.0;
  /// The distance along the last edge according to each face, as SegmentEnvelope finds it.
  std::vector<std::vector<Window>> along_;
};

}

#endif
