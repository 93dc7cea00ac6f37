// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FrontContext_h
#define geodesic_FrontContext_h

#include "front/CompleteFaces.h"
#include "front/Districts.h"
#include "front/Front.h"
#include "front/FrontWorker.h"
#include "front/Mailboxes.h"
#include "front/PassedWindows.h"
#include "front/VertexSchedule.h"
#include "front/VertexStates.h"
#include "front/WaitingLists.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace geodesic
{

/// The state of the front in one district: the schedule of its vertices and the lists that wait for
/// them. Only one task at a time works on it.
struct District
{
  District(Id itsNumber, VertexStates& states, const Batch& itsBatch)
    : number(itsNumber)
    , schedule(states, itsBatch)
  {
  }

  Id number;
  VertexSchedule schedule;
  /// The next batch of its vertices, as found at the end of the last one.
  VertexSchedule::Outlook next;
  /// The lists on the halfedges opposite its vertices.
  WaitingLists lists;
  /// What is remembered of lists that went through these halfedges.
  PassedWindows passed;
  /// Its vertices in the current batch, and how many of them were never processed before.
  std::vector<Id> batch;
  std::size_t settled = 0;
  /// Processed vertices that have got a smaller distance since.
  std::vector<Id> shortened;
  /// With a distance limit: halfedges with windows within it.
  std::vector<Id> withinLimit;
  /// Lists for faces that other ranks own, and distances found in the second step of a batch, which
  /// other ranks need; nothing in one process.
  MailBatch toRanks;
};

/// The state of the front, which the tasks of a batch share. A task writes only to its district and
/// to the vertices there, to its own mail and to its worker, so tasks of several districts may run
/// at the same time.
struct FrontContext
{
  FrontContext(
    const MeshPartition& itsSurface, const FrontOptions& itsOptions, Retention& itsRetention)
    : surface(itsSurface)
    , mesh(itsSurface.mesh())
    , options(itsOptions)
    , retention(itsRetention)
    , districtNumbers(mesh, options.job.part(0.0, 0.0))
    , vertices(mesh, options.relativeError > 0.0, options.keepArrivals, options.job.part(0.0, 0.0))
    , complete(surface, options.maximumDistance)
    , mailboxes(districtNumbers.most())
    , mostFaces(std::min(surface.numberOfGlobalFaces(), MaximumFacesCrossed))
  {
    this->districtNumbers.join(this->options.job.sharing() == Job::Sharing::WherePaying);
    this->makeDistricts();
  }

  /// Between batches, makes one district of all, or one of each block. Changes no result.
  void joinDistricts(bool areJoined)
  {
    std::vector<District> before = std::exchange(this->districts, {});
    this->districtNumbers.join(areJoined);
    this->makeDistricts();
    for (District& district : before)
    {
      district.schedule.handOver(
        [this](Id vertex) -> VertexSchedule& { return this->districtOf(vertex).schedule; });
      district.lists.forEachGroup(
        [this](WaitingLists::Group& group)
        {
          const Id apex = this->mesh.opposite(group.front().halfedge);
          this->vertices[apex].facing = this->districtOf(apex).lists.addGroup(std::move(group));
        });
      district.passed.handOver([this](Id halfedge) -> PassedWindows&
        { return this->districtOf(this->mesh.opposite(halfedge)).passed; });
    }
    for (District& district : this->districts)
    {
      district.next = district.schedule.outlook();
    }
  }

  /// Begins again at distance 0, for sources that start later. Where windows came often before says
  /// nothing about these.
  ///
  /// \param processed the vertices processed since the last start.
  void restart(const std::vector<Id>& processed, WindowPool& pool)
  {
    this->batch.key = 0.0;
    for (District& district : this->districts)
    {
      district.passed.letGo([](Id) { return false; }, pool);
    }
    for (const Id vertex : processed)
    {
      this->vertices[vertex].timesProcessed = 0;
    }
  }

  District& districtOf(Id vertex) { return this->districts[this->districtNumbers.of(vertex)]; }

  /// Whether the known distance shows that no path in the corridor passes the vertex.
  bool isOutsideCorridor(Id vertex) const
  {
    return this->options.corridor != nullptr &&
      this->vertices.distance(vertex) + this->options.corridor->lowerBounds[vertex] >
      this->options.corridor->length;
  }

  /// Whether windows that come to a halfedge can still be shorter than paths by way of the vertex
  /// opposite. What comes from now on is seldom shorter than the key. Where paths by way of that
  /// vertex are as short as the key everywhere on the halfedge, nothing gains but windows that have
  /// waited for a far vertex. Only the vertex's own district may ask: another may be shortening
  /// the distances of the halfedge's ends, so these are not read.
  bool canGainOn(Id halfedge) const
  {
    const double toFartherEnd = std::max(this->mesh.length(TriangleMesh::nextInFace(halfedge)),
      this->mesh.length(TriangleMesh::previousInFace(halfedge)));
    return this->batch.key <= this->vertices.distance(this->mesh.opposite(halfedge)) + toFartherEnd;
  }

  bool isInThinFace(Id halfedge) const
  {
    return this->mesh.shape(TriangleMesh::faceOf(halfedge)).isThin();
  }

  const MeshPartition& surface;
  const TriangleMesh& mesh;
  const FrontOptions& options;
  Retention& retention;

  Batch batch;
  Districts districtNumbers;
  VertexStates vertices;
  /// Whether each face belongs to the source as a whole, so that no window enters it; empty if none
  /// does.
  std::vector<std::uint8_t> isCovered;
  std::vector<District> districts;
  CompleteFaces complete;
  Mailboxes mailboxes;

  /// The largest number of faces that a shortest path can cross.
  Id mostFaces;

private:
  void makeDistricts()
  {
    this->districts.clear();
    this->districts.reserve(this->districtNumbers.size());
    for (Id number = 0; number < this->districtNumbers.size(); ++number)
    {
      this->districts.emplace_back(number, this->vertices, this->batch);
    }
  }
};

/// Runs task(i) for i below the count. The memory of the next items is fetched in advance, so that
/// none waits for it.
///
/// \param fetch (i) -> void, called once for each item.
template <typename Fetch, typename Task>
void forEachInAdvance(std::size_t count, const Fetch& fetch, const Task& task)
{
  constexpr std::size_t ahead = 4;
  for (std::size_t i = 0; i < std::min(ahead, count); ++i)
  {
    fetch(i);
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    if (i + ahead < count)
    {
      fetch(i + ahead);
    }
    task(i);
  }
}

}

#endif
