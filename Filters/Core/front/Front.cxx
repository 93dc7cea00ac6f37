// SPDX-License-Identifier: BSD-3-Clause
#include "front/Front.h"

#include "Errors.h"
#include "front/BatchTasks.h"
#include "front/CompleteFaces.h"
#include "front/FrontExchange.h"
#include "front/FrontProgress.h"
#include "front/FrontWorker.h"
#include "front/Outbox.h"
#include "front/VertexSchedule.h"
#include "front/VertexStates.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// The front (paper, section 3.1, in the order of Qin et al. 2016): the queue holds vertices;
/// windows wait in sorted lists on halfedges, and a list goes through its face when the vertex
/// opposite is processed.
///
/// Vertices are processed in batches of nearly equal distance. A batch has three steps: (1) and (2)
/// are those of BatchTasks, in parallel; (3) what they found is committed, one after another in an
/// order that does not depend on how the tasks were run: distances are shortened, new lists are
/// linked to the vertices they face, and the schedule is filled.
///
/// Where ranks have the surface together, a batch is a superstep with two exchanges: of windows and
/// distances after (1), of distances and of what comes next after (3). All ranks have the same key
/// and the same last key of a batch.
class Front
{
public:
  Front(const TriangleMesh& mesh, const FrontOptions& options, Retention& retention);

  /// Takes the sources' windows along; ends with SourceError where there are none, on no rank.
  FrontResult run(SourceWindows sources);

private:
  void start(SourceWindows initial);
  void startVertices(const SourceWindows& initial);
  void startFaces(const SourceWindows& initial);
  void addSourcesInHalo(const std::vector<SourceInFace>& inHalo);
  void advance(double limit);
  bool moveOn(double limit);
  bool isSettled();
  bool isAnyWithin(double reach);
  bool isWithin(Id vertex, double reach) const;
  void runBatch();
  template <typename Item>
  void runTasks(std::size_t items, Item&& item);
  void tellUpdates(std::vector<DistanceUpdate> FrontWorker::*updates);
  void exchangeLists();
  void collectOutbox();

  void commit();
  void commitVertices();
  void commitUpdates(std::vector<DistanceUpdate> FrontWorker::*updates);
  void commitLists();
  void exchangeArrivals();
  void shorten(const DistanceUpdate& update);
  FrontState state();

  void finishLimited();
  void flush(double bound);
  std::vector<Id> verticesWithListsWithin(double bound) const;
  void finish();

  const TriangleMesh& mesh_;
  const FrontOptions& options_;
  Retention& retention_;
  FrontResult result_;

  VertexStates vertices_;
  VertexSchedule schedule_;
  WaitingLists waiting_;
  CompleteFaces complete_;
  BatchTasks tasks_;
  FrontWorkers workers_;
  Outbox outbox_;
  FrontExchange ranks_;
  FrontProgress progress_;

  /// The vertices of the batch at hand, and how many batches there were.
  std::vector<Id> batch_;
  Id batches_ = 0;
  /// What comes next over all ranks, and the largest reach of their retentions.
  VertexSchedule::Outlook next_;
  double reach_ = Infinity;
  /// A vertex that was last found to have something within the retention's reach.
  Id unsettled_ = NoId;
  std::vector<WindowPool*> pools_;
};

Front::Front(const TriangleMesh& mesh, const FrontOptions& options, Retention& retention)
  : mesh_(mesh)
  , options_(options)
  , retention_(retention)
  , vertices_(mesh, options.relativeError > 0.0, options.keepArrivals)
  , schedule_(vertices_)
  , waiting_(mesh.numberOfHalfedges())
  , complete_(mesh, options.part, options.maximumDistance)
  , tasks_(mesh, options, vertices_, complete_, waiting_, retention)
  , ranks_(options.part)
  , progress_(options.progress, mesh.numberOfVertices(), options.maximumDistance)
{
}

FrontResult Front::run(SourceWindows sources)
{
  this->start(std::move(sources));
  this->progress_.report(this->schedule_.key());
  this->advance(this->options_.maximumDistance);
  this->progress_.report(this->schedule_.key());
  if (this->complete_.isLimited())
  {
    this->finishLimited();
  }
  this->finish();
  return std::move(this->result_);
}

void Front::start(SourceWindows initial)
{
  if (!this->ranks_.isTrueAnywhere(!initial.inFaces.empty() || !initial.vertices.empty()))
  {
    throw SourceError("There is no source. Give at least one point on the surface.");
  }
  this->startVertices(initial);
  this->startFaces(initial);
  for (const LeavingWindow& leaving : initial.windows)
  {
    this->tasks_.send(
      this->workers_.first(), leaving.halfedge, { &leaving.window, &leaving.window + 1 });
  }
  this->result_.sourcesInFaces = std::move(initial.inFaces);
  this->retention_.setNumberOfWorkers(this->workers_.size());
  this->retention_.start(this->result_.sourcesInFaces);
  this->addSourcesInHalo(initial.inHalo);
  this->batch_.clear();
  this->runBatch();
}

void Front::startVertices(const SourceWindows& initial)
{
  for (const Id vertex : initial.vertices)
  {
    this->vertices_[vertex].emission =
      Emission::Nothing; // the curve's own wedges are there already
    this->shorten({ vertex, 0.0, 0.0, {} });
  }
  // Also on a curve: a wedge there may be bounded by a segment of a rounding's length.
  for (const Id vertex : initial.nearVertices)
  {
    this->vertices_[vertex].emission = Emission::Everywhere;
  }
}

void Front::startFaces(const SourceWindows& initial)
{
  const Id numberOfVertices = this->options_.part ? this->options_.part->numberOfVerticesOfWhole()
                                                  : this->mesh_.numberOfVertices();
  for (const SourceInFace& source : initial.inFaces)
  {
    const Triangle& corners = this->mesh_.triangle(source.face);
    const Id origin = CurveSide{ source.curve, false }.origin(numberOfVertices);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const DistanceUpdate found = { corners[k],
        distanceToSource(this->mesh_, source, cornerWeights(k)), 0.0, { NoId, origin } };
      this->shorten(found);
      if (!this->ranks_.isAlone())
      {
        this->ranks_.tell(found);
      }
    }
    if (this->complete_.isLimited())
    {
      this->complete_.add(source.face);
    }
  }
}

void Front::addSourcesInHalo(const std::vector<SourceInFace>& inHalo)
{
  if (inHalo.empty())
  {
    return; // the others are in the order of their faces
  }
  std::vector<SourceInFace>& sources = this->result_.sourcesInFaces;
  sources.insert(sources.end(), inHalo.begin(), inHalo.end());
  std::stable_sort(sources.begin(), sources.end(),
    [](const SourceInFace& a, const SourceInFace& b) { return a.face < b.face; });
}

void Front::advance(double limit)
{
  while (this->moveOn(limit) && !this->isSettled())
  {
    this->schedule_.takeBatch(std::min(limit, this->next_.last), this->batch_);
    this->runBatch();
    this->progress_.afterBatch(this->batch_.size(), this->schedule_.key());
  }
}

// Moves on to the next batch; false where no vertex waits up to the limit.
bool Front::moveOn(double limit)
{
  if (this->ranks_.isAlone())
  {
    this->next_ = this->schedule_.outlook();
    this->reach_ = this->retention_.reach();
  }
  const double least = this->next_.least;
  if (!(least <= limit) || least == Infinity)
  {
    return false;
  }
  this->schedule_.moveOn(least);
  return true;
}

// Whether nothing is left within the retention's reach. Windows there may still wait for a far
// vertex: the front goes on in its order until they are through, so that distances within the reach
// are those of a front that goes everywhere, to the last bit.
bool Front::isSettled()
{
  return this->schedule_.key() > this->reach_ &&
    !this->ranks_.isTrueAnywhere(this->isAnyWithin(this->reach_));
}

bool Front::isAnyWithin(double reach)
{
  if (this->unsettled_ != NoId && this->isWithin(this->unsettled_, reach))
  {
    return true;
  }
  this->unsettled_ = NoId;
  return this->schedule_.isAnyWaiting(
    [&](Id vertex)
    {
      const bool isWithin = this->isWithin(vertex, reach);
      this->unsettled_ = isWithin ? vertex : this->unsettled_;
      return isWithin;
    });
}

// Whether a vertex that waits has windows within a distance, or will emit some.
bool Front::isWithin(Id vertex, double reach) const
{
  const VertexState& state = this->vertices_[vertex];
  bool isWithin = state.isShorter() && state.distance <= reach;
  for (Id halfedge = state.facing; halfedge != NoId && !isWithin;
       halfedge = this->waiting_.next(halfedge))
  {
    const WindowRange list = this->waiting_.at(halfedge);
    isWithin = std::any_of(
      list.begin(), list.end(), [reach](const Window& w) { return w.minimum() <= reach; });
  }
  return isWithin;
}

void Front::runBatch()
{
  ++this->batches_;
  constexpr std::size_t ahead = 4; // items whose faces are fetched while others are worked on
  this->runTasks(this->batch_.size(),
    [this](FrontWorker& worker, std::size_t i)
    {
      if (i + ahead < this->batch_.size())
      {
        this->tasks_.prefetchFacing(this->batch_[i + ahead]);
      }
      this->tasks_.process(worker, this->batch_[i], this->batches_);
    });
  if (!this->ranks_.isAlone())
  {
    this->exchangeLists();
  }
  this->collectOutbox();
  this->runTasks(this->outbox_.numberOfGroups(),
    [this](FrontWorker& worker, std::size_t i)
    {
      if (i + ahead < this->outbox_.numberOfGroups())
      {
        this->tasks_.prefetchReceiver(this->outbox_.halfedge(i + ahead));
      }
      this->tasks_.receive(worker, this->outbox_, i);
    });
  this->commit();
}

template <typename Item>
void Front::runTasks(std::size_t items, Item&& item)
{
  const bool parallel = static_cast<bool>(this->options_.parallelFor);
  const std::size_t tasks = FrontWorkers::numberOfTasks(items, parallel);
  if (this->workers_.size() < tasks)
  {
    this->workers_.resize(tasks);
    this->retention_.setNumberOfWorkers(tasks);
  }
  this->workers_.run(items, tasks, this->options_.parallelFor, item);
}

void Front::tellUpdates(std::vector<DistanceUpdate> FrontWorker::*updates)
{
  for (const FrontWorker& worker : this->workers_)
  {
    for (const DistanceUpdate& update : worker.*updates)
    {
      this->ranks_.tell(update);
    }
  }
}

void Front::exchangeLists()
{
  for (FrontWorker& worker : this->workers_)
  {
    this->ranks_.take(worker.sent, worker.pool);
  }
  this->tellUpdates(&FrontWorker::updates);
  FrontWorker& first = this->workers_.first();
  FrontWorker& last = *(this->workers_.end() - 1);
  std::vector<double> nothing;
  const FrontExchange::Received received = this->ranks_.step(nothing, first.pool);
  last.sent.insert(last.sent.end(), received.lists.begin(), received.lists.end());
  // All ranks take distances over in one order, so that equal paths are told apart alike.
  first.updates.insert(first.updates.begin(), received.fromLower.begin(), received.fromLower.end());
  last.updates.insert(last.updates.end(), received.fromHigher.begin(), received.fromHigher.end());
}

void Front::collectOutbox()
{
  this->outbox_.clear();
  for (FrontWorker& worker : this->workers_)
  {
    this->outbox_.take(worker.sent);
  }
  this->outbox_.group();
}

// Step by step over all workers, so that the order is the same however many there are: it decides
// between equal paths.
void Front::commit()
{
  this->commitVertices();
  this->commitUpdates(&FrontWorker::updates);
  if (!this->ranks_.isAlone())
  {
    this->tellUpdates(&FrontWorker::arrivals);
  }
  this->commitUpdates(&FrontWorker::arrivals);
  this->commitLists();
  for (FrontWorker& worker : this->workers_)
  {
    for (const Id halfedge : worker.withinLimit)
    {
      this->complete_.addAround(halfedge);
    }
    worker.withinLimit.clear();
  }
  if (!this->ranks_.isAlone())
  {
    this->exchangeArrivals();
  }
  this->retention_.advance(this->state());
}

// A vertex that another rank tells of waits there with the same key: what comes next is known
// before it is told.
void Front::exchangeArrivals()
{
  this->next_ = this->schedule_.outlook();
  std::vector<double> least = { this->next_.least, this->next_.last, -this->retention_.reach() };
  const FrontExchange::Received received = this->ranks_.step(least, this->workers_.first().pool);
  this->next_ = { least[0], least[1] };
  this->reach_ = -least[2];
  for (const auto* updates : { &received.fromLower, &received.fromHigher })
  {
    for (const DistanceUpdate& update : *updates)
    {
      this->shorten(update);
    }
  }
}

void Front::commitVertices()
{
  for (const Id vertex : this->batch_)
  {
    VertexState& state = this->vertices_[vertex];
    this->progress_.settle(state.processed == Infinity ? 1 : 0);
    state.processed = std::min(state.processed, state.distance);
    state.facing = NoId; // its lists are through; tasks look ahead at it
  }
}

void Front::commitUpdates(std::vector<DistanceUpdate> FrontWorker::*updates)
{
  for (FrontWorker& worker : this->workers_)
  {
    for (const DistanceUpdate& update : worker.*updates)
    {
      this->shorten(update);
    }
    (worker.*updates).clear();
  }
}

void Front::shorten(const DistanceUpdate& update)
{
  const VertexState& state = this->vertices_[update.vertex];
  if (!this->vertices_.shorten(update) || !state.isShorter())
  {
    return;
  }
  if (state.processed < Infinity)
  {
    this->retention_.shortenDistance(update.vertex);
  }
  if (!this->tasks_.isOutsideCorridor(update.vertex))
  {
    this->schedule_.add(update.vertex);
  }
}

void Front::commitLists()
{
  for (const FrontWorker& worker : this->workers_)
  {
    for (const Id halfedge : worker.newLists)
    {
      Id& facing = this->vertices_[this->mesh_.opposite(halfedge)].facing;
      this->waiting_.setNext(halfedge, facing);
      facing = halfedge;
    }
  }
  for (std::vector<Id> FrontWorker::*lists : { &FrontWorker::newLists, &FrontWorker::changedLists })
  {
    for (FrontWorker& worker : this->workers_)
    {
      for (const Id halfedge : worker.*lists)
      {
        this->schedule_.add(this->mesh_.opposite(halfedge));
      }
      (worker.*lists).clear();
    }
  }
}

FrontState Front::state()
{
  this->pools_.clear();
  for (FrontWorker& worker : this->workers_)
  {
    this->pools_.push_back(&worker.pool);
  }
  return { this->schedule_.key(), this->batch_, this->vertices_.distances(),
    this->vertices_.processed(), this->pools_ };
}

// A face with a point within the limit has exact values when no waiting window and no pseudo-source
// is nearer than the farthest of them.
void Front::finishLimited()
{
  this->flush(this->complete_.limit());
  this->complete_.addAroundReachedVertices(this->vertices_);
  this->ranks_.shareNeeded(this->complete_);
  this->flush(this->ranks_.largestOf(
    this->complete_.neededDistance(this->vertices_, this->retention_.needsInside())));
  for (const Id halfedge : this->waiting_.halfedges())
  {
    this->tasks_.retire(this->workers_.first(), halfedge,
      { this->vertices_.distance(this->mesh_.origin(halfedge)),
        this->vertices_.distance(this->mesh_.destination(halfedge)) },
      this->batches_);
  }
  std::vector<std::uint8_t> complete = this->complete_.completeVertices();
  this->ranks_.shareMarks(complete);
  for (Id vertex = 0; vertex < this->vertices_.size(); ++vertex)
  {
    if (!complete[vertex])
    {
      this->vertices_[vertex].distance = Infinity;
    }
  }
}

// Sends on every window and pseudo-source nearer than the bound, also those that would wait for a
// far vertex.
void Front::flush(double bound)
{
  do
  {
    this->advance(bound);
    this->batch_ = this->verticesWithListsWithin(bound);
    this->runBatch();
    this->progress_.report(this->schedule_.key());
  } while (this->ranks_.isTrueAnywhere(!this->batch_.empty()));
}

std::vector<Id> Front::verticesWithListsWithin(double bound) const
{
  std::vector<Id> vertices;
  for (const Id halfedge : this->waiting_.halfedges())
  {
    const WindowRange list = this->waiting_.at(halfedge);
    const bool within = std::any_of(
      list.begin(), list.end(), [bound](const Window& w) { return w.minimum() <= bound; });
    if (within)
    {
      vertices.push_back(this->mesh_.opposite(halfedge));
    }
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

void Front::finish()
{
  this->waiting_ = WaitingLists(0);
  this->result_.completeFaces = this->complete_.release();
  this->result_.vertexDistances.reserve(this->vertices_.size());
  for (Id vertex = 0; vertex < this->vertices_.size(); ++vertex)
  {
    this->result_.vertexDistances.push_back(this->vertices_.distance(vertex));
  }
  this->result_.part = this->options_.part;
  this->ranks_.completeHalo(this->result_.vertexDistances);
  this->result_.arrivals = this->vertices_.releaseArrivals();
  for (const FrontWorker& worker : this->workers_)
  {
    this->result_.windowsPropagated += worker.propagated;
    this->result_.relativeErrorBound =
      std::max(this->result_.relativeErrorBound, worker.relativeError);
  }
  this->result_.windowsPropagated = this->ranks_.sumOf(this->result_.windowsPropagated);
  this->result_.relativeErrorBound = this->ranks_.largestOf(this->result_.relativeErrorBound);
  this->retention_.finish(this->state());
}

} // anonymous namespace

FrontResult propagate(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  const FrontOptions& options, Retention& retention)
{
  // Short beside what follows: it can be stopped, and counts as no progress.
  return propagate(mesh,
    makeSourceWindows(
      mesh, sources, [&](double) { return !options.progress || options.progress(0.0); }),
    options, retention);
}

FrontResult propagate(const TriangleMesh& mesh, SourceWindows sources, const FrontOptions& options,
  Retention& retention)
{
  if (!(options.relativeError >= 0.0) || !(options.relativeError < Infinity))
  {
    throw Error("The relative error is " + std::to_string(options.relativeError) +
      "; give a number of at least 0.");
  }
  return Front(mesh, options, retention).run(std::move(sources));
}

}
