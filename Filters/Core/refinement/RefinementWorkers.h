// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinementWorkers_h
#define geodesic_RefinementWorkers_h

#include "Job.h"
#include "field/FaceDistance.h"
#include "field/SegmentEnvelope.h"
#include "refinement/Deviation.h"
#include "refinement/DistanceAlongEdge.h"
#include "refinement/RedGreenMesh.h"
#include "refinement/TriangleError.h"

#include <memory>
#include <optional>
#include <vector>

namespace geodesic
{

/// The distance at points and along segments of a mesh under refinement, measured in the faces that
/// contain them. Each thread has its own object, with its own memory; the mesh does not change
/// while several threads measure.
///
/// In an approximate field the faces at a point may have different distances there. The point's own
/// distance is the smallest of them.
class DistancesInFaces
{
public:
  /// \param field with windows kept; must outlive this, like the triangles.
  DistancesInFaces(const DistanceField& field, const RedGreenMesh& triangles)
    : field_(field)
    , triangles_(triangles)
  {
  }

  /// The distance in a face, valid until the next call. The last face is cached: refinement often
  /// asks for the same face repeatedly, and building it costs as much as measuring some segments.
  const FaceDistance& face(Id face);

  double atPoint(Id point) const;
  /// The distance at a point according to one of its faces.
  ///
  /// \param place of the point in the face's plane.
  double atPoint(Id point, const FaceDistance& face, Vec2 place) const;

  /// The distance along an edge in its refined faces: one of them in the exact field, as one face
  /// determines the whole distance along its edge.
  std::shared_ptr<const DistanceAlongEdge> along(Id edge);
  /// The largest deviations of the segment between two points of a face.
  Deviation between(Id a, Id b, const FaceDistance& face);

  /// The distance on an edge at a fraction of its length from its first end.
  double onEdge(Id edge, double weight);

private:
  template <typename Visit>
  void forEachRefinedFace(const RedGreenMesh::Edge& edge, const Visit& visit) const
  {
    this->triangles_.forEachFaceAt(edge,
      [&](Id face)
      {
        if (!this->triangles_.isFrozen(face))
        {
          visit(face);
        }
      });
  }

  const DistanceField& field_;
  const RedGreenMesh& triangles_;
  std::optional<FaceDistance> last_;
  SegmentEnvelope envelope_;
};

/// The tools of one task of a refinement.
struct RefinementWorker
{
  RefinementWorker(const DistanceField& field, const RedGreenMesh& triangles)
    : distances(field, triangles)
    , error(field)
  {
  }

  DistancesInFaces distances;
  TriangleError error;
};

/// The workers of a refinement, and the deviations of edges, each of which they measure once. The
/// number of a loop's items alone determines its tasks, each of which has a worker of its own.
class RefinementWorkers
{
public:
  /// All arguments must outlive this.
  ///
  /// \param tolerance an edge with a larger deviation shares the distance along it with its parts.
  /// \param job looked at every few items.
  RefinementWorkers(
    const DistanceField& field, const RedGreenMesh& triangles, double tolerance, const Job& job)
    : field_(field)
    , triangles_(triangles)
    , tolerance_(tolerance)
    , job_(job)
    , isExact_(field.relativeErrorBound() == 0.0)
  {
    this->resize(1);
  }

  /// The worker for work between loops: one edge or leaf after another, which may lead to many
  /// more.
  ///
  /// \throws Aborted
  RefinementWorker& first()
  {
    this->job_.look();
    return *this->workers_.front();
  }

  /// Runs item(worker, i) for i below `items`.
  ///
  /// \throws Aborted
  template <typename Item>
  void run(std::size_t items, const Item& item)
  {
    this->job_.loopByTasks(
      items, [this](std::size_t tasks) { this->resize(tasks); },
      [&](std::size_t task, std::size_t i) { item(*this->workers_[task], i); });
  }

  /// The largest deviations of an edge; measures it if necessary. Several threads may ask for edges
  /// that have been measured.
  Deviation deviation(Id edge) { return this->measured(edge).deviation; }
  /// Where to split an edge so that the fewest pieces within the tolerance come out, as a fraction
  /// of its length: the cut nearest to the middle (DistanceAlongEdge::cuts). Its parts have the
  /// other cuts.
  double bestSplit(Id edge, const StripCorners& corners);
  /// Measures all edges that have not been measured yet, in parallel.
  void measure(const std::vector<Id>& edges);
  /// Forgets the edges that no longer exist.
  void forgetNewEdges();

private:
  /// An edge as a part of the one along which its distance has been found, with its ends there.
  struct PartOfEdge
  {
    std::shared_ptr<const DistanceAlongEdge> distance;
    double begin = 0.0;
    double end = 0.0;
    /// Where it is best cut; empty if that has not been found out.
    std::vector<double> cuts;
  };
  struct Edge
  {
    Deviation deviation;
    bool isMeasured = false;
    /// Null for an edge within the tolerance, or one whose halves have been measured.
    std::unique_ptr<PartOfEdge> part;
  };

  void resize(std::size_t count);
  std::unique_ptr<PartOfEdge> partOf(Id edge, RefinementWorker& worker) const;
  void measure(Id edge, RefinementWorker& worker);
  Edge& measured(Id edge);
  void releaseWholeOf(Id part);

  const DistanceField& field_;
  const RedGreenMesh& triangles_;
  double tolerance_;
  const Job& job_;
  bool isExact_;
  std::vector<std::unique_ptr<RefinementWorker>> workers_;
  std::vector<Edge> edges_;
};

}

#endif
