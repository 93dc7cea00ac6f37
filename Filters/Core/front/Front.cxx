// SPDX-License-Identifier: BSD-3-Clause
#include "front/Front.h"

#include "Errors.h"
#include "front/FrontContext.h"
#include "front/FrontOnRanks.h"
#include "front/FrontStart.h"
#include "front/ProcessBatch.h"
#include "front/ReceiveMail.h"
#include "front/ThreadTrial.h"
#include "front/WindowsWithin.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace geodesic
{

namespace
{

/// The front (paper, section 3.1, in the order of Qin et al. 2016). The queue holds vertices.
/// Windows wait in sorted lists on halfedges, and a list passes through its face when the opposite
/// vertex is processed.
///
/// Vertices are processed in batches of nearly equal distance, and in districts (Districts), each
/// with its own schedule and lists. A batch has two steps, each for all districts in parallel:
/// vertices send lists and distances by way of the Mailboxes (ProcessBatch.h); each district takes
/// its mail, in an order that does not depend on how tasks were run (ReceiveMail.h). Little work
/// remains outside of the districts, mainly to find the begin and end of the next batch.
///
/// If ranks share the surface, FrontOnRanks exchanges windows and distances after the first step,
/// and distances and the next batch's keys after the second.
class Front
{
public:
  Front(const MeshPartition& surface, const FrontOptions& options, Retention& retention)
    : front_(surface, options, retention)
    , workers_(options.job)
    , ranks_(front_, workers_.first().pool)
    , trial_(options.job.sharing())
    , within_(front_)
  {
  }

  /// Puts the first windows of sources on their halfedges. The distances known by now stay.
  ///
  /// \returns whether any rank has a source.
  bool start(SourceWindows sources)
  {
    if (!this->exchange().isTrueAnywhere(!sources.inFaces.empty() || !sources.vertices.empty()))
    {
      return false;
    }
    this->front_.restart(this->processed_, this->workers_.first().pool);
    this->processed_.clear();
    startFront(this->front_, this->workers_.first(), this->ranks_, sources);
    this->front_.retention.start(this->front_.districtNumbers.most(), sources.inFaces);
    this->addSources(sources.inFaces);
    this->addSources(sources.inHalo);
    this->chooseDistricts(Infinity); // any may have got distances or windows
    this->receive();
    return true;
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
      this->front_.batch.key = std::max(this->front_.batch.key, this->next_.least);
      if (this->hasAllNeeded())
      {
        return;
      }
      this->runBatch(std::min(limit, this->next_.last),
        [this](District& district)
        {
          district.schedule.takeBatch(district.batch);
          this->front_.districtNumbers.sort(district.batch);
        });
    }
  }

  /// Completes faces at a limit, and gathers the result. To be called once, at the end.
  FrontResult finish()
  {
    this->front_.options.job.reach(this->done());
    if (this->front_.complete.isLimited())
    {
      this->finishLimited();
    }
    this->front_.districts.clear();
    this->result_.completeFaces = this->front_.complete.release();
    this->result_.vertexDistances.reserve(this->vertices().size());
    for (Id vertex = 0; vertex < this->vertices().size(); ++vertex)
    {
      this->result_.vertexDistances.push_back(this->vertices().distance(vertex));
    }
    this->ranks_.completeHalo(this->result_.vertexDistances);
    this->result_.arrivals = this->vertices().releaseArrivals();
    this->result_.hasAngles = this->front_.options.keepAngles;
    this->workers_.forEach(
      [this](const FrontWorker& worker)
      {
        this->result_.windowsPropagated += worker.propagated;
        this->result_.relativeErrorBound =
          std::max(this->result_.relativeErrorBound, worker.relativeError);
      });
    this->result_.windowsPropagated =
      sumOverRanks(this->exchange(), this->result_.windowsPropagated).all;
    this->result_.relativeErrorBound = this->exchange().largestOf(this->result_.relativeErrorBound);
    this->front_.retention.finish(this->state());
    return std::move(this->result_);
  }

private:
  Exchange& exchange() const { return this->front_.surface.exchange(); }
  VertexStates& vertices() { return this->front_.vertices; }

  // To those that are there, in the order of their faces.
  void addSources(const std::vector<SourceInFace>& added)
  {
    if (added.empty())
    {
      return;
    }
    std::vector<SourceInFace>& sources = this->result_.sourcesInFaces;
    sources.insert(sources.end(), added.begin(), added.end());
    std::stable_sort(sources.begin(), sources.end());
  }

  /// Processes the next batch, in the districts that have vertices up to a distance.
  ///
  /// \param take (District&) -> void: gives a district its vertices of the batch.
  template <typename Take>
  void runBatch(double last, const Take& take)
  {
    ++this->front_.batch.number;
    this->front_.batch.last = last;
    this->chooseDistricts(last);
    this->inActiveDistricts(
      [&](FrontWorker& worker, District& district)
      {
        take(district);
        processBatch(this->front_, worker, district);
      });
    this->receive();
    this->report();
  }

  // Chooses the districts with vertices up to a distance for the next step; all if it is infinite.
  void chooseDistricts(double last)
  {
    this->active_.clear();
    for (const District& district : this->front_.districts)
    {
      if (district.next.least <= last)
      {
        this->active_.push_back(district.number);
      }
    }
  }

  // At each hundredth of the way, and where that takes long, in between.
  void report()
  {
    constexpr double step = 0.01;
    const double done = this->done();
    if (done >= this->reported_ + step)
    {
      this->reported_ = done;
      this->front_.options.job.reach(done);
    }
    this->front_.options.job.look(done);
  }

  /// Lets the districts take their mail, and finds the next batch.
  void receive()
  {
    this->ranks_.exchangeLists();
    this->front_.mailboxes.deliver(this->active_);
    this->inActiveDistricts([this](FrontWorker& worker, District& district)
      { receiveMail(this->front_, worker, district); });
    this->finishBatch();
  }

  /// \param task (FrontWorker&, District&) -> void, for several districts at the same time.
  template <typename Task>
  void inActiveDistricts(const Task& task)
  {
    this->workers_.run(this->active_.size(),
      [&](FrontWorker& worker, std::size_t i)
      { task(worker, this->front_.districts[this->active_[i]]); });
  }

  // The work of a batch outside of the districts.
  void finishBatch()
  {
    this->batch_.clear();
    for (const Id number : this->active_)
    {
      District& district = this->front_.districts[number];
      // A vertex that has only let lists pass is not settled.
      std::copy_if(district.batch.begin(), district.batch.end(), std::back_inserter(this->batch_),
        [this](Id vertex) { return this->vertices()[vertex].processed < Infinity; });
      district.batch.clear();
      this->settled_ += district.settled;
      district.settled = 0;
      this->reportShortened(district);
      for (const Id halfedge : district.withinLimit)
      {
        this->front_.complete.addAround(halfedge);
      }
      district.withinLimit.clear();
    }
    if (this->front_.options.laterSources)
    {
      this->processed_.insert(this->processed_.end(), this->batch_.begin(), this->batch_.end());
    }
    this->findNextBatch();
    this->front_.retention.advance(this->state());
    this->fitDistricts();
  }

  void fitDistricts()
  {
    const Districts& districts = this->front_.districtNumbers;
    if (districts.most() > 1 &&
      this->trial_.isSplit(this->workers_.takeWork(), ThreadTrial::Clock::now) ==
        districts.areJoined())
    {
      this->front_.joinDistricts(!districts.areJoined());
    }
  }

  void reportShortened(District& district)
  {
    for (const Id vertex : district.shortened)
    {
      this->front_.retention.shortenDistance(vertex);
    }
    district.shortened.clear();
  }

  void findNextBatch()
  {
    this->next_ = {};
    for (const District& district : this->front_.districts)
    {
      this->next_.least = std::min(this->next_.least, district.next.least);
      this->next_.last = std::min(this->next_.last, district.next.last);
    }
    // The distances that other ranks found last change nothing about the batch.
    for (const DistanceUpdate& update : this->ranks_.exchangeArrivals(this->next_))
    {
      District& district = this->front_.districtOf(update.vertex);
      acceptUpdate(this->front_, district, update);
      this->reportShortened(district);
      district.next = district.schedule.outlook();
    }
  }

  FrontState state()
  {
    this->pools_.clear();
    this->workers_.forEach([this](FrontWorker& worker) { this->pools_.push_back(&worker.pool); });
    return { this->front_.batch.key, this->batch_, this->vertices().distances(),
      this->vertices().processed(), this->pools_ };
  }

  /// How far the front is: by the number of vertices reached, or by the distance if there is a
  /// limit.
  double done() const
  {
    const Id vertices = std::max<Id>(this->front_.mesh.numberOfVertices(), 1);
    const double settled = static_cast<double>(this->settled_) / static_cast<double>(vertices);
    return std::max(settled, this->front_.batch.key / this->front_.options.maximumDistance);
  }

  // Whether nothing within the distance that the retention needs is left to do. Windows within it
  // may still wait for a far vertex. The front continues in its order until they have passed, so
  // that distances within it have the bits of a front that goes everywhere.
  bool hasAllNeeded()
  {
    const double needed = this->ranks_.neededDistance();
    return this->front_.batch.key > needed &&
      !this->exchange().isTrueAnywhere(this->within_.isAny(needed));
  }

  // A face that contains a point within the limit has exact values when no waiting window and no
  // pseudo-source is nearer than the farthest of them. No retention needs the lists that still wait
  // then.
  void finishLimited()
  {
    CompleteFaces& faces = this->front_.complete;
    this->flush(faces.limit());
    faces.addAroundReachedVertices(this->vertices());
    this->ranks_.shareNeeded(faces);
    this->flush(this->exchange().largestOf(
      faces.neededDistance(this->vertices(), this->front_.retention.needsInside())));
    std::vector<std::uint8_t> complete = faces.completeVertices();
    this->ranks_.shareMarks(complete);
    for (Id vertex = 0; vertex < this->vertices().size(); ++vertex)
    {
      if (!complete[vertex])
      {
        this->vertices()[vertex].distance = Infinity;
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
      this->runBatch(
        Infinity, [&](District& district) { this->within_.takeVertices(bound, district); });
      isAny = this->exchange().isTrueAnywhere(!this->batch_.empty());
    }
  }

  FrontContext front_;
  FrontWorkers workers_;
  FrontOnRanks ranks_;
  ThreadTrial trial_;
  WindowsWithin within_;
  FrontResult result_;

  /// The vertices of the current batch.
  std::vector<Id> batch_;
  /// If sources may start later: the vertices processed since the last start.
  std::vector<Id> processed_;
  /// The number of vertices that are done.
  std::size_t settled_ = 0;
  /// Districts that work in the current step.
  std::vector<Id> active_;
  /// The next batch over all districts and ranks.
  VertexSchedule::Outlook next_;
  std::vector<WindowPool*> pools_;
  /// See report().
  double reported_ = 0.0;
};

} // anonymous namespace

FrontResult propagate(const TriangleMesh& mesh, const std::vector<SourceCurve>& sources,
  const FrontOptions& options, Retention& retention)
{
  return propagate(
    MeshPartition(mesh), makeSourceWindows(mesh, sources, options.job), options, retention);
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
  if (!front.start(std::move(sources)))
  {
    throw SourceError("There is no source. Give at least one point on the surface.");
  }
  options.job.reach(0.0);
  do
  {
    front.advance(options.maximumDistance);
  } while (options.laterSources && front.start(options.laterSources()));
  return front.finish();
}

}
