// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceWindows.h"

#include "Tolerance.h"
#include "source/CurveChains.h"
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

/// A mesh vertex that is a point of a curve.
struct VertexOnCurve
{
  Id vertex;
  Id curve;
  double place;
};

class Maker
{
public:
  Maker(const TriangleMesh& mesh, StepProgress& progress)
    : mesh_(mesh)
    , progress_(progress)
    , wedge_(mesh)
    , sectors_(mesh)
  {
  }

  SourceWindows make(const CurveChains& chains)
  {
    for (const SourceCurve& curve : chains.curves())
    {
      this->places_ = chains.places(this->curve_);
      this->addSegments(curve);
      this->addPoints(curve);
      ++this->curve_;
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
      this->addSegment(face, p, q, i);
      const Barycentric a = barycentric(this->mesh_, p, face);
      const Barycentric b = barycentric(this->mesh_, q, face);
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Id halfedge = 3 * face + static_cast<Id>(k);
        for (Id s = this->mesh_.nextSibling(halfedge); runsAlong(k, a, b) && s != halfedge;
             s = this->mesh_.nextSibling(s))
        {
          this->addSegment(TriangleMesh::faceOf(s), p, q, i);
        }
      }
    }
  }

  void addSegment(Id face, const SurfacePoint& p, const SurfacePoint& q, std::size_t i)
  {
    this->result_.inFaces.push_back({ face, barycentric(this->mesh_, p, face),
      barycentric(this->mesh_, q, face), this->curve_, this->places_[i], this->places_[i + 1] });
    addSegmentWindows(this->mesh_, this->result_.inFaces.back(), this->result_.windows);
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
      const std::vector<SegmentEnd> ends =
        segmentEndsAt(this->mesh_, curve, this->curve_, this->places_, i);
      if (p.kind == SurfacePoint::Kind::Vertex)
      {
        this->vertices_.push_back({ p.id, this->curve_, this->places_[i] });
        this->vertexEnds_.insert(this->vertexEnds_.end(), ends.begin(), ends.end());
        continue;
      }
      this->emitFromPoint(p, ends, this->curve_, this->places_[i]);
    }
  }

  void emitFromPoint(
    const SurfacePoint& p, const std::vector<SegmentEnd>& ends, Id curve, double place)
  {
    this->progress_.nextPoint();
    const auto step = [this] { this->progress_.step(); };
    this->wedge_.assign(p, ends, step);
    this->sectors_.assign(
      p, ends, { CurveSide{ curve, false }.origin(this->mesh_.numberOfVertices()), place });
    forEachFace(this->mesh_, p,
      [&](Id face)
      {
        step();
        const Barycentric b = barycentric(this->mesh_, p, face);
        if (p.kind != SurfacePoint::Kind::Vertex)
        {
          this->result_.inFaces.push_back({ face, b, b, curve, place, place });
          this->findNearVertices(face, b);
        }
        addPointWindows(this->mesh_, face, b, this->wedge_, this->sectors_, this->result_.windows);
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
    std::vector<VertexOnCurve>& vertices = this->vertices_;
    std::stable_sort(vertices.begin(), vertices.end(),
      [](const VertexOnCurve& a, const VertexOnCurve& b) { return a.vertex < b.vertex; });
    const auto isSame = [](const VertexOnCurve& a, const VertexOnCurve& b)
    { return a.vertex == b.vertex; };
    vertices.erase(std::unique(vertices.begin(), vertices.end(), isSame), vertices.end());
    const auto key = [](const SegmentEnd& s)
    { return std::make_tuple(s.from.id, s.face, s.to.kind, s.to.id, s.to.u, s.to.v); };
    const auto less = [&](const SegmentEnd& a, const SegmentEnd& b) { return key(a) < key(b); };
    std::vector<SegmentEnd>& ends = this->vertexEnds_;
    std::sort(ends.begin(), ends.end(), less);

    auto first = ends.cbegin();
    for (const VertexOnCurve& v : vertices)
    {
      this->result_.vertices.push_back(v.vertex);
      auto last = first;
      while (last != ends.cend() && last->from.id == v.vertex)
      {
        ++last;
      }
      this->emitFromPoint(SurfacePoint::atVertex(v.vertex), { first, last }, v.curve, v.place);
      first = last;
    }
  }

  const TriangleMesh& mesh_;
  StepProgress& progress_;
  CurveWedge wedge_;
  CurveSectors sectors_;
  SourceWindows result_;
  /// The number of the curve at hand, and where its points are along it.
  Id curve_ = 0;
  std::vector<double> places_;
  std::vector<VertexOnCurve> vertices_;
  /// Of all curves.
  std::vector<SegmentEnd> vertexEnds_;
};

} // anonymous namespace

SourceWindows makeSourceWindows(const TriangleMesh& mesh, const std::vector<SourceCurve>& curves,
  const ProgressCallback& callback)
{
  StepProgress progress(callback, numberOfPoints(curves));
  return Maker(mesh, progress).make(CurveChains(mesh, curves));
}

}
