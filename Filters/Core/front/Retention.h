// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Retention_h
#define geodesic_Retention_h

#include "mesh/TriangleMesh.h"
#include "source/SourceWindows.h"
#include "window/WindowArchive.h"
#include "window/WindowPool.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace geodesic
{

/// A list of windows that has gone through its face, and the distances known at the ends of its
/// halfedge then.
struct PassedList
{
  Id halfedge;
  WindowBlock windows;
  std::array<double, 2> ends = {};
};

/// One number of each vertex, which stands in a record of each.
struct VertexNumbers
{
  const double* first;
  /// From one vertex to the next.
  std::size_t stride = 1;
  double operator()(Id vertex) const { return this->first[vertex * this->stride]; }
};

/// Where the front stands at the end of a batch.
struct FrontState
{
  /// The key at which the batch began: no path that is still to be found is shorter.
  double key;
  /// The vertices of the batch.
  const std::vector<Id>& settled;
  /// The distances found so far, and those with which vertices were last processed.
  VertexNumbers distances;
  VertexNumbers processed;
  /// Where the blocks of lists came from: one or more. A block may be freed into any of them.
  const std::vector<WindowPool*>& pools;

  /// Gives a block back to the pool that has the fewest of its size: a thread that does more than
  /// others needs more of them, and blocks of one size do not serve for another.
  void free(const WindowBlock& block) const
  {
    const std::uint32_t sizeClass = block.sizeClass;
    WindowPool* const shortest = *std::min_element(this->pools.begin(), this->pools.end(),
      [sizeClass](const WindowPool* a, const WindowPool* b)
      { return a->freeBlocks(sizeClass) < b->freeBlocks(sizeClass); });
    shortest->free(block);
  }
};

/// What a solve has kept of its windows.
struct KeptWindows
{
  /// Indexed, or empty where nothing was kept.
  WindowArchive windows;
  /// Whether each face has all its windows; empty where all faces do.
  std::vector<std::uint8_t> faces;
  /// In faces whose windows were dropped: no closure by triangles between points of the edges
  /// differs by more from the distance (certified), and what was asked for.
  double droppedErrorBound = 0.0;
  double droppedTolerance = 0.0;
};

/// Decides what becomes of the windows behind the front. The front hands each list over once it has
/// gone through its face; distances at vertices need none of them.
///
/// pass() is called from the tasks of a batch, each for a district of its own (front/Districts.h);
/// the rest between batches from one thread. Lists that are taken district by district, and of each
/// as they were passed, are in one order for any number of threads.
class Retention
{
public:
  virtual ~Retention() = default;

  /// Whether the inside of faces must be complete within a distance limit, not only their vertices.
  virtual bool needsInside() const = 0;
  /// No path that is longer matters: the front stops when all that is nearer is done, with the
  /// bits of a front that goes everywhere. May fall as the front goes on. Other than with a
  /// distance limit, faces need not be complete.
  virtual double reach() const { return Infinity; }
  /// Before the first batch.
  virtual void setNumberOfDistricts(std::size_t) {}
  /// The sources that lie in faces, before the first batch.
  virtual void start(const std::vector<SourceInFace>&) {}
  /// Takes a list over. Its block is the retention's from now on; the pool is the calling task's.
  ///
  /// \param batch number of the batch, ascending.
  virtual void pass(std::size_t district, const PassedList& list, Id batch, WindowPool& pool) = 0;
  /// A vertex that was processed has got a smaller distance.
  virtual void shortenDistance(Id) {}
  /// A batch has ended.
  virtual void advance(const FrontState&) {}
  /// The front has come to its end.
  virtual void finish(const FrontState&) {}
};

/// Keeps no windows: distances at vertices, in the least memory.
class KeepNone : public Retention
{
public:
  bool needsInside() const override { return false; }
  void pass(std::size_t, const PassedList& list, Id, WindowPool& pool) override
  {
    pool.free(list.windows);
  }
};

/// Keeps the windows of some faces: the distance can be evaluated, and paths begin, in these.
class KeepFaces : public Retention
{
public:
  /// \param faces whether the windows of each face are kept; empty: of all.
  KeepFaces(const TriangleMesh& mesh, std::vector<std::uint8_t> faces)
    : mesh_(mesh)
  {
    this->kept_.faces = std::move(faces);
  }

  bool needsInside() const override { return true; }
  void setNumberOfDistricts(std::size_t count) override { this->passed_.resize(count); }
  void pass(std::size_t district, const PassedList& list, Id batch, WindowPool& pool) override
  {
    if (this->kept_.faces.empty() || this->kept_.faces[TriangleMesh::faceOf(list.halfedge)])
    {
      this->passed_[district].add(list.halfedge, list.windows.range(), batch);
    }
    pool.free(list.windows);
  }
  void finish(const FrontState&) override
  {
    for (WindowArchive& passed : this->passed_)
    {
      this->kept_.windows.take(passed);
    }
    this->kept_.windows.index(this->mesh_.numberOfHalfedges());
  }

  KeptWindows release() { return std::move(this->kept_); }

protected:
  const TriangleMesh& mesh() const { return this->mesh_; }
  /// Before the front begins.
  void keep(Id face) { this->kept_.faces[face] = 1; }

private:
  const TriangleMesh& mesh_;
  std::vector<WindowArchive> passed_;
  KeptWindows kept_;
};

/// Keeps all windows: the distance can be evaluated at any surface point, and paths traced.
class KeepAll : public KeepFaces
{
public:
  explicit KeepAll(const TriangleMesh& mesh)
    : KeepFaces(mesh, {})
  {
  }
};

}

#endif
