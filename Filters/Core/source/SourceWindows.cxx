// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceWindows.h"

#include "Tolerance.h"
#include "source/CurveChains.h"
#include "source/CurveWedge.h"
#include "source/PointWindows.h"
#include "source/SegmentWindows.h"
#include "source/VerticesOnCurves.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// Reports the number of finished points every so many steps, even within a point.
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
    if (++this->steps_ % stepsPerReport == 0)
    {
      reportProgress(
        this->callback_, static_cast<double>(this->done_) / static_cast<double>(this->points_));
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

/// Whether segment i of a curve merely crosses a face without area: it is as long as roundings of
/// the curve's points, which turn it anywhere. This leaves gaps of its length.
bool isAcrossWithoutArea(
  const TriangleMesh& mesh, Id face, const std::vector<double>& places, std::size_t i)
{
  return mesh.shape(face).hasZeroArea() &&
    places[i + 1] - places[i] <=
    tolerance::PathAtVertex * (places.back() + mesh.shape(face).longest());
}

class Maker
{
public:
  Maker(const TriangleMesh& mesh, const CurveChains& chains, StepProgress& progress)
    : mesh_(mesh)
    , chains_(chains)
    , progress_(progress)
    , wedge_(mesh)
    , sectors_(mesh)
    , directions_(mesh)
  {
  }

  SourceWindows make()
  {
    for (const SourceCurve& curve : this->chains_.curves())
    {
      this->places_ = this->chains_.places(this->curve_);
      this->addSegments(curve);
      this->addPoints(curve);
      ++this->curve_;
    }
    this->emitFromVertices(VerticesOnCurves(this->mesh_, this->chains_));
    const auto byFace = [](const SourceInFace& a, const SourceInFace& b)
    { return a.face < b.face; };
    std::stable_sort(this->result_.inFaces.begin(), this->result_.inFaces.end(), byFace);
    return std::move(this->result_);
  }

private:
  void addSegments(const SourceCurve& curve)
  {
    for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
    {
      this->progress_.step();
      const SurfacePoint& p = curve.points[i];
      const SurfacePoint& q = curve.points[i + 1];
      forEachFaceOfSegment(
        this->mesh_, curve.faces[i], p, q, [&](Id face) { this->addSegment(face, p, q, i); });
    }
  }

  void addSegment(Id face, const SurfacePoint& p, const SurfacePoint& q, std::size_t i)
  {
    this->result_.inFaces.push_back({ face, barycentric(this->mesh_, p, face),
      barycentric(this->mesh_, q, face), this->curve_, this->places_[i], this->places_[i + 1] });
    if (!isAcrossWithoutArea(this->mesh_, face, this->places_, i))
    {
      addSegmentWindows(this->mesh_, this->result_.inFaces.back(), this->result_.windows);
    }
  }

  void addPoints(const SourceCurve& curve)
  {
    const std::size_t count = curve.points.size() - (curve.isClosed() ? 1 : 0);
    for (std::size_t i = 0; i < count; ++i)
    {
      const SurfacePoint& p = curve.points[i];
      // Faces at an edge of three and more faces see the curve bend.
      const bool straight =
        curve.isCut[i] && p.kind == SurfacePoint::Kind::Edge && this->mesh_.isInner(p.id);
      if (straight || isAtVertexBeside(this->mesh_, curve, i) ||
        !verticesAtCornerOf(this->mesh_, curve, i).empty())
      {
        this->progress_.nextPoint();
      }
      else if (p.kind != SurfacePoint::Kind::Vertex)
      {
        this->emitFromPoint(p, segmentEndsAt(this->mesh_, curve, this->curve_, this->places_, i),
          segmentEndsAround(this->mesh_, curve, this->curve_, this->places_, i), this->curve_,
          this->places_[i]);
      }
    }
  }

  void emitFromPoint(const SurfacePoint& p, const std::vector<SegmentEnd>& ends,
    const std::vector<SegmentEnd>& endsAround, Id curve, double place)
  {
    this->progress_.nextPoint();
    this->wedge_.assign(p, ends);
    this->sectors_.assign(p, endsAround, CurveOrigin::onLeft(this->mesh_, curve, place));
    this->directions_.assign(p, endsAround);
    const EmittingPoint from = { this->chains_, this->wedge_, this->sectors_, this->directions_ };
    forEachFace(this->mesh_, p,
      [&](Id face)
      {
        this->progress_.step();
        const Barycentric b = barycentric(this->mesh_, p, face);
        const SourceInFace source = { face, b, b, curve, place, place };
        if (p.kind != SurfacePoint::Kind::Vertex)
        {
          this->result_.inFaces.push_back(source);
          this->findNearVertices(face, b);
        }
        addPointWindows(this->mesh_, source, from, this->result_);
      });
  }

  // In a face without area a point of the longest edge may coincide with the opposite vertex.
  void findNearVertices(Id face, const Barycentric& b)
  {
    const FaceShape& shape = this->mesh_.shape(face);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const bool isNear = 1.0 - b[k] < tolerance::NearVertex ||
        (shape.hasZeroArea() &&
          distanceInFace(this->mesh_, face, b, cornerWeights(k)) <
            tolerance::NearVertex * shape.longest());
      if (isNear)
      {
        this->result_.nearVertices.push_back(this->mesh_.triangle(face)[k]);
      }
    }
  }

  // If several curves meet in one vertex, all their segments bound its wedges together.
  void emitFromVertices(const VerticesOnCurves& onCurves)
  {
    for (const VertexOnCurve& v : onCurves.vertices())
    {
      this->result_.vertices.push_back(v.vertex);
      this->emitFromPoint(SurfacePoint::atVertex(v.vertex), onCurves.endsAt(v.vertex),
        onCurves.endsAround(v.vertex), v.curve, v.place);
    }
  }

  const TriangleMesh& mesh_;
  const CurveChains& chains_;
  StepProgress& progress_;
  CurveWedge wedge_;
  CurveSectors sectors_;
  DirectionsAround directions_;
  SourceWindows result_;
  /// The number of the current curve, and the places of its points.
  Id curve_ = 0;
  std::vector<double> places_;
};

} // anonymous namespace

SourceWindows makeSourceWindows(const TriangleMesh& mesh, const std::vector<SourceCurve>& curves,
  const ProgressCallback& callback)
{
  StepProgress progress(callback, numberOfPoints(curves));
  return Maker(mesh, CurveChains(mesh, curves), progress).make();
}

}
