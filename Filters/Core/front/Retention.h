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

/// A list of windows that has passed through its face, and the distances then known at the ends of
/// its halfedge.
struct PassedList
{
  Id halfedge;
  WindowBlock windows;
  std::array<double, 2> ends = {};
};

/// One number per vertex, stored in an array of records.
struct VertexNumbers
{
  const double* first;
  /// Step from one vertex to the next.
  std::size_t stride = 1;
  double operator()(Id vertex) const { return this->first[vertex * this->stride]; }
};

/// The state of the front at the end of a batch.
struct FrontState
{
  /// The key at which the batch began. Shorter paths may still come, by windows that wait for a
  /// far vertex.
  double key;
  /// The vertices of the batch.
  const std::vector<Id>& settled;
  /// The distances found so far, and the distances with which vertices were last processed.
  VertexNumbers distances;
  VertexNumbers processed;
  /// The pools of the blocks of lists, at least one. A block may be freed into any of them.
  const std::vector<WindowPool*>& pools;

  /// Gives a block to the pool that has the fewest of its size: a thread that works more than
  /// others needs more blocks, and blocks of one size do not serve for another.
  void free(const WindowBlock& block) const
  {
    const std::uint32_t sizeClass = block.sizeClass;
    WindowPool* const shortest = *std::min_element(this->pools.begin(), this->pools.end(),
      [sizeClass](const WindowPool* a, const WindowPool* b)
      { return a->freeBlocks(sizeClass) < b->freeBlocks(sizeClass); });
    shortest->free(block);
  }
};

/// The windows that a solve has kept.
struct KeptWindows
{
  /// Indexed, or empty if none were kept.
  WindowArchive windows;
  /// Whether each face has all its windows. Empty if all faces do.
  std::vector<std::uint8_t> faces;
  /// For faces whose windows were dropped: a certified bound of how much any closure by triangles
  /// between points of the edges deviates from the distance, and the requested tolerance.
  double droppedErrorBound = 0.0;
  double droppedTolerance = 0.0;
};

/// Decides what becomes of the windows behind the front. The front hands over each list once it has
/// passed through its face; distances at vertices need none of them.
///
/// The tasks of a batch call pass(), each for its own district (front/Districts.h); one thread
/// makes all other calls between batches. Lists that are read district by district, each in the
/// order of pass(), have the same order for any number of threads.
class Retention
{
public:
  virtual ~Retention() = default;

  /// Whether a distance limit requires the inside of faces to be complete, not only their vertices.
  virtual bool needsInside() const = 0;
  /// Longer paths do not matter: the front stops when everything nearer is done, with the bits of a
  /// front that goes everywhere. The value may decrease as the front proceeds. Unlike with a
  /// distance limit, faces need not be complete.
  virtual double neededDistance() const { return Infinity; }
  /// Called before sources start, with the number of districts and the sources inside faces.
  virtual void start(std::size_t, const std::vector<SourceInFace>&) {}
  /// Takes over a list. Its block now belongs to the retention; the pool is the calling task's.
  ///
  /// \param batch number of the batch, ascending.
  virtual void pass(std::size_t district, const PassedList& list, Id batch, WindowPool& pool) = 0;
  /// A processed vertex has got a smaller distance.
  virtual void shortenDistance(Id) {}
  /// Called after each batch.
  virtual void advance(const FrontState&) {}
  /// Called after the last batch.
  virtual void finish(const FrontState&) {}
};

/// Keeps no windows: for distances at vertices, in the least memory.
class KeepNone : public Retention
{
public:
  bool needsInside() const override { return false; }
  void pass(std::size_t, const PassedList& list, Id, WindowPool& pool) override
  {
    pool.free(list.windows);
  }
};

/// Keeps the windows of all or some faces, in which distances can then be evaluated and paths can
/// be traced.
class KeepFaces : public Retention
{
public:
  /// \param faces whether to keep the windows of each face; empty: of all.
  explicit KeepFaces(const TriangleMesh& mesh, std::vector<std::uint8_t> faces = {})
    : mesh_(mesh)
  {
    this->kept_.faces = std::move(faces);
  }

  bool needsInside() const override { return true; }
  void start(std::size_t districts, const std::vector<SourceInFace>&) override
  {
    this->passed_.resize(districts);
  }
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
  /// To be called before the front begins.
  void keep(Id face) { this->kept_.faces[face] = 1; }

private:
  const TriangleMesh& mesh_;
  std::vector<WindowArchive> passed_;
  KeptWindows kept_;
};

}

#endif
