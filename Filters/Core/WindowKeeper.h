// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_WindowKeeper_h
#define geodesic_WindowKeeper_h

#include "InterpolationError.h"
#include "TriangleMesh.h"
#include "WindowArchive.h"
#include "WindowList.h"

#include <memory>
#include <queue>
#include <utility>
#include <vector>

namespace geodesic
{

/// A list that has gone through a side.
struct PassedList
{
  Id side;
  WindowBlock windows;
  /// Whether it is within tolerance::NearLine of the line between these values at the side's ends.
  NearLine near = {};
  std::array<double, 2> ends = {};
};

/// Keeps the windows of faces that may have to be refined, and drops those of the others as the
/// front passes.
///
/// Let A and B bound how far the distance is over and under the linear interpolant L of a face's
/// corners. Where the face is closed by triangles between points of its edges, their values are
/// exact, so that the closure l is over L by at most A and under it by at most B: |l - d| <= A + B.
/// Where that is within the tolerance the face is flat. Windows that come later make d only
/// smaller, so that A stays what it is; B is looked at again. Where it is too large then and the
/// windows before are gone, the face is missed: the solve has to be done again with it wanted.
class WindowKeeper
{
public:
  /// A number of each vertex, which stands in a record of each.
  struct AtVertex
  {
    const double* first;
    /// From one to the next.
    std::size_t stride = 1;
    double operator()(Id vertex) const { return this->first[vertex * this->stride]; }
  };

  /// \param wanted for each face, whether it is never dropped.
  WindowKeeper(const TriangleMesh& mesh, double tolerance, const std::vector<std::uint8_t>& wanted);

  void want(Id face);
  /// Takes over lists that have gone through their sides; they are gone then. What is dropped goes
  /// back into the pool.
  void take(std::vector<PassedList>& lists, const AtVertex& distances, WindowPool& pool);
  /// A vertex that was settled has got a smaller distance.
  void changeCorner(Id vertex);
  /// The front has come to a key, having settled some vertices.
  void advance(const std::vector<Id>& settled, double front, const AtVertex& distances,
    const AtVertex& processed, WindowPool& pool);
  /// Hands over what is kept; its blocks are then the archive's.
  void finish(WindowArchive& archive, std::vector<std::uint8_t>& faceKept,
    const AtVertex& distances, WindowPool& pool);

  const std::vector<Id>& missed() const { return this->missed_; }
  double flatErrorBound() const { return this->flatErrorBound_; }

private:
  enum class State : std::uint8_t
  {
    Open,
    /// The front is to come past it.
    Awaited,
    Curved,
    Flat,
    /// Flat, and its windows are gone.
    Dropped
  };
  struct Run
  {
    PassedList list;
    Id next;
  };

  template <typename Visit>
  void forEachNeighbour(Id face, Visit&& visit) const;
  bool isOpen(Id face) const
  {
    return this->state_[face] == State::Open || this->state_[face] == State::Awaited;
  }
  std::array<double, 3> atCorners(Id face, const AtVertex& distances) const;
  double rounding(const std::array<double, 3>& d) const;
  void add(const PassedList& list);
  void test(Id face, const AtVertex& distances, WindowPool& pool);
  FaceBounds quickBounds(Id face, const std::array<double, 3>& d) const;
  FaceBounds bounds(Id face, const std::array<double, 3>& d, double limit) const;
  bool passes(Id face, const FaceBounds& bounds, double rounding, double limit);
  void setCurved(Id face);
  void release(Id face, WindowPool& pool);
  void drop(Id face, WindowPool& pool);

  const TriangleMesh& mesh_;
  double tolerance_;
  std::vector<State> state_;
  /// How far the distance can be over the interpolant in a flat face.
  std::vector<float> above_;
  /// The neighbours that may want the face's windows although it is flat.
  std::vector<Id> wanting_;
  std::vector<Run> runs_;
  std::vector<Id> freeRuns_;
  std::vector<Id> firstRun_;
  using Awaited = std::pair<double, Id>;
  std::priority_queue<Awaited, std::vector<Awaited>, std::greater<Awaited>> awaited_;
  std::vector<Id> missed_;
  double flatErrorBound_ = 0.0;
};

}

#endif
