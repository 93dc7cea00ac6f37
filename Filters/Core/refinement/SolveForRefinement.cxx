// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/SolveForRefinement.h"

#include <algorithm>

namespace geodesic
{

namespace
{

// Across the edges; once for each shared edge.
template <typename Visit>
void forEachNeighbour(const TriangleMesh& mesh, Id face, const Visit& visit)
{
  for (const Id halfedge : TriangleMesh::halfedgesOf(face))
  {
    for (Id s = mesh.nextSibling(halfedge); s != halfedge; s = mesh.nextSibling(s))
    {
      visit(TriangleMesh::faceOf(s));
    }
  }
}

std::array<double, 3> atCorners(const TriangleMesh& mesh, Id face, const VertexNumbers& numbers)
{
  const Triangle& t = mesh.triangle(face);
  return { numbers(t[0]), numbers(t[1]), numbers(t[2]) };
}

double largestAtCorners(const TriangleMesh& mesh, Id face, const VertexNumbers& numbers)
{
  const std::array<double, 3> n = atCorners(mesh, face, numbers);
  return std::max({ n[0], n[1], n[2] });
}

} // anonymous namespace

RefinementRetention::RefinementRetention(
  const MeshPartition& surface, double tolerance, const PinnedFaces& pinned, const Job& job)
  : surface_(surface)
  , mesh_(surface_.mesh())
  , job_(job)
  , tolerance_(tolerance)
  , state_(mesh_.numberOfFaces(), State::Open)
  , neededBy_(mesh_.numberOfFaces(), 0)
  , lists_(mesh_.numberOfFaces(), &memory_)
{
  this->job_.part(0.0, 0.0).loop(mesh_.numberOfFaces(),
    [&](std::size_t i)
    {
      const Id face = static_cast<Id>(i);
      forEachNeighbour(this->mesh_, face, [this, face](Id) { ++this->neededBy_[face]; });
      if (pinned[face] || !this->surface_.isOwn(face))
      {
        this->state_[face] = State::Kept;
      }
    });
}

void RefinementRetention::start(std::size_t districts, const std::vector<SourceInFace>& sources)
{
  this->passed_.resize(districts);
  for (const SourceInFace& source : sources)
  {
    this->state_[source.face] = State::Kept;
  }
}

void RefinementRetention::pass(std::size_t district, const PassedList& list, Id, WindowPool&)
{
  this->passed_[district].push_back(measuredList(this->mesh_, list, this->tolerance_));
}

void RefinementRetention::takePassed()
{
  for (std::vector<MeasuredList>& passed : this->passed_)
  {
    for (const MeasuredList& measured : passed)
    {
      const Id face = TriangleMesh::faceOf(measured.list.halfedge);
      if (this->isLinear(face))
      {
        this->keep(face); // tested too early
      }
      this->lists_[face].reserve(3); // mostly one for each halfedge
      this->lists_[face].push_back(measured);
    }
    passed.clear();
  }
}

void RefinementRetention::shortenDistance(Id vertex)
{
  for (const Id corner : this->mesh_.cornersAt(vertex))
  {
    const Id face = TriangleMesh::faceOf(corner);
    if (this->isLinear(face))
    {
      this->keep(face);
    }
  }
}

void RefinementRetention::keep(Id face)
{
  if (this->state_[face] == State::Dropped)
  {
    this->missing_.push_back(face);
  }
  this->state_[face] = State::Kept;
}

// Late lists are seldom more than an edge behind the front, and a face dropped too early costs a
// solve.
void RefinementRetention::advance(const FrontState& front)
{
  constexpr double edges = 2.0;
  this->takePassed();
  for (const Id vertex : front.settled)
  {
    for (const Id corner : this->mesh_.cornersAt(vertex))
    {
      const Id face = TriangleMesh::faceOf(corner);
      const double largest = largestAtCorners(this->mesh_, face, front.processed);
      if (this->state_[face] == State::Open && largest < Infinity)
      {
        this->state_[face] = State::Awaited;
        this->awaited_.push({ largest + edges * this->mesh_.shape(face).longest(), face });
      }
    }
  }
  std::vector<Id> due;
  while (!this->awaited_.empty() && this->awaited_.top().first < front.key)
  {
    const Id face = this->awaited_.top().second;
    this->awaited_.pop();
    if (this->isOpen(face))
    {
      due.push_back(face);
    }
  }
  this->test(due, front);
}

// Many faces may be due at once, and a test takes long where faces have very many windows. Tests
// run in parallel, as each reads the face's own lists; their consequences follow in a fixed order.
void RefinementRetention::test(const std::vector<Id>& due, const FrontState& front)
{
  const double known = this->kept_.droppedErrorBound;
  std::vector<LinearFaceTest> results(due.size());
  this->job_.loopByTasks(due.size(),
    [&](std::size_t, std::size_t i)
    {
      const Id face = due[i];
      results[i] = testLinear(this->mesh_, face, atCorners(this->mesh_, face, front.distances),
        this->lists_[face], this->tolerance_, known);
    });
  for (std::size_t i = 0; i < due.size(); ++i)
  {
    this->take(due[i], results[i], front);
  }
}

// If it is split once, a face requires its neighbours only to be halved, and does not need their
// windows.
void RefinementRetention::take(Id face, const LinearFaceTest& result, const FrontState& front)
{
  const bool isLinear = result.bound < Infinity;
  this->state_[face] = isLinear ? State::Linear : State::Kept;
  if (isLinear)
  {
    this->kept_.droppedErrorBound = std::max(this->kept_.droppedErrorBound, result.bound);
  }
  if (isLinear || result.isSplitOnce)
  {
    this->dropIfUnneeded(face, front);
    forEachNeighbour(this->mesh_, face,
      [&](Id neighbour)
      {
        --this->neededBy_[neighbour];
        this->dropIfUnneeded(neighbour, front);
      });
  }
}

void RefinementRetention::dropIfUnneeded(Id face, const FrontState& front)
{
  if (this->state_[face] == State::Linear && this->neededBy_[face] == 0)
  {
    this->state_[face] = State::Dropped;
    for (const MeasuredList& measured : this->lists_[face])
    {
      front.free(measured.list.windows);
    }
    MeasuredLists(&this->memory_).swap(this->lists_[face]);
  }
}

void RefinementRetention::finish(const FrontState& front)
{
  this->takePassed();
  std::vector<Id> due;
  for (Id face = 0; face < this->mesh_.numberOfFaces(); ++face)
  {
    if (this->isOpen(face) && largestAtCorners(this->mesh_, face, front.distances) < Infinity)
    {
      due.push_back(face);
    }
  }
  this->test(due, front);
  this->kept_.faces.resize(this->mesh_.numberOfFaces());
  for (Id face = 0; face < this->mesh_.numberOfFaces(); ++face)
  {
    const bool isKept = this->state_[face] != State::Dropped && this->surface_.isOwn(face);
    this->kept_.faces[face] = isKept ? 1 : 0;
    for (const MeasuredList& measured : this->lists_[face])
    {
      this->kept_.windows.adopt(measured.list.halfedge, measured.list.windows.range());
    }
  }
  for (WindowPool* used : front.pools)
  {
    this->kept_.windows.own(used->release());
  }
  this->kept_.windows.index(this->mesh_.numberOfHalfedges());
  this->kept_.droppedTolerance = this->tolerance_;
}

// The faces at a point then differ by no more than this, and triangles get the rest of the
// tolerance. A larger fraction needs many more triangles, a smaller one more windows.
double maximumMergedFor(double refinementTolerance)
{
  return 0.1 * refinementTolerance;
}

DistanceField solveForRefinement(const MeshPartition& surface, const SourceWindows& sources,
  double refinementTolerance, const FrontOptions& options, PinnedFaces& pinned)
{
  FrontOptions merging = options;
  merging.maximumMerged = std::min(options.maximumMerged, maximumMergedFor(refinementTolerance));
  if (options.relativeError > 0.0)
  {
    return solveKeeping(surface, sources, merging, surface.ownFaces());
  }
  return solveDropping(surface, sources, merging, pinned,
    [&](const PinnedFaces& now)
    { return RefinementRetention(surface, refinementTolerance, now, options.job); });
}

}
