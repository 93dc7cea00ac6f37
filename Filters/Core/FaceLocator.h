// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceLocator_h
#define geodesic_FaceLocator_h

#include "Progress.h"
#include "TriangleMesh.h"

#include <vector>

namespace geodesic
{

/// Finds the closest face. A tree of boxes that is built where points are looked for: a few points
/// cost about as much as a look at every face, many no more than the whole tree.
class FaceLocator
{
public:
  /// \param mesh must outlive the locator.
  explicit FaceLocator(const TriangleMesh& mesh);

  /// The face with the closest point of the surface to a point; of several at one distance that
  /// with the lowest number. Not thread-safe.
  ///
  /// \param progress called now and then; returning false throws Aborted.
  Id closest(const Vec3& point, const ProgressCallback& progress = {});

private:
  struct Box
  {
    Vec3 low{ Infinity, Infinity, Infinity };
    Vec3 high{ -Infinity, -Infinity, -Infinity };
  };
  struct Node
  {
    Box box;
    /// A range of faces_.
    Id first;
    Id last;
    /// The first of its two parts; none yet.
    Id parts = NoId;
  };
  struct Search;

  double centre(Id face, std::size_t axis) const;
  Node makeNode(Id first, Id last) const;
  Id findMiddle(const Node& node);
  void split(Id node);
  void search(Search& search, Id node);

  const TriangleMesh& mesh_;
  std::vector<Id> faces_;
  std::vector<Node> nodes_;
};

}

#endif
