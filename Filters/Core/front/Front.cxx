// SPDX-License-Identifier: BSD-3-Clause
#include "front/Front.h"

#include "front/Outbox.h"
#include "Errors.h"
#include "window/FacePropagation.h"
#include "front/SaddleWedge.h"
#include "source/SourceWindows.h"
#include "Tolerance.h"
#include "front/VertexQueue.h"
#include "window/WindowList.h"
#include "window/WindowMerge.h"

#include <algorithm>

namespace geodesic
{

/// What the front works with, all of it of this file.
namespace front
{

/// A path to a vertex that may be shorter than those known.
struct DistanceUpdate
{
  Id vertex;
  double distance;
  double error;
  Arrival from;
};

/// What a vertex sends out when the front comes to it.
enum class Emits : std::uint8_t
{
  Nothing,
  /// What no straight continuation of its shortest path lights.
  Wedge,
  Everywhere
};

Emits emitsOf(TriangleMesh::PseudoSource kind)
{
  switch (kind)
  {
    case TriangleMesh::PseudoSource::Saddle:
      return Emits::Wedge;
    case TriangleMesh::PseudoSource::Irregular:
      return Emits::Everywhere;
    default:
      return Emits::Nothing;
  }
}

/// What is known of a vertex, together because it is used together.
struct VertexState
{
  double distance = Infinity;
  /// The distance with which it was last processed, and the key it waits with in the queue.
  double processed = Infinity;
  double key = Infinity;
  /// Where the path behind its distance comes from (an Arrival without its padding).
  double arrivalX = 0.0;
  Id arrivalHalfedge = NoId;
  /// The first of the halfedges opposite it that have a list.
  Id facing = NoId;
  /// The length of some edge at it.
  float edge = 0.0F;
  Emits emits = Emits::Nothing;
};

/// What one task of a batch works with and leaves behind. Nothing in it depends on which thread
/// runs the task.
struct Worker
{
  FacePropagation passage;
  WindowListBuilder merged;
  WindowPool pool;
  std::vector<Window> merging;
  std::vector<EmittedInterval> lit;

  std::vector<Delivery> deliveries;
  /// Found while lists went through faces, and where they arrived.
  std::vector<DistanceUpdate> updates;
  std::vector<DistanceUpdate> arrivals;
  /// Sides whose lists were empty, and those whose lists have grown.
  std::vector<Id> begun;
  std::vector<Id> grown;
  /// Sides with windows within the limit.
  std::vector<Id> withinLimit;
  std::uint64_t propagated = 0;
  double relativeError = 0.0;
};

}

using namespace front;

/// The front (paper, section 3.1, in the order of Qin et al. 2016): the queue holds vertices;
/// windows wait in sorted lists on halfedges, and a list goes through its face when the vertex opposite
/// is popped.
///
/// Vertices are popped in batches of nearly equal distance. A batch has three steps: (1) each
/// vertex sends the lists that face it through their faces, (2) each halfedge that windows were sent to
/// merges them into its list, (3) distances found on the way are taken over and the queue is
/// filled. In (1) and (2) tasks touch only what is theirs, so that they may run at the same time,
/// and the result does not depend on how many do.
class Propagation
{
public:
  Propagation(const TriangleMesh& mesh, const FrontOptions& options, Retention& retention);

  FrontResult run(const std::vector<SourceCurve>& sources);

private:
  void start(const std::vector<SourceCurve>& sources);
  void advance(double limit);
  void popBatch(double limit);
  auto isCurrent() const
  {
    return [this](const VertexQueue::Entry& entry)
    { return entry.key == this->vertices_[entry.vertex].key; };
  }
  // Vertices belong into one batch when none is farther than another by about an edge there: then
  // windows that one sends out seldom come to another. From 0.25 to 2 edges the number of windows
  // hardly changes.
  auto reachOf() const
  {
    return [this](Id vertex) { return 0.5 * static_cast<double>(this->vertices_[vertex].edge); };
  }
  void runBatch();
  void runTasks(std::size_t count, const std::function<void(Worker&, std::size_t)>& item);

  void prefetchFacing(Id vertex) const;
  void prefetchReceiver(Id halfedge) const;
  void process(Worker& worker, Id vertex);
  void relaxEdges(Worker& worker, Id vertex);
  void emit(Worker& worker, Id vertex);
  void emit(Worker& worker, Id vertex, const EmittedInterval& lit);
  void enter(Worker& worker, Id halfedge);
  void merge(Worker& worker, Id halfedge);
  void send(Worker& worker, Id halfedge, const WindowRange& windows);
  void collectDeliveries();
  void receive(Worker& worker, std::size_t group);
  void mergeInto(Worker& worker, Id halfedge, const WindowBlock& block);
  void commit();
  void commitLists();
  void improve(const DistanceUpdate& update);
  void enqueue(Id vertex);
  double errorAt(Id vertex) const;
  VertexNumbers each(double VertexState::*number) const
  {
    static_assert(sizeof(VertexState) % sizeof(double) == 0);
    return { &(this->vertices_.front().*number), sizeof(VertexState) / sizeof(double) };
  }
  FrontState state();
  void reportProgress();
  void tellProgress();

  void finishLimited();
  void flush(double bound);
  double neededDistance() const;
  void dropIncomplete();
  void retire(Worker& worker, Id halfedge, const std::array<double, 2>& ends);
  void finish();

  const TriangleMesh& mesh_;
  const FrontOptions& options_;
  Retention& retention_;
  FrontResult result_;

  std::vector<VertexState> vertices_;
  /// How much longer the path behind a vertex's distance can be; empty in the exact solve.
  std::vector<double> vertexError_;
  /// Vertices beyond the front, and those at it or behind.
  VertexQueue queue_;
  std::vector<Id> behind_;
  WaitingLists waiting_;

  /// The key at which the last batch began.
  double front_ = 0.0;
  std::vector<Worker> workers_;
  std::vector<Id> batch_;
  Outbox outbox_;

  /// With a limit: faces that have a point within it.
  std::vector<std::uint8_t> needed_;
  Id settled_ = 0;
  Id batches_ = 0;
  std::size_t sinceReport_ = 0;
  std::vector<WindowPool*> pools_;
  double reported_ = 0.0;
};

Propagation::Propagation(
  const TriangleMesh& mesh, const FrontOptions& options, Retention& retention)
  : mesh_(mesh)
  , options_(options)
  , retention_(retention)
  , vertices_(mesh.numberOfVertices())
  , waiting_(mesh.numberOfHalfedges())
  , workers_(1)
{
  if (options.relativeError > 0.0)
  {
    this->vertexError_.assign(mesh.numberOfVertices(), 0.0);
  }
  if (options.maximumDistance < Infinity)
  {
    this->needed_.assign(mesh.numberOfFaces(), 0);
  }
}

FrontResult Propagation::run(const std::vector<SourceCurve>& sources)
{
  this->start(sources);
  this->tellProgress();
  this->advance(this->options_.maximumDistance);
  this->tellProgress();
  if (this->options_.maximumDistance < Infinity)
  {
    this->finishLimited();
  }
  this->finish();
  return std::move(this->result_);
}

void Propagation::start(const std::vector<SourceCurve>& sources)
{
  SourceWindows initial = makeSourceWindows(this->mesh_, sources);
  if (initial.inFaces.empty() && initial.vertices.empty())
  {
    throw SourceError("There is no source. Give at least one point on the surface.");
  }
  for (Id v = 0; v < this->mesh_.numberOfVertices(); ++v)
  {
    this->vertices_[v].emits = emitsOf(this->mesh_.pseudoSource(v));
    const IdRange corners = this->mesh_.cornersAt(v);
    this->vertices_[v].edge =
      corners.size() > 0 ? static_cast<float>(this->mesh_.length(*corners.begin())) : 0.0F;
  }
  for (const Id vertex : initial.vertices)
  {
    this->vertices_[vertex].emits = Emits::Nothing; // the curve's own wedges are there already
    this->improve({ vertex, 0.0, 0.0, {} });
  }
  // Also on a curve: a wedge there may be bounded by a segment of a rounding's length.
  for (const Id vertex : initial.nearVertices)
  {
    this->vertices_[vertex].emits = Emits::Everywhere;
  }
  for (const SourceInFace& source : initial.inFaces)
  {
    const Triangle& corners = this->mesh_.triangle(source.face);
    for (std::size_t k = 0; k < 3; ++k)
    {
      std::array<double, 3> corner{};
      corner[k] = 1.0;
      this->improve({ corners[k], distanceToSource(this->mesh_, source, corner), 0.0, {} });
    }
    if (!this->needed_.empty())
    {
      this->needed_[source.face] = 1;
    }
  }
  for (const LeavingWindow& leaving : initial.windows)
  {
    this->send(this->workers_[0], leaving.halfedge, { &leaving.window, &leaving.window + 1 });
  }
  this->result_.sourcesInFaces = std::move(initial.inFaces);
  this->retention_.setNumberOfWorkers(this->workers_.size());
  this->retention_.start(this->result_.sourcesInFaces);
  this->batch_.clear();
  this->runBatch();
}

void Propagation::advance(double limit)
{
  for (;;)
  {
    if (this->behind_.empty())
    {
      const double least = this->queue_.least(this->isCurrent(), this->reachOf());
      if (!(least <= limit) || least == Infinity)
      {
        return;
      }
      this->front_ = std::max(this->front_, least);
    }
    this->popBatch(limit);
    this->runBatch();
    this->reportProgress();
  }
}

void Propagation::popBatch(double limit)
{
  this->batch_.clear();
  double last = limit;
  const auto take = [this](Id vertex)
  {
    this->vertices_[vertex].key = Infinity;
    this->batch_.push_back(vertex);
  };
  const auto reachOf = this->reachOf();
  for (const Id vertex : this->behind_)
  {
    if (this->vertices_[vertex].key == this->front_)
    {
      last = std::min(last, this->front_ + reachOf(vertex));
      take(vertex);
    }
  }
  this->behind_.clear();
  this->queue_.takeBatch(last, this->isCurrent(), reachOf, take);
}

void Propagation::runBatch()
{
  ++this->batches_;
  constexpr std::size_t ahead = 4; // items whose faces are fetched while others are worked on
  this->runTasks(this->batch_.size(),
    [this](Worker& worker, std::size_t i)
    {
      if (i + ahead < this->batch_.size())
      {
        this->prefetchFacing(this->batch_[i + ahead]);
      }
      this->process(worker, this->batch_[i]);
    });
  this->collectDeliveries();
  this->runTasks(this->outbox_.numberOfGroups(),
    [this](Worker& worker, std::size_t i)
    {
      if (i + ahead < this->outbox_.numberOfGroups())
      {
        this->prefetchReceiver(this->outbox_.halfedge(i + ahead));
      }
      this->receive(worker, i);
    });
  this->commit();
}

// Tasks are cut by the number of items alone. Each has a worker of its own.
void Propagation::runTasks(std::size_t count, const std::function<void(Worker&, std::size_t)>& item)
{
  constexpr std::size_t itemsPerTask = 8;
  constexpr std::size_t mostTasks = 32;
  const std::size_t tasks =
    std::clamp<std::size_t>(count / itemsPerTask, 1, this->options_.parallelFor ? mostTasks : 1);
  if (this->workers_.size() < tasks)
  {
    this->workers_.resize(tasks);
    this->retention_.setNumberOfWorkers(tasks);
  }
  const auto run = [&](std::size_t task)
  {
    const std::size_t last = (task + 1) * count / tasks;
    for (std::size_t i = task * count / tasks; i < last; ++i)
    {
      item(this->workers_[task], i);
    }
  };
  if (tasks == 1)
  {
    run(0);
    return;
  }
  this->options_.parallelFor(tasks, run);
}

void Propagation::prefetchFacing(Id vertex) const
{
  const Id halfedge = this->vertices_[vertex].facing;
  if (halfedge != NoId)
  {
    this->prefetchReceiver(halfedge);
  }
}

void Propagation::prefetchReceiver(Id halfedge) const
{
  this->mesh_.prefetch(TriangleMesh::faceOf(halfedge));
  this->waiting_.prefetch(halfedge);
}

void Propagation::process(Worker& worker, Id vertex)
{
  const double distance = this->vertices_[vertex].distance;
  if (distance < this->vertices_[vertex].processed * (1.0 - tolerance::Tie))
  {
    this->relaxEdges(worker, vertex);
    if (this->vertices_[vertex].emits != Emits::Nothing)
    {
      this->emit(worker, vertex);
    }
  }
  for (Id halfedge = this->vertices_[vertex].facing; halfedge != NoId;)
  {
    const Id next = this->waiting_.next(halfedge);
    this->enter(worker, halfedge);
    halfedge = next;
  }
}

// Distances along edges are upper bounds, which the filter can use from the first window on.
void Propagation::relaxEdges(Worker& worker, Id vertex)
{
  const double distance = this->vertices_[vertex].distance;
  const double error = this->errorAt(vertex);
  const auto relax = [&](Id halfedge, Id other, const Arrival& from)
  {
    const double along = distance + this->mesh_.length(halfedge);
    if (along < this->vertices_[other].distance)
    {
      worker.updates.push_back({ other, along, error, from });
    }
  };
  for (const Id corner : this->mesh_.cornersAt(vertex))
  {
    const Id before = TriangleMesh::previousInFace(corner);
    relax(corner, this->mesh_.destination(corner), { before, this->mesh_.length(before) });
    relax(before, this->mesh_.origin(before), { corner, 0.0 });
  }
}

void Propagation::emit(Worker& worker, Id vertex)
{
  const bool wedge = this->vertices_[vertex].emits == Emits::Wedge &&
    findSaddleWedge(this->mesh_, vertex,
      { this->vertices_[vertex].arrivalHalfedge, this->vertices_[vertex].arrivalX }, worker.lit);
  if (!wedge)
  {
    worker.lit.clear();
    for (const Id corner : this->mesh_.cornersAt(vertex))
    {
      worker.lit.push_back({ corner, 0.0, this->mesh_.length(TriangleMesh::nextInFace(corner)) });
    }
  }
  for (const EmittedInterval& lit : worker.lit)
  {
    this->emit(worker, vertex, lit);
  }
}

void Propagation::emit(Worker& worker, Id vertex, const EmittedInterval& lit)
{
  const Id halfedge = TriangleMesh::nextInFace(lit.corner);
  const double length = this->mesh_.length(halfedge);
  if (this->mesh_.isBoundary(halfedge) || !(lit.end - lit.begin > tolerance::LeastWidth * length))
  {
    return;
  }
  Window w = vertexWindow(this->mesh_, lit.corner, this->vertices_[vertex].distance).window;
  w.begin = length - lit.end; // the leaving frame runs against the halfedge
  w.end = length - lit.begin;
  w.error = this->errorAt(vertex);
  const bool useless =
    isBeaten(w, w.end, this->vertices_[this->mesh_.destination(halfedge)].distance + w.end) ||
    isBeaten(w, w.begin, this->vertices_[this->mesh_.origin(halfedge)].distance + (length - w.begin));
  if (!useless)
  {
    this->send(worker, halfedge, { &w, &w + 1 });
  }
}

void Propagation::enter(Worker& worker, Id halfedge)
{
  this->merge(worker, halfedge);
  const WindowRange list = this->waiting_.at(halfedge);
  if (list.size() == 0)
  {
    this->waiting_.clear(halfedge, worker.pool);
    return;
  }
  const UnfoldedFace face = unfold(this->mesh_, halfedge);
  const Id origin = this->mesh_.origin(halfedge);
  const Id destination = this->mesh_.destination(halfedge);
  const Id apex = this->mesh_.opposite(halfedge);

  const ApexDistance view = worker.passage.view(list, face.apex);
  const Window& first = *list.begin();
  const Window& last = *(list.end() - 1);
  const Id left = TriangleMesh::previousInFace(halfedge);
  const Id right = TriangleMesh::nextInFace(halfedge);
  // Along the halfedge: bounds only, no shortest path comes so to a corner.
  const DistanceUpdate found[] = { { origin, first.distance(first.begin) + first.begin, first.error,
                                  {} },
    { destination, last.distance(last.end) + (face.length - last.end), last.error, {} },
    { apex, view.distance, view.error, { halfedge, view.crossing } } };
  for (const DistanceUpdate& update : found)
  {
    if (update.distance < this->vertices_[update.vertex].distance)
    {
      worker.updates.push_back(update);
    }
  }
  const auto known = [&](std::size_t i)
  { return std::min(this->vertices_[found[i].vertex].distance, found[i].distance); };

  worker.passage.pass(list, face, { known(0), known(1), known(2) }, !this->mesh_.isBoundary(left),
    !this->mesh_.isBoundary(right), this->mesh_.numberOfFaces());
  this->retire(worker, halfedge, { known(0), known(1) });
  this->send(worker, left, worker.passage.left());
  this->send(worker, right, worker.passage.right());
}

// A list is merged when it is complete and about to go on, so that each window is once a face.
void Propagation::merge(Worker& worker, Id halfedge)
{
  const WindowRange list = this->waiting_.at(halfedge);
  if (!(this->options_.relativeError > 0.0) || list.size() < 2)
  {
    return;
  }
  std::vector<Window>& merged = worker.merging;
  merged.assign(list.begin(), list.end());
  const double error = mergeNeighbours(
    merged, this->mesh_.length(halfedge), this->options_.relativeError, this->options_.maximumMerged);
  worker.relativeError = std::max(worker.relativeError, error);
  this->waiting_.assign(halfedge, { merged.data(), merged.data() + merged.size() }, worker.pool);
}

// Hands windows, in the leaving frame of the halfedge, to every other face around its edge. Faces of
// opposite orientation run along their common edge in the same direction.
void Propagation::send(Worker& worker, Id halfedge, const WindowRange& windows)
{
  if (windows.size() == 0)
  {
    return;
  }
  for (Id s = this->mesh_.nextSibling(halfedge); s != halfedge; s = this->mesh_.nextSibling(s))
  {
    const WindowBlock block = worker.pool.copyOf(windows);
    if (this->mesh_.origin(s) != this->mesh_.destination(halfedge))
    {
      const double length = this->mesh_.length(halfedge);
      std::reverse(block.data, block.data + block.size);
      std::transform(block.data, block.data + block.size, block.data,
        [length](const Window& w) { return reversed(w, length); });
    }
    worker.deliveries.push_back({ s, block });
  }
}

void Propagation::collectDeliveries()
{
  this->outbox_.clear();
  for (Worker& worker : this->workers_)
  {
    this->outbox_.take(worker.deliveries);
  }
  this->outbox_.group();
}

void Propagation::receive(Worker& worker, std::size_t group)
{
  const Id halfedge = this->outbox_.halfedge(group);
  const Id apex = this->mesh_.opposite(halfedge);
  const Vec2 position = apexOf(this->mesh_, halfedge);
  (this->waiting_.has(halfedge) ? worker.grown : worker.begun).push_back(halfedge);
  this->outbox_.forEach(group,
    [&](const WindowBlock& block)
    {
      const ApexDistance view = quickApexDistance(block.range(), position);
      if (view.distance < this->vertices_[apex].distance)
      {
        worker.arrivals.push_back({ apex, view.distance, view.error, { halfedge, view.crossing } });
      }
      worker.propagated += block.size;
      this->mergeInto(worker, halfedge, block);
    });
}

void Propagation::mergeInto(Worker& worker, Id halfedge, const WindowBlock& block)
{
  if (!this->waiting_.has(halfedge))
  {
    this->waiting_.adopt(halfedge, block);
    return;
  }
  const WindowRange waiting = this->waiting_.at(halfedge);
  worker.merged.reset(this->mesh_.length(halfedge));
  const Window* old = waiting.begin();
  bool lastIsOld = true;
  const auto append = [&](const Window& w, bool isOld)
  {
    if (isOld == lastIsOld)
    {
      worker.merged.append(w);
    }
    else
    {
      worker.merged.appendOfOther(w);
      lastIsOld = isOld;
    }
  };
  for (const Window& w : block.range())
  {
    for (; old != waiting.end() && old->begin <= w.begin; ++old)
    {
      append(*old, true);
    }
    append(w, false);
  }
  for (; old != waiting.end(); ++old)
  {
    append(*old, true);
  }
  worker.pool.free(block);
  this->waiting_.assign(halfedge, worker.merged.range(), worker.pool);
}

// Step by step over all workers, so that the order is the same however many there are: it decides
// between equal paths.
void Propagation::commit()
{
  for (const Id vertex : this->batch_)
  {
    this->settled_ += this->vertices_[vertex].processed == Infinity ? 1 : 0;
    this->vertices_[vertex].processed =
      std::min(this->vertices_[vertex].processed, this->vertices_[vertex].distance);
    this->vertices_[vertex].facing = NoId; // its lists are through; tasks look ahead at it
  }
  for (std::vector<DistanceUpdate> Worker::*step : { &Worker::updates, &Worker::arrivals })
  {
    for (Worker& worker : this->workers_)
    {
      for (const DistanceUpdate& update : worker.*step)
      {
        this->improve(update);
      }
      (worker.*step).clear();
    }
  }
  for (Worker& worker : this->workers_)
  {
    for (const Id halfedge : worker.begun)
    {
      Id& facing = this->vertices_[this->mesh_.opposite(halfedge)].facing;
      this->waiting_.setNext(halfedge, facing);
      facing = halfedge;
    }
  }
  for (std::vector<Id> Worker::*step : { &Worker::begun, &Worker::grown })
  {
    for (Worker& worker : this->workers_)
    {
      for (const Id halfedge : worker.*step)
      {
        this->enqueue(this->mesh_.opposite(halfedge));
      }
      (worker.*step).clear();
    }
  }
  this->commitLists();
}

void Propagation::commitLists()
{
  for (Worker& worker : this->workers_)
  {
    if (!this->needed_.empty())
    {
      for (const Id halfedge : worker.withinLimit)
      {
        this->needed_[TriangleMesh::faceOf(halfedge)] = 1;
      }
      worker.withinLimit.clear();
    }
  }
  this->retention_.advance(this->state());
}

FrontState Propagation::state()
{
  this->pools_.clear();
  for (Worker& worker : this->workers_)
  {
    this->pools_.push_back(&worker.pool);
  }
  return { this->front_, this->batch_, this->each(&VertexState::distance),
    this->each(&VertexState::processed), this->pools_ };
}

double Propagation::errorAt(Id vertex) const
{
  return this->vertexError_.empty() ? 0.0 : this->vertexError_[vertex];
}

void Propagation::improve(const DistanceUpdate& update)
{
  // A linear window's distance may be a rounding below 0 at its source.
  const double distance = std::max(update.distance, 0.0);
  const Id vertex = update.vertex;
  if (!(distance < this->vertices_[vertex].distance))
  {
    return;
  }
  const bool tie = distance >= this->vertices_[vertex].distance * (1.0 - tolerance::Tie);
  this->vertices_[vertex].distance = distance;
  if (!this->vertexError_.empty())
  {
    this->vertexError_[vertex] = update.error;
  }
  if (!tie || this->vertices_[vertex].arrivalHalfedge == NoId)
  {
    this->vertices_[vertex].arrivalHalfedge = update.from.halfedge;
    this->vertices_[vertex].arrivalX = update.from.x;
  }
  if (distance < this->vertices_[vertex].processed * (1.0 - tolerance::Tie))
  {
    if (this->vertices_[vertex].processed < Infinity)
    {
      this->retention_.shortenDistance(vertex);
    }
    this->enqueue(vertex);
  }
}

void Propagation::enqueue(Id vertex)
{
  // Windows that come to a vertex behind the front go on with it, in the same batches.
  const double key = std::max(this->vertices_[vertex].distance, this->front_);
  if (key < this->vertices_[vertex].key)
  {
    this->vertices_[vertex].key = key;
    if (key > this->front_)
    {
      this->queue_.push(key, vertex);
    }
    else
    {
      this->behind_.push_back(vertex);
    }
  }
}

void Propagation::reportProgress()
{
  constexpr std::size_t verticesPerReport = 256;
  this->sinceReport_ += this->batch_.size();
  if (this->sinceReport_ >= verticesPerReport)
  {
    this->sinceReport_ = 0;
    this->tellProgress();
  }
}

void Propagation::tellProgress()
{
  if (!this->options_.progress)
  {
    return;
  }
  const double settled =
    static_cast<double>(this->settled_) / static_cast<double>(this->mesh_.numberOfVertices());
  const double fraction = std::max(settled, this->front_ / this->options_.maximumDistance);
  this->reported_ = std::clamp(fraction, this->reported_, 1.0); // never back
  if (!this->options_.progress(this->reported_))
  {
    throw Aborted();
  }
}

// A face with a point within the limit has exact values when no waiting window and no pseudo-source
// is nearer than the farthest of them.
void Propagation::finishLimited()
{
  const double limit = this->options_.maximumDistance;
  this->flush(limit);
  for (Id f = 0; f < this->mesh_.numberOfFaces(); ++f)
  {
    for (const Id v : this->mesh_.triangle(f))
    {
      if (this->vertices_[v].distance <= limit)
      {
        this->needed_[f] = 1;
      }
    }
  }
  this->flush(this->neededDistance());
  for (const Id halfedge : this->waiting_.halfedges())
  {
    this->retire(this->workers_[0], halfedge,
      { this->vertices_[this->mesh_.origin(halfedge)].distance,
        this->vertices_[this->mesh_.destination(halfedge)].distance });
  }
  this->dropIncomplete();
}

// Sends on every window and pseudo-source nearer than the bound, also those that would wait for a
// far vertex.
void Propagation::flush(double bound)
{
  for (bool again = true; again;)
  {
    this->advance(bound);
    this->batch_.clear();
    for (const Id halfedge : this->waiting_.halfedges())
    {
      const WindowRange list = this->waiting_.at(halfedge);
      const bool within = std::any_of(
        list.begin(), list.end(), [&](const Window& w) { return w.minimum() <= bound; });
      if (within)
      {
        this->batch_.push_back(this->mesh_.opposite(halfedge));
      }
    }
    std::sort(this->batch_.begin(), this->batch_.end());
    this->batch_.erase(std::unique(this->batch_.begin(), this->batch_.end()), this->batch_.end());
    again = !this->batch_.empty();
    this->runBatch();
    this->tellProgress();
  }
}

// How far the front must have come for the needed faces to be complete: to their farthest corner,
// or where the inside counts too, as far as any point of them can be.
double Propagation::neededDistance() const
{
  double bound = 0.0;
  const bool inside = this->retention_.needsInside();
  for (Id f = 0; f < this->mesh_.numberOfFaces(); ++f)
  {
    if (this->needed_[f])
    {
      const Triangle& t = this->mesh_.triangle(f);
      const auto [least, most] = std::minmax({ this->vertices_[t[0]].distance,
        this->vertices_[t[1]].distance, this->vertices_[t[2]].distance });
      const double reach = least + this->mesh_.shape(f).longest();
      bound = std::max(bound, inside ? reach : most);
    }
  }
  return bound;
}

void Propagation::dropIncomplete()
{
  std::vector<std::uint8_t> complete(this->mesh_.numberOfVertices(), 0);
  for (Id f = 0; f < this->mesh_.numberOfFaces(); ++f)
  {
    for (const Id v : this->mesh_.triangle(f))
    {
      complete[v] |= this->needed_[f];
    }
  }
  for (Id v = 0; v < this->mesh_.numberOfVertices(); ++v)
  {
    this->vertices_[v].distance = complete[v] ? this->vertices_[v].distance : Infinity;
  }
  this->result_.completeFaces = std::move(this->needed_);
}

// The list of the halfedge has gone on: it is kept as far as it is wanted, or freed.
void Propagation::retire(Worker& worker, Id halfedge, const std::array<double, 2>& ends)
{
  const WindowRange list = this->waiting_.at(halfedge);
  if (!this->needed_.empty())
  {
    const bool within = std::any_of(list.begin(), list.end(),
      [&](const Window& w) { return w.minimum() <= this->options_.maximumDistance; });
    for (Id s = halfedge; within;)
    {
      worker.withinLimit.push_back(s);
      s = this->mesh_.nextSibling(s);
      if (s == halfedge)
      {
        break;
      }
    }
  }
  this->retention_.pass(static_cast<std::size_t>(&worker - this->workers_.data()),
    { halfedge, this->waiting_.release(halfedge), ends }, this->batches_, worker.pool);
}

void Propagation::finish()
{
  this->waiting_ = WaitingLists(0);
  this->result_.vertexDistances.reserve(this->vertices_.size());
  for (const VertexState& vertex : this->vertices_)
  {
    this->result_.vertexDistances.push_back(vertex.distance);
  }
  for (const Worker& worker : this->workers_)
  {
    this->result_.windowsPropagated += worker.propagated;
    this->result_.relativeErrorBound =
      std::max(this->result_.relativeErrorBound, worker.relativeError);
  }
  this->retention_.finish(this->state());
}

FrontResult propagate(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  const FrontOptions& options, Retention& retention)
{
  if (!(options.relativeError >= 0.0) || !(options.relativeError < Infinity))
  {
    throw Error("The relative error is " + std::to_string(options.relativeError) +
      "; give a number of at least 0.");
  }
  return Propagation(mesh, options, retention).run(sources);
}

}
