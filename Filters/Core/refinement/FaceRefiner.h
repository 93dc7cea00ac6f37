// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceRefiner_h
#define geodesic_FaceRefiner_h

#include "refinement/FaceCheck.h"
#include "refinement/RefinedFaces.h"

#include <queue>
#include <vector>

namespace geodesic
{

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
  /// \param faces must outlive this. Their edges do not change while faces are refined.
  FaceRefiner(const RefinedFaces& faces, double tolerance)
    : faces_(faces)
    , tolerance_(tolerance)
    , check_(faces, tolerance)
  {
  }

  /// \param regions null: borders of regions do not count.
  /// \param requests are appended.
  /// \returns whether the face has done what it can without new points on edges.
  bool refine(FaceTriangles& face, SourceRegions* regions, std::vector<EdgeSplit>& requests);

private:
  struct OpenPart
  {
    SplitReason reason;
    double urgency;
    Id part;
    Id version;

    bool operator<(const OpenPart& other) const;
  };
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

  const RefinedFaces& faces_;
  double tolerance_;
  FaceCheck check_;

  // The face that is refined.
  FaceTriangles* face_ = nullptr;
  double leastAngle_ = 0.0;
  SourceRegions* regions_ = nullptr;
  std::vector<EdgeSplit>* requests_ = nullptr;
  std::priority_queue<OpenPart> open_;
};

}

#endif
