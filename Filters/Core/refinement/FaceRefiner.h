// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceRefiner_h
#define geodesic_FaceRefiner_h

#include "field/FaceDistance.h"
#include "field/SegmentEnvelope.h"
#include "refinement/CutEdges.h"
#include "refinement/FaceTriangles.h"
#include "refinement/TriangleError.h"

#include <cstdint>
#include <functional>
#include <queue>
#include <unordered_map>
#include <vector>

namespace geodesic
{

/// Why a triangle has to be split, the most urgent reason first.
enum class SplitReason : std::uint8_t
{
  /// Its difference to the distance is over the tolerance.
  Error,
  /// Its smallest angle is too small.
  Shape,
  /// A border of regions passes it.
  Border
};

/// A face asks for a point on one of its edges, which all faces there share.
struct SplitRequest
{
  Id edge;
  Id piece;
  SplitReason reason;
  /// What is worse comes first.
  double urgency;
  /// Where, as a fraction of the piece.
  double weight;
};

/// The length of a triangle's longest side if a border of regions passes it, so that it must be
/// split; else 0.
using LengthAtBorder = std::function<double(const FaceTriangles&, const Triangle&)>;

/// Refines one face by itself, given the points on its edges: splits and flips sides inside, and
/// asks for more points on its edges. One object serves one face after another and reuses its
/// memory.
///
/// The worst triangle comes first. If its worst side is on an edge, the face asks for a point
/// there, and the triangle waits. Else the side flips if both new triangles pass, or is split where
/// the deviation is largest. If only the inside is over the tolerance, the longest side is halved.
class FaceRefiner
{
public:
  /// The field and the edges must outlive this. The edges do not change while faces are refined.
  FaceRefiner(const DistanceField& field, const CutEdges& edges, double tolerance)
    : field_(field)
    , edges_(edges)
    , tolerance_(tolerance)
    , error_(field)
    , distance_(field)
  {
  }

  /// \param mostParts refinement stops when the face has more.
  /// \param lengthAtBorder empty: there are no regions.
  /// \param requests are appended.
  /// \returns whether the face has done what it can without new points on edges.
  bool refine(FaceTriangles& face, std::uint64_t mostParts, const LengthAtBorder& lengthAtBorder,
    std::vector<SplitRequest>& requests);

  /// A bound of the difference in a triangle over the tolerance, close to one that does occur.
  double tightBound(FaceTriangles& face, Id part);

private:
  struct Check
  {
    bool hasPassed;
    double bound;
    /// A difference that does occur.
    double sample;
    /// The limit for differences within the face.
    double limit;
  };
  struct OpenPart
  {
    SplitReason reason;
    double urgency;
    Id part;
    Id version;
    double limit;

    bool operator<(const OpenPart& other) const;
  };
  /// The largest difference along a side of a triangle, and where, from its first corner.
  struct SideDeviation
  {
    Deviation deviation;
    double at;
  };

  /// A piece between two points of one side of the face.
  struct PieceOfEdge
  {
    Id edge = NoId;
    Id piece = NoId;
    /// Whether the edge runs from the second point to the first.
    bool isReversed = false;
  };

  void enter(FaceTriangles& face);
  void takePoints();
  void takePoints(std::size_t side);
  FaceTriangles::Point pointOnEdge(std::size_t side, Id number) const;
  void assess(const std::vector<Id>& parts);
  void assess(Id part);
  void assessAtBorder(Id part);
  double urgencyOfShape(Id part) const;
  void improve(const OpenPart& open);
  void mendError(const OpenPart& open);
  void mendShape(const OpenPart& open);
  bool flipIfBoth(Id part, std::size_t side);
  void halveLongest(const OpenPart& open);
  void splitInside(const OpenPart& open, Id part, std::size_t side, double weight);
  bool asksBeside(const OpenPart& open, const FaceTriangles::Point& point, double length);
  void request(const OpenPart& open, const PieceOfEdge& piece, double weight);
  bool mayImproveShape() const;

  Check check(const Triangle& corners, bool isTight);
  PieceOfEdge pieceBetween(Id a, Id b) const;
  SideDeviation deviationOf(Id a, Id b);
  const Deviation& measured(Id a, Id b);
  double alongEdge(std::size_t side, Id point) const;
  bool isReversed(std::size_t side) const;

  const DistanceField& field_;
  const CutEdges& edges_;
  double tolerance_;
  TriangleError error_;
  SegmentEnvelope envelope_;
  FaceDistance distance_;

  // The face that is refined.
  FaceTriangles* face_ = nullptr;
  std::array<Id, 3> edgeOfSide_{};
  double leastAngle_ = 0.0;
  const LengthAtBorder* lengthAtBorder_ = nullptr;
  std::vector<SplitRequest>* requests_ = nullptr;
  std::priority_queue<OpenPart> open_;
  /// The deviations along sides inside the face, from the lower point to the higher one.
  std::unordered_map<std::uint64_t, Deviation> inside_;
};

}

#endif
