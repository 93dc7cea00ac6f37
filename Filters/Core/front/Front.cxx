// SPDX-License-Identifier: BSD-3-Clause
#include "front/Front.h"

#include "Errors.h"
#include "front/BatchTasks.h"
#include "front/CompleteFaces.h"
#include "front/Districts.h"
#include "front/FrontOnRanks.h"
#include "front/FrontWorker.h"
#include "front/Mailboxes.h"
#include "front/VertexStates.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace geodesic
{

namespace
{

bool isAnyWindowWithin(const WindowRange& windows, double distance)
{
  return std::any_of(windows.begin(), windows.end(),
    [distance](const Window& w) { return w.minimum() <= distance; });
}

/// The front (paper, section 3.1, in the order of Qin et al. 2016). The queue holds vertices.
/// Windows wait in sorted lists on halfedges, and a list passes through its face when the opposite
/// vertex is processed.
///
/// Vertices are processed in batches of nearly equal distance, and in districts (Districts), each
/// with its own schedule and lists. A batch has two steps (BatchTasks.h), each for all districts
/// in parallel: (1) vertices send lists and distances by way of the Mailboxes; (2) each district
/// takes its mail, in an order that does not depend on how tasks were run. Little work remains
/// outside of the districts, mainly to find the begin and end of the next batch.
///
/// If ranks share the surface, FrontOnRanks exchanges windows and distances after (1), and
/// distances and the next batch's keys after (2).
class Front
{
public:
  Front(const MeshPartition& surface, const FrontOptions& options, Retention& retention)
    : surface_(surface)
    , mesh_(surface.mesh())
    , options_(options)
    , retention_(retention)
    , districtNumbers_(mesh_, options.job)
    , vertices_(mesh_, options.relativeError > 0.0, options.keepArrivals, options.job)
    , outlooks_(districtNumbers_.size())
    , complete_(surface, options.maximumDistance)
    , mailboxes_(districtNumbers_.size())
    , context_{ surface, mesh_, options, districtNumbers_, vertices_, complete_, mailboxes_,
      retention, outlooks_ }
    , workers_(options.job)
    , ranks_(context_, districts_, workers_.first().pool)
  {
    this->districts_.reserve(this->districtNumbers_.size());
    for (Id number = 0; number < this->districtNumbers_.size(); ++number)
    {
      this->districts_.emplace_back(number, this->vertices_, surface);
    }
  }

  /// Puts the first windows on their halfedges.
  ///
  /// \throws SourceError if no rank has a source.
  void start(SourceWindows initial)
  {
    if (!this->surface_.exchange().isTrueAnywhere(
          !initial.inFaces.empty() || !initial.vertices.empty()))
    {
      throw SourceError("There is no source. Give at least one point on the surface.");
    }
    this->startVertices(initial);
    this->startFaces(initial);
    this->startAroundVertices(initial);
    std::stable_sort(initial.windows.begin(), initial.windows.end(),
      [this](const LeavingWindow& a, const LeavingWindow& b)
      {
        return this->districtNumbers_.blockOf(this->mesh_.origin(a.halfedge)) <
          this->districtNumbers_.blockOf(this->mesh_.origin(b.halfedge));
      });
    for (const LeavingWindow& leaving : initial.windows)
    {
      District& sender = this->districtOf(this->mesh_.origin(leaving.halfedge));
      sendWindows(this->context_, this->workers_.first(), sender, leaving.halfedge,
        { &leaving.window, &leaving.window + 1 });
      this->mailboxes_.notify(sender.number);
    }
    this->result_.sourcesInFaces = std::move(initial.inFaces);
    this->retention_.start(this->districts_.size(), this->result_.sourcesInFaces);
    this->addSourcesInHalo(initial.inHalo);
    this->runBatch([](District&) {}); // receives what was sent
    this->options_.job.reach(0.0);
  }

  /// Processes all batches up to a distance.
  ///
  /// The loop ends. The windows that are sent form trees: the parent of a window is the one that
  /// came through a face into it; a window joined from two comes from the one whose number of faces
  /// crossed it keeps. That number is its depth in the tree, and a window that has crossed as many
  /// faces as the mesh has goes no further. So all trees have a finite depth, even if rounding
  /// leads a pencil of rays back to its halfedge. A window that is sent makes few others, which are
  /// cut into a finite number of parts before they are sent in turn. Trees of finite depth in which
  /// each window has finitely many children are finite. And there are finitely many trees: the
  /// windows of the source, and those that vertices emit. A vertex emits again only if its distance
  /// has become shorter by more than a tie, a fraction of it, which cannot go on for ever.
  void advance(double limit)
  {
    while (this->next_.least <= limit && this->next_.least < Infinity)
    {
      this->key_ = std::max(this->key_, this->next_.least);
      if (this->hasAllNeeded())
      {
        return;
      }
      const double last = std::min(limit, this->next_.last);
      this->activateUpTo(last);
      this->runBatch(
        [this, last](District& district)
        {
          district.schedule.takeBatch(last, district.batch);
          this->districtNumbers_.sort(district.batch);
        });
      this->reportBatch();
    }
  }

  /// Completes faces at a limit, and gathers the result. To be called once, at the end.
  FrontResult finish()
  {
    this->options_.job.reach(this->done());
    if (this->complete_.isLimited())
    {
      this->finishLimited();
    }
    this->districts_.clear();
    this->result_.completeFaces = this->complete_.release();
    this->result_.vertexDistances.reserve(this->vertices_.size());
    for (Id vertex = 0; vertex < this->vertices_.size(); ++vertex)
    {
      this->result_.vertexDistances.push_back(this->vertices_.distance(vertex));
    }
    this->ranks_.completeHalo(this->result_.vertexDistances);
    this->result_.arrivals = this->vertices_.releaseArrivals();
    this->result_.hasAngles = this->options_.keepAngles;
    this->workers_.forEach(
      [this](const FrontWorker& worker)
      {
        this->result_.windowsPropagated += worker.propagated;
        this->result_.relativeErrorBound =
          std::max(this->result_.relativeErrorBound, worker.relativeError);
      });
    Exchange& exchange = this->surface_.exchange();
    this->result_.windowsPropagated = sumOverRanks(exchange, this->result_.windowsPropagated).all;
    this->result_.relativeErrorBound = exchange.largestOf(this->result_.relativeErrorBound);
    this->retention_.finish(this->state());
    return std::move(this->result_);
  }

private:
  void startVertices(const SourceWindows& initial)
  {
    for (const Id vertex : initial.vertices)
    {
      // The curve's own wedges already exist.
      this->vertices_[vertex].pseudoSource = TriangleMesh::PseudoSource::None;
      this->shorten({ vertex, 0.0, 0.0, {} });
    }
  }

  // After all sources: a near vertex with a fan emits into the shadow of the nearest of them.
  void startAroundVertices(const SourceWindows& initial)
  {
    // Straight ways first: those by a near vertex may be as short but for rounding.
    for (const bool isStraight : { true, false })
    {
      for (const LeavingWindow& to : initial.toVertices)
      {
        if (to.window.origin.isOnCurve() == isStraight)
        {
          this->startAt(to);
        }
      }
    }
    for (const NearVertex& near : initial.nearVertices)
    {
      VertexState& state = this->vertices_[near.vertex];
      const bool isNearest = near.hasFan() &&
        near.distance <=
          state.distance + tolerance::PlaceRounding * this->mesh_.length(near.halfedge);
      if (!isNearest)
      {
        // Also vertices on a curve: a segment of a rounding's length may bound a wedge there.
        state.pseudoSource = TriangleMesh::PseudoSource::Irregular;
        continue;
      }
      this->shorten({ near.vertex, near.distance, 0.0, {} });
      state.arrivalHalfedge = near.halfedge;
      state.arrivalX = near.x;
    }
  }

  // The vertex opposite a halfedge, from a window's source or along an edge from a near vertex.
  void startAt(const LeavingWindow& to)
  {
    const Window& w = to.window;
    const Vec2 apex = apexOf(this->mesh_, to.halfedge);
    const bool isStraight = w.origin.isOnCurve();
    this->shorten({ this->mesh_.opposite(to.halfedge), w.straightDistance(apex), 0.0,
      { to.halfedge, w.origin, isStraight ? w.crossing(apex) : w.sourceX,
        isStraight ? apex - Vec2{ w.sourceX, -w.sourceDepth } : Vec2{}, w.start } });
  }

  void startFaces(const SourceWindows& initial)
  {
    for (const SourceInFace& source : initial.inFaces)
    {
      const Triangle& corners = this->mesh_.triangle(source.face);
      const RayOrigin origin = RayOrigin::curveSide(source.curve, false);
      for (std::size_t k = 0; k < 3; ++k)
      {
        const DistanceUpdate found = { corners[k],
          distanceToSource(this->mesh_, source, cornerWeights(k)), 0.0, { NoId, origin } };
        this->shorten(found);
        this->ranks_.addUpdate(found);
      }
      if (this->complete_.isLimited())
      {
        this->complete_.add(source.face);
      }
    }
  }

  void addSourcesInHalo(const std::vector<SourceInFace>& inHalo)
  {
    if (inHalo.empty())
    {
      return; // the others are in the order of their faces
    }
    std::vector<SourceInFace>& sources = this->result_.sourcesInFaces;
    sources.insert(sources.end(), inHalo.begin(), inHalo.end());
    std::stable_sort(sources.begin(), sources.end());
  }

  /// How far the front is: by the number of vertices reached, or by the distance if there is a
  /// limit.
  double done() const
  {
    const Id vertices = std::max<Id>(this->mesh_.numberOfVertices(), 1);
    const double settled = static_cast<double>(this->settled_) / static_cast<double>(vertices);
    return std::max(settled, this->key_ / this->options_.maximumDistance);
  }

  // After some of the batches. Few vertices may have very many windows.
  void reportBatch()
  {
    constexpr std::size_t verticesPerReport = 256;
    constexpr std::uint64_t windowsPerReport = 1U << 17;
    this->verticesSinceReport_ += this->batch_.size();
    if (this->verticesSinceReport_ >= verticesPerReport ||
      this->windowsHandled_ - this->windowsAtReport_ >= windowsPerReport)
    {
      this->verticesSinceReport_ = 0;
      this->windowsAtReport_ = this->windowsHandled_;
      this->options_.job.reach(this->done());
    }
  }

  // Whether nothing within the distance that the retention needs is left to do. Windows within it
  // may still wait for a far vertex. The front continues in its order until they have passed, so
  // that distances within it have the bits of a front that goes everywhere.
  bool hasAllNeeded()
  {
    return this->key_ > this->neededDistance_ &&
      !this->surface_.exchange().isTrueAnywhere(this->isAnyWithin(this->neededDistance_));
  }

  bool isAnyWithin(double distance)
  {
    if (this->vertexWithin_ != NoId && this->isWithin(this->vertexWithin_, distance))
    {
      return true;
    }
    this->vertexWithin_ = NoId;
    const auto isAnotherWithin = [&](Id vertex)
    {
      const bool isWithin = this->isWithin(vertex, distance);
      this->vertexWithin_ = isWithin ? vertex : this->vertexWithin_;
      return isWithin;
    };
    return std::any_of(this->districts_.begin(), this->districts_.end(),
      [&](const District& district) { return district.schedule.isAnyWaiting(isAnotherWithin); });
  }

  // Whether a waiting vertex has windows within a distance, or will emit some.
  bool isWithin(Id vertex, double distance)
  {
    const VertexState& state = this->vertices_[vertex];
    const WaitingLists& lists = this->districtOf(vertex).lists;
    bool isWithin = this->vertices_.isShorter(state) && state.distance <= distance;
    for (Id list = state.facing; list != NoId && !isWithin; list = lists[list].next)
    {
      isWithin = isAnyWindowWithin(lists[list].windows.range(), distance);
    }
    return isWithin;
  }

  /// \param fill (District&) -> void: gives a district its vertices of the batch.
  template <typename Fill>
  void runBatch(const Fill& fill)
  {
    ++this->context_.batch;
    this->runStep(
      [&](District& district)
      {
        fill(district);
        this->mailboxes_.notify(district.number);
      },
      processBatch);
    this->ranks_.exchangeLists();
    this->mailboxes_.takeReceivers(this->active_);
    this->runStep(
      [this](District& district) { receiveUpdates(this->context_, district); }, receiveLists);
    this->finishBatch();
  }

  void activateUpTo(double last)
  {
    this->active_.clear();
    for (Id number = 0; number < this->outlooks_.size(); ++number)
    {
      if (this->outlooks_[number].least <= last)
      {
        this->active_.push_back(number);
      }
    }
  }

  /// Runs a step of a batch in all active districts, in rounds; workers pause so that the watcher
  /// can be told. In each round some worker finishes at least one list, so the loop ends.
  ///
  /// \param begin (District&) -> void, called once per district.
  /// \param task called until the district is done.
  template <typename Begin>
  void runStep(const Begin& begin, BatchTask& task)
  {
    const auto isDone = [this](Id number) { return this->districts_[number].isDone; };
    for (bool isFirstRound = true;; isFirstRound = false)
    {
      this->workers_.run(this->active_.size(),
        [&](FrontWorker& worker, std::size_t i)
        {
          District& district = this->districts_[this->active_[i]];
          if (isFirstRound)
          {
            district.schedule.moveOn(this->key_);
            district.done = 0;
            district.isDone = false;
            begin(district);
          }
          if (!district.isDone)
          {
            task(this->context_, worker, district);
          }
        });
      if (std::all_of(this->active_.begin(), this->active_.end(), isDone))
      {
        return;
      }
      this->options_.job.reach(this->done());
    }
  }

  // The work of a batch outside of the districts.
  void finishBatch()
  {
    this->batch_.clear();
    this->next_ = {};
    for (const Id number : this->active_)
    {
      District& district = this->districts_[number];
      // A vertex that has only let lists pass is not settled.
      std::copy_if(district.batch.begin(), district.batch.end(), std::back_inserter(this->batch_),
        [this](Id vertex) { return this->vertices_[vertex].processed < Infinity; });
      district.batch.clear();
      this->settled_ += district.settled;
      district.settled = 0;
      this->reportShortened(district);
      for (const Id halfedge : district.withinLimit)
      {
        this->complete_.addAround(halfedge);
      }
      district.withinLimit.clear();
    }
    for (const VertexSchedule::Outlook& outlook : this->outlooks_)
    {
      this->next_.least = std::min(this->next_.least, outlook.least);
      this->next_.last = std::min(this->next_.last, outlook.last);
    }
    this->takeFromRanks(this->ranks_.exchangeArrivals(this->next_));
    this->retention_.advance(this->state());
    this->context_.longestPath =
      std::min(this->context_.longestPath, this->retention_.longestPath());
    this->neededDistance_ = this->ranks_.neededDistance();
  }

  void reportShortened(District& district)
  {
    for (const Id vertex : district.shortened)
    {
      this->retention_.shortenDistance(vertex);
    }
    district.shortened.clear();
  }

  // The distances that other ranks found last; none in one process.
  void takeFromRanks(const std::vector<DistanceUpdate>& updates)
  {
    for (const DistanceUpdate& update : updates)
    {
      this->shorten(update);
    }
    this->mailboxes_.takeReceivers(this->active_);
    for (const Id number : this->active_)
    {
      this->outlooks_[number] = this->districts_[number].schedule.outlook();
    }
  }

  FrontState state()
  {
    this->pools_.clear();
    this->windowsHandled_ = 0;
    this->workers_.forEach(
      [this](FrontWorker& worker)
      {
        this->pools_.push_back(&worker.pool);
        this->windowsHandled_ += worker.handled;
      });
    return { this->key_, this->batch_, this->vertices_.distances(), this->vertices_.processed(),
      this->pools_ };
  }

  // For calls outside of tasks. The district's next batch must be found again.
  void shorten(const DistanceUpdate& update)
  {
    District& district = this->districtOf(update.vertex);
    district.schedule.moveOn(this->key_);
    acceptUpdate(this->context_, district, update);
    this->reportShortened(district);
    this->mailboxes_.notify(district.number);
  }

  District& districtOf(Id vertex) { return this->districts_[this->districtNumbers_.of(vertex)]; }

  // A face that contains a point within the limit has exact values when no waiting window and no
  // pseudo-source is nearer than the farthest of them. No retention needs the lists that still wait
  // then.
  void finishLimited()
  {
    this->flush(this->complete_.limit());
    this->complete_.addAroundReachedVertices(this->vertices_);
    this->ranks_.shareNeeded(this->complete_);
    this->flush(this->surface_.exchange().largestOf(
      this->complete_.neededDistance(this->vertices_, this->retention_.needsInside())));
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

  // Propagates every window and pseudo-source nearer than the bound, even if it would wait for a
  // far vertex. Propagation ends as in advance().
  void flush(double bound)
  {
    bool isAny = true;
    while (isAny)
    {
      this->advance(bound);
      this->activateUpTo(Infinity);
      this->runBatch([&](District& district) { this->takeVerticesWithin(bound, district); });
      isAny = this->surface_.exchange().isTrueAnywhere(!this->batch_.empty());
      this->options_.job.reach(this->done());
    }
  }

  void takeVerticesWithin(double bound, District& district) const
  {
    district.schedule.passAll();
    std::vector<Id>& vertices = district.batch;
    district.lists.forEach(
      [&](const WaitingLists::List& list)
      {
        if (isAnyWindowWithin(list.windows.range(), bound))
        {
          vertices.push_back(this->mesh_.opposite(list.halfedge));
        }
      });
    this->districtNumbers_.sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  }

  const MeshPartition& surface_;
  const TriangleMesh& mesh_;
  const FrontOptions& options_;
  Retention& retention_;
  FrontResult result_;

  Districts districtNumbers_;
  VertexStates vertices_;
  std::vector<District> districts_;
  std::vector<VertexSchedule::Outlook> outlooks_;
  CompleteFaces complete_;
  Mailboxes mailboxes_;
  FrontContext context_;
  FrontWorkers workers_;
  FrontOnRanks ranks_;

  /// The vertices of the current batch.
  std::vector<Id> batch_;
  /// The number of vertices that are done.
  std::size_t settled_ = 0;
  /// The key at which the batch began: no path yet to be found is shorter.
  double key_ = 0.0;
  /// Districts that work in the current step.
  std::vector<Id> active_;
  /// The next batch over all districts and ranks, and the largest distance that their retentions
  /// need.
  VertexSchedule::Outlook next_;
  double neededDistance_ = Infinity;
  /// A vertex that recently had windows within the needed distance.
  Id vertexWithin_ = NoId;
  std::vector<WindowPool*> pools_;
  std::uint64_t windowsHandled_ = 0;
  /// See reportBatch().
  std::size_t verticesSinceReport_ = 0;
  std::uint64_t windowsAtReport_ = 0;
};

} // anonymous namespace

FrontResult propagate(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  const FrontOptions& options, Retention& retention)
{
  return propagate(
    MeshPartition(mesh), startingWindows(mesh, sources, options.job), options, retention);
}

SourceWindows startingWindows(
  const TriangleMesh& mesh, const std::vector<SourceCurve>& sources, const Job& job)
{
  return makeSourceWindows(mesh, sources, job.part(0.0, 0.0));
}

FrontResult propagate(const MeshPartition& surface, SourceWindows sources,
  const FrontOptions& options, Retention& retention)
{
  if (!(options.relativeError >= 0.0) || !(options.relativeError < Infinity))
  {
    throw Error("The relative error is " + std::to_string(options.relativeError) +
      "; give a number of at least 0.");
  }
  Front front(surface, options, retention);
  front.start(std::move(sources));
  front.advance(options.maximumDistance);
  return front.finish();
}

}
