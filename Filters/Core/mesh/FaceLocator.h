// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceLocator_h
#define geodesic_FaceLocator_h

#include "Progress.h"
#include "mesh/Box.h"
#include "mesh/MeshPartition.h"

#include <vector>

namespace geodesic
{

/// Finds all faces that put a point onto its closest place. There are several where a surface
/// touches or overlaps itself, and the locator cannot know which one is meant. It uses a tree of
/// boxes that grows where points are searched: a few points cost about as much as a scan of all
/// faces, many points no more than the complete tree.
class FaceLocator
{
public:
  /// \param mesh must outlive the locator.
  explicit FaceLocator(const TriangleMesh& mesh);

  /// A face that may be among the closest to a point.
  struct Candidate
  {
    /// The locator gives rank 0.
    RankAddress face;
    double distance;
    /// How much farther than the closest face it may be: by the coordinates' precision, and by
    /// rounding alone.
    double precision;
    double rounding;
    /// The rounding of measuring, which does not depend on the position of the origin.
    double measuring;
    /// From the point to the face's closest point, and to where snapToFace puts it.
    Vec3 toClosest;
    Vec3 toPlace;
    /// The vertices of the face, and of its smallest part (vertex, edge or the face) that contains
    /// the closest point, filled with NoId.
    Triangle corners;
    Triangle support;

    bool isClosest(double least) const { return this->distance <= least + this->precision; }
    bool isClosestUpToRounding(double least) const
    {
      return this->distance <= least + this->rounding;
    }
  };

  /// The faces that may be among the closest, unordered. Faces without area count like all others.
  /// Not thread-safe.
  ///
  /// \param coordinatePrecision relative precision of the point's coordinates.
  /// \param progress called now and then while the tree grows; returning false throws Aborted.
  std::vector<Candidate> candidates(
    const Vec3& point, double coordinatePrecision, const ProgressCallback& progress);

  /// Of the closest candidates of a point, in their order, the faces that it may be put onto, given
  /// the precision of coordinates as in snapToFace (at most SnapFraction of a face's longest edge).
  /// A face that is almost as close as the closest may put the point far from the closest place. So
  /// these are the faces whose distances cannot be distinguished from the least by measuring, and
  /// those that put the point within the precision of the closest place.
  static std::vector<Candidate> chosen(const std::vector<Candidate>& closest);

private:
  struct Node
  {
    Box box;
    /// A range of faces_.
    Id first;
    Id last;
    /// The first of its two parts, which are adjacent; NoId before the node is divided.
    Id parts = NoId;
  };
  struct Search;

  double centre(Id face, std::size_t axis) const;
  Node makeNode(Id first, Id last) const;
  Id findMiddle(const Node& node);
  void split(Id node, Search& search);
  void search(Search& search, Id node);
  void tryFace(Search& search, Id face) const;
  void complete(Candidate& candidate, const Vec3& point, double coordinatePrecision) const;

  const TriangleMesh& mesh_;
  std::vector<Id> faces_;
  std::vector<Node> nodes_;
};

}

#endif
