// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceLocator_h
#define geodesic_FaceLocator_h

#include "Progress.h"
#include "mesh/Box.h"
#include "mesh/TriangleMesh.h"

#include <vector>

namespace geodesic
{

/// Finds all faces that put a point onto its closest place: where a surface touches or overlaps
/// itself there are several, and no one of them is the right one by itself. A tree of boxes that is
/// built where points are looked for: a few points cost about as much as a look at every face, many
/// no more than the whole tree.
class FaceLocator
{
public:
  /// \param mesh must outlive the locator.
  explicit FaceLocator(const TriangleMesh& mesh);

  /// The faces that a point may be put onto, by the precision of coordinates as snapToFace takes it
  /// (never more than SnapFraction of a face's longest edge). Of a point that is on the surface
  /// within that precision: all faces whose distance is the least within it. Of other points faces
  /// that are almost as close may put them far from the closest place. So these have the faces
  /// whose distance cannot be told from the least by measuring, and those that put them within the
  /// precision of the closest place.
  ///
  /// First those that are as close up to rounding, by number, then the others, by number. Faces
  /// without area count as all others. Not thread-safe.
  ///
  /// \param coordinatePrecision relative precision of the point's coordinates.
  /// \param progress called now and then while the tree grows; returning false throws Aborted.
  std::vector<Id> closest(
    const Vec3& point, double coordinatePrecision, const ProgressCallback& progress = {});

  /// A face that may be among the closest to a point.
  struct Candidate
  {
    Id face;
    double distance;
    /// By how much it may be farther than the closest face, by the coordinates' precision and by
    /// rounding alone.
    double precision;
    double rounding;
    /// Up to the rounding of measuring, which does not depend on where the origin is.
    double measuring;
    /// From the point to the closest one of the face, and to where snapToFace puts it.
    Vec3 toClosest;
    Vec3 toPlace;
    /// Of the face, and of its smallest part (itself, an edge, a vertex) that holds the closest
    /// point; NoId elsewhere.
    Triangle corners;
    Triangle support;

    bool isClosest(double least) const { return this->distance <= least + this->precision; }
    bool isClosestUpToRounding(double least) const
    {
      return this->distance <= least + this->rounding;
    }
  };

  /// The faces from which closest() chooses: for a caller who knows of more. In no order.
  std::vector<Candidate> candidates(
    const Vec3& point, double coordinatePrecision, const ProgressCallback& progress = {});

  /// What closest() chooses from candidates, in their order.
  static std::vector<Candidate> chosen(const std::vector<Candidate>& candidates);

private:
  struct Node
  {
    Box box;
    /// A range of faces_.
    Id first;
    Id last;
    /// The first of its two parts, which follow each other; NoId while there are none.
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
