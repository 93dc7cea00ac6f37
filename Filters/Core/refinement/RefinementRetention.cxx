// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RefinementRetention.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

RefinementRetention::RefinementRetention(const MeshPartition& surface, double tolerance,
  const std::vector<std::uint8_t>& pinned, const FrontOptions& options)
  : surface_(surface)
  , mesh_(surface_.mesh())
  , parallelFor_(options.parallelFor)
  , progress_(paced(options.progress))
  , tolerance_(tolerance)
  , test_(mesh_, tolerance)
  , state_(mesh_.numberOfFaces(), State::Open)
  , above_(mesh_.numberOfFaces(), 0.0F)
  , neededBy_(mesh_.numberOfFaces(), 0)
  , lists_(mesh_.numberOfFaces())
{
  forRanges(this->parallelFor_, mesh_.numberOfFaces(),
    [&](std::size_t begin, std::size_t end)
    {
      for (Id face = static_cast<Id>(begin); face < end; ++face)
      {
        this->forEachNeighbour(face, [this, face](Id) { ++this->neededBy_[face]; });
        if (pinned[face] || !this->surface_.isOwn(face))
        {
          this->state_[face] = State::Kept;
        }
      }
    });
}

// Across the edges; once for each shared edge.
template <typename Visit>
void RefinementRetention::forEachNeighbour(Id face, Visit&& visit) const
{
  for (Id halfedge = 3 * face; halfedge < 3 * face + 3; ++halfedge)
  {
    for (Id s = this->mesh_.nextSibling(halfedge); s != halfedge; s = this->mesh_.nextSibling(s))
    {
      visit(TriangleMesh::faceOf(s));
    }
  }
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
  this->passed_[district].push_back(this->test_.measure(list));
}

std::array<double, 3> RefinementRetention::atCorners(Id face, const VertexNumbers& numbers) const
{
  const Triangle& t = this->mesh_.triangle(face);
  return { numbers(t[0]), numbers(t[1]), numbers(t[2]) };
}

double RefinementRetention::largestAtCorners(Id face, const VertexNumbers& numbers) const
{
  const std::array<double, 3> n = this->atCorners(face, numbers);
  return std::max({ n[0], n[1], n[2] });
}

void RefinementRetention::takePassed(const FrontState& front)
{
  for (std::size_t district = 0; district < this->passed_.size(); ++district)
  {
    for (const MeasuredList& measured : this->passed_[district])
    {
      this->take(measured, front);
    }
    this->passed_[district].clear();
  }
}

void RefinementRetention::take(const MeasuredList& measured, const FrontState& front)
{
  const Id face = TriangleMesh::faceOf(measured.list.halfedge);
  if (this->isLinear(face))
  {
    this->testAgain(face, measured.list, front.distances);
  }
  if (this->state_[face] == State::Dropped)
  {
    front.free(measured.list.windows);
  }
  else
  {
    this->add(measured);
  }
}

void RefinementRetention::add(const MeasuredList& measured)
{
  MeasuredLists& lists = this->lists_[TriangleMesh::faceOf(measured.list.halfedge)];
  auto last = lists.before_begin();
  for (auto next = lists.begin(); next != lists.end(); ++next)
  {
    last = next;
  }
  if (this->unusedLists_.empty())
  {
    lists.insert_after(last, measured);
    return;
  }
  this->unusedLists_.front() = measured;
  lists.splice_after(last, this->unusedLists_, this->unusedLists_.before_begin());
}

void RefinementRetention::testAgain(Id face, const PassedList& late, const VertexNumbers& distances)
{
  const double bound =
    this->test_.boundWith(late, this->above_[face], this->atCorners(face, distances));
  if (bound <= this->tolerance_)
  {
    this->raiseBound(bound);
  }
  else
  {
    this->keep(face);
  }
}

void RefinementRetention::raiseBound(double bound)
{
  this->kept_.droppedErrorBound = std::max(this->kept_.droppedErrorBound, bound);
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
    this->droppedTooEarly_.push_back(face);
  }
  this->state_[face] = State::Kept;
}

void RefinementRetention::advance(const FrontState& front)
{
  this->takePassed(front);
  for (const Id vertex : front.settled)
  {
    this->awaitFacesAround(vertex, front.processed);
  }
  while (!this->awaited_.empty() && this->awaited_.top().first < front.key)
  {
    const Id face = this->awaited_.top().second;
    this->awaited_.pop();
    if (this->isOpen(face))
    {
      this->due_.push_back(face);
    }
  }
  this->testDue(front);
}

// Late lists are seldom more than an edge behind the front, and a face dropped too early costs a
// solve.
void RefinementRetention::awaitFacesAround(Id vertex, const VertexNumbers& processed)
{
  for (const Id corner : this->mesh_.cornersAt(vertex))
  {
    const Id face = TriangleMesh::faceOf(corner);
    const double largest = this->largestAtCorners(face, processed);
    if (this->state_[face] == State::Open && largest < Infinity)
    {
      constexpr double edges = 2.0;
      this->state_[face] = State::Awaited;
      this->awaited_.push({ largest + edges * this->mesh_.shape(face).longest(), face });
    }
  }
}

// Many faces may be due at once, and a test takes long where faces have very many windows. Tests
// run in parallel, as each reads the face's own lists; their consequences follow in a fixed order.
void RefinementRetention::testDue(const FrontState& front)
{
  const double known = this->kept_.droppedErrorBound;
  this->results_.resize(this->due_.size());
  forItems(
    this->parallelFor_, this->due_.size(), [this]() { reportProgress(this->progress_, 0.0); },
    [](std::size_t) {},
    [&](std::size_t, std::size_t i)
    {
      const Id face = this->due_[i];
      this->results_[i] =
        this->test_.test(face, this->atCorners(face, front.distances), this->lists_[face], known);
    });
  for (std::size_t i = 0; i < this->due_.size(); ++i)
  {
    this->take(this->due_[i], this->results_[i], front);
  }
  this->due_.clear();
}

// If it is split once, a face requires its neighbours only to be halved.
void RefinementRetention::take(
  Id face, const LinearFaceTest::Result& result, const FrontState& front)
{
  const bool isKnown = result.byBand.bound <= this->kept_.droppedErrorBound;
  const LinearFaceTest::Sum& sum = isKnown ? result.byBand : result.byWindows;
  const bool isLinear = sum.bound <= this->tolerance_;
  this->state_[face] = isLinear ? State::Linear : State::Kept;
  if (isLinear)
  {
    this->above_[face] = sum.above;
    this->raiseBound(sum.bound);
  }
  if (isLinear || result.isSplitOnce)
  {
    this->doWithoutNeighbours(face, front);
  }
}

// The face does not need its neighbours' windows.
void RefinementRetention::doWithoutNeighbours(Id face, const FrontState& front)
{
  this->dropIfUnneeded(face, front);
  this->forEachNeighbour(face,
    [&](Id neighbour)
    {
      --this->neededBy_[neighbour];
      this->dropIfUnneeded(neighbour, front);
    });
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
    this->unusedLists_.splice_after(this->unusedLists_.before_begin(), this->lists_[face]);
  }
}

void RefinementRetention::finish(const FrontState& front)
{
  this->takePassed(front);
  for (Id face = 0; face < this->mesh_.numberOfFaces(); ++face)
  {
    if (this->isOpen(face) && this->largestAtCorners(face, front.distances) < Infinity)
    {
      this->due_.push_back(face);
    }
  }
  this->testDue(front);
  this->handOver(front);
}

void RefinementRetention::handOver(const FrontState& front)
{
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

}
