// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceWindows.h"

#include "Tolerance.h"
#include "source/CurveWedge.h"
#include "source/PointWindows.h"
#include "source/SegmentWindows.h"

#include <algorithm>
#include <tuple>

namespace geodesic
{

namespace
{

/// Tells the caller every so many steps how many of the points are done, also within the work of
/// one point.
class StepProgress
{
public:
  StepProgress(const ProgressCallback& callback, std::size_t points)
    : callback_(callback)
    , points_(points)
  {
  }

  void nextPoint()
  {
    this->done_ = std::min(this->done_ + 1, this->points_);
    this->step();
  }

  /// \throws Aborted
  void step()
  {
    constexpr std::size_t stepsPerReport = 4096;
    if (++this->steps_ % stepsPerReport == 0 && this->callback_ &&
      !this->callback_(static_cast<double>(this->done_) / static_cast<double>(this->points_)))
    {
      throw Aborted();
    }
  }

private:
  const ProgressCallback& callback_;
  std::size_t points_;
  std::size_t done_ = 0;
  std::size_t steps_ = 0;
};

std::size_t numberOfPoints(const std::vector<SourceCurve>& curves)
{
  std::size_t count = 0;
  for (const SourceCurve& curve : curves)
  {
    count += curve.points.size();
  }
  return count;
}

class Maker
{
public:
  Maker(const TriangleMesh& mesh, StepProgress& progress)
    : mesh_(mesh)
    , progress_(progress)
    , wedge_(mesh)
  {
  }

  SourceWindows make(const std::vector<SourceCurve>& curves)
  {
    for (SourceCurve curve : curves)
    {
      for (SurfacePoint& point : curve.points)
      {
        point = normalized(this->mesh_, point);
      }
      this->addSegments(curve);
      this->addPoints(curve);
    }
    this->emitFromVertices();
    const auto byFace = [](const SourceInFace& a, const SourceInFace& b)
    { return a.face < b.face; };
    std::stable_sort(this->result_.inFaces.begin(), this->result_.inFaces.end(), byFace);
    return std::move(this->result_);
  }

private:
  // A segment along an edge is one of all faces there.
  void addSegments(const SourceCurve& curve)
  {
    for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
    {
      this->progress_.step();
      const SurfacePoint& p = curve.points[i];
      const SurfacePoint& q = curve.points[i + 1];
      const Id face = curve.faces[i];
      this->addSegment(face, p, q);
      const Barycentric a = barycentric(this->mesh_, p, face);
      const Barycentric b = barycentric(this->mesh_, q, face);
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Id halfedge = 3 * face + static_cast<Id>(k);
        for (Id s = this->mesh_.nextSibling(halfedge); runsAlong(k, a, b) && s != halfedge;
             s = this->mesh_.nextSibling(s))
        {
          this->addSegment(TriangleMesh::faceOf(s), p, q);
        }
      }
    }
  }

  void addSegment(Id face, const SurfacePoint& p, const SurfacePoint& q)
  {
    const Barycentric a = barycentric(this->mesh_, p, face);
    const Barycentric b = barycentric(this->mesh_, q, face);
    this->result_.inFaces.push_back({ face, a, b });
    addSegmentWindows(this->mesh_, face, a, b, this->result_.windows);
  }

  void addPoints(const SourceCurve& curve)
  {
    const std::size_t count = curve.points.size() - (curve.isClosed() ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i)
    {
      const SurfacePoint& p = curve.points[i];
      // Around an edge of three and more faces the others see the curve bend.
      const bool straight =
        curve.isCut[i] && p.kind == SurfacePoint::Kind::Edge && this->mesh_.isInner(p.id);
      if (straight)
      {
        this->progress_.nextPoint();
        continue;
      }
      const std::vector<SegmentEnd> ends = this->segmentEndsAt(curve, i);
      if (p.kind == SurfacePoint::Kind::Vertex)
      {
        this->result_.vertices.push_back(p.id);
        this->vertexEnds_.insert(this->vertexEnds_.end(), ends.begin(), ends.end());
        continue;
      }
      this->emitFromPoint(p, ends);
    }
  }

  // Segment i runs from point i to point i + 1.
  std::vector<SegmentEnd> segmentEndsAt(const SourceCurve& curve, std::size_t i) const
  {
    const std::size_t count = curve.points.size();
    std::vector<SegmentEnd> ends;
    const auto add = [&](std::size_t to, std::size_t segment)
    {
      if (!samePlace(this->mesh_, curve.points[i], curve.points[to]))
      {
        ends.push_back({ curve.points[i], curve.points[to], curve.faces[segment] });
      }
    };
    if (i + 1 < count)
    {
      add(i + 1, i);
    }
    if (i > 0 || curve.isClosed())
    {
      const std::size_t before = i > 0 ? i - 1 : count - 2;
      add(before, before);
    }
    return ends;
  }

  void emitFromPoint(const SurfacePoint& p, const std::vector<SegmentEnd>& ends)
  {
    this->progress_.nextPoint();
    const auto step = [this] { this->progress_.step(); };
    this->wedge_.assign(p, ends, step);
    forEachFace(this->mesh_, p,
      [&](Id face)
      {
        step();
        const Barycentric b = barycentric(this->mesh_, p, face);
        if (p.kind != SurfacePoint::Kind::Vertex)
        {
          this->result_.inFaces.push_back({ face, b, b });
          this->findNearVertices(face, b);
        }
        addPointWindows(this->mesh_, face, b, this->wedge_, this->result_.windows);
      });
  }

  void findNearVertices(Id face, const Barycentric& b)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (1.0 - b[k] < tolerance::NearVertex)
      {
        this->result_.nearVertices.push_back(this->mesh_.triangle(face)[k]);
      }
    }
  }

  // Several curves may meet in one vertex: all their segments bound its wedges together.
  void emitFromVertices()
  {
    std::vector<Id>& vertices = this->result_.vertices;
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    const auto key = [](const SegmentEnd& s)
    { return std::make_tuple(s.from.id, s.face, s.to.kind, s.to.id, s.to.u, s.to.v); };
    const auto less = [&](const SegmentEnd& a, const SegmentEnd& b) { return key(a) < key(b); };
    std::vector<SegmentEnd>& ends = this->vertexEnds_;
    std::sort(ends.begin(), ends.end(), less);

    auto first = ends.cbegin();
    for (const Id vertex : vertices)
    {
      auto last = first;
      while (last != ends.cend() && last->from.id == vertex)
      {
        ++last;
      }
      this->emitFromPoint(SurfacePoint::atVertex(vertex), { first, last });
      first = last;
    }
  }

  const TriangleMesh& mesh_;
  StepProgress& progress_;
  CurveWedge wedge_;
  SourceWindows result_;
  /// Of all curves.
  std::vector<SegmentEnd> vertexEnds_;
};

} // anonymous namespace

SourceWindows makeSourceWindows(const TriangleMesh& mesh, const std::vector<SourceCurve>& curves,
  const ProgressCallback& callback)
{
  StepProgress progress(callback, numberOfPoints(curves));
  return Maker(mesh, progress).make(curves);
}

}
