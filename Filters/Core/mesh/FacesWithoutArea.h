// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FacesWithoutArea_h
#define geodesic_FacesWithoutArea_h

#include "Exchange.h"
#include "Job.h"
#include "Types.h"

#include <array>
#include <cstdint>
#include <vector>

namespace geodesic
{

/// The triangles of a surface after removeFacesWithoutArea().
struct CutTriangles
{
  /// What became of each triangle, in the order of the triangles: itself, or the parts into which
  /// it was cut.
  std::vector<Triangle> parts;
  /// The triangle of each part.
  std::vector<Id> triangles;
  /// Whether each part is a face of the surface. Triangles without area are none.
  std::vector<std::uint8_t> areFaces;
  /// For each vertex the one that it has become.
  std::vector<Id> same;

  /// Whether no rank has faces without area: the triangles stay as they are.
  bool isEmpty() const { return this->same.empty(); }
};

/// Removes the faces without area of a surface. All ranks call this together.
///
/// A triangle without area conducts along its points and adds nothing else. In a needle (two
/// corners at one place) these corners become one vertex, and the long edges become one edge. In a
/// cap (one corner on the edge between the other two) the middle corner is put onto the edge: the
/// other triangles at the edge are cut there. The surface stays what it was up to the caps'
/// heights, which are rounding. Two edges at one place that no face joins stay apart: if they got
/// the same ends, one of them gets a vertex in its middle.
///
/// A triangle without area conducts by itself if some part of it has no face with area beside it.
/// Such a triangle remains a face; TriangleMesh gives it a height that changes no length.
///
/// \param points of the vertices. Vertices that cut triangles of this rank are added if it does not
///        have them.
/// \param keys of the vertices: vertices of several ranks with equal keys are one. Empty in one
///        process, where numbers are the keys.
/// \param firstNewKey keys from here on are free, on all ranks.
/// \param triangles on the vertices.
/// \param areFaces which of the triangles are faces of the surface; empty: all. The others conduct
///        nothing, but are cut like the faces at their edges.
CutTriangles removeFacesWithoutArea(std::vector<Vec3>& points, std::vector<std::uint64_t>& keys,
  std::uint64_t firstNewKey, const std::vector<Triangle>& triangles,
  const std::vector<std::uint8_t>& areFaces, Exchange& exchange, const Job& job = {});

/// Appends the parts of a triangle that is cut at points on its edges, in its orientation, without
/// any further points. Triangles at one place with points at the same places have the same parts,
/// in whatever order their corners are.
///
/// \param splits the points on edge k, from corner k to corner k + 1.
/// \param position where any of these points lies: (Id) -> Vec3.
template <typename Position>
void cutAtEdges(const Triangle& corners, const std::array<std::vector<Id>, 3>& splits,
  const Position& position, std::vector<Triangle>& parts)
{
  // The longest edge with splits, for the shapes. Of equally long ones it is the one whose opposite
  // corner is last, whatever the order of the corners.
  std::size_t k = 3;
  std::pair<double, Vec3> order;
  for (std::size_t i = 0; i < 3; ++i)
  {
    if (!splits[i].empty())
    {
      const double length = norm(position(corners[(i + 1) % 3]) - position(corners[i]));
      const std::pair<double, Vec3> own(length, position(corners[(i + 2) % 3]));
      if (k == 3 || own > order)
      {
        k = i;
        order = own;
      }
    }
  }
  if (k == 3)
  {
    parts.push_back(corners);
    return;
  }
  const std::size_t next = (k + 1) % 3;
  const std::size_t previous = (k + 2) % 3;
  // The middle one from either end.
  const std::size_t count = splits[k].size();
  const bool isForward = position(corners[k]) < position(corners[next]);
  const auto at =
    splits[k].begin() + static_cast<std::ptrdiff_t>(isForward ? (count - 1) / 2 : count / 2);
  cutAtEdges({ corners[k], *at, corners[previous] },
    { std::vector<Id>(splits[k].begin(), at), {}, splits[previous] }, position, parts);
  cutAtEdges({ *at, corners[next], corners[previous] },
    { std::vector<Id>(at + 1, splits[k].end()), splits[next], {} }, position, parts);
}

}

#endif
