// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceWindows.h"

#include "Tolerance.h"
#include "source/CurvesOnPatch.h"
#include "source/PointWindows.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// Whether a segment merely crosses a face without area: it is as long as roundings of the points
/// of its curve, which turn it anywhere. This leaves gaps of its length.
bool isAcrossWithoutArea(
  const TriangleMesh& mesh, const SourceInFace& segment, double lengthOfCurve)
{
  const FaceShape& shape = mesh.shape(segment.face);
  return shape.hasZeroArea() &&
    segment.placeOfB - segment.placeOfA <=
    tolerance::PathAtVertex * (lengthOfCurve + shape.longest());
}

class Maker
{
public:
  Maker(const TriangleMesh& mesh, const std::vector<SourceCurve>& curves,
    const ProgressCallback& progress)
    : mesh_(mesh)
    , curves_(ReplicatedPatch(mesh), curves)
    , progress_(progress)
    , sectors_(mesh)
    , directions_(mesh)
  {
    for (const SourceCurve& curve : this->chains().curves())
    {
      this->numberOfPoints_ += curve.points.size();
    }
  }

  SourceWindows make()
  {
    for (Id chain = 0; chain < this->chains().curves().size(); ++chain)
    {
      this->addSegments(chain);
      this->addPoints(chain);
    }
    this->emitFromVertices();
    const auto byFace = [](const SourceInFace& a, const SourceInFace& b)
    { return a.face < b.face; };
    std::stable_sort(this->result_.inFaces.begin(), this->result_.inFaces.end(), byFace);
    return std::move(this->result_);
  }

private:
  const CurveChains& chains() const { return this->curves_.chains(); }

  /// Reports the number of finished points every so many steps, even within a point.
  ///
  /// \throws Aborted
  void step()
  {
    constexpr std::size_t stepsPerReport = 4096;
    if (++this->steps_ % stepsPerReport == 0)
    {
      reportProgress(this->progress_,
        static_cast<double>(this->pointsDone_) / static_cast<double>(this->numberOfPoints_));
    }
  }
  void nextPoint()
  {
    this->pointsDone_ = std::min(this->pointsDone_ + 1, this->numberOfPoints_);
    this->step();
  }

  void addSegments(Id chain)
  {
    const std::vector<double>& places = this->chains().places(chain);
    for (const SourceInFace& segment :
      segmentsInFaces(this->mesh_, this->chains().curves()[chain], chain, places))
    {
      this->step();
      this->result_.inFaces.push_back(segment);
      if (!isAcrossWithoutArea(this->mesh_, segment, places.back()))
      {
        addSegmentWindows(this->mesh_, segment, this->result_.windows);
      }
    }
  }

  void addPoints(Id chain)
  {
    const SourceCurve& curve = this->chains().curves()[chain];
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
        this->nextPoint();
      }
      else if (p.kind != SurfacePoint::Kind::Vertex)
      {
        const CurveChains::Point at = { chain, i };
        this->emitFromPoint(p, segmentEndsAt(this->mesh_, this->chains(), at),
          segmentEndsAround(this->mesh_, this->chains(), at), chain,
          this->chains().places(chain)[i]);
      }
    }
  }

  // If several curves meet in one vertex, all their segments bound its wedges together.
  void emitFromVertices()
  {
    for (const VertexOnCurve& v : this->curves_.vertices())
    {
      if (&v == this->curves_.find(v.vertex))
      {
        this->result_.vertices.push_back(v.vertex);
        this->emitFromPoint(SurfacePoint::atVertex(v.vertex), this->curves_.endsAt(v.vertex),
          this->curves_.endsAround(v.vertex), v.curve, v.place);
      }
    }
  }

  void emitFromPoint(const SurfacePoint& p, const std::vector<SegmentEnd>& ends,
    const std::vector<SegmentEnd>& endsAround, Id curve, double place)
  {
    this->nextPoint();
    const CurveWedge wedge = wedgeAround(this->mesh_, p, ends);
    this->sectors_.assign(p, endsAround, CurveOrigin::onLeft(this->mesh_, curve, place));
    this->directions_.assign(p, endsAround);
    const EmittingPoint from = { this->chains(), wedge, this->sectors_, this->directions_ };
    forEachFace(this->mesh_, p,
      [&](Id face)
      {
        this->step();
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

  const TriangleMesh& mesh_;
  const CurvesOnPatch curves_;
  const ProgressCallback& progress_;
  std::size_t numberOfPoints_ = 0;
  std::size_t pointsDone_ = 0;
  std::size_t steps_ = 0;
  CurveSectors sectors_;
  DirectionsAround directions_;
  SourceWindows result_;
};

} // anonymous namespace

SourceWindows makeSourceWindows(const TriangleMesh& mesh, const std::vector<SourceCurve>& curves,
  const ProgressCallback& progress)
{
  return Maker(mesh, curves, progress).make();
}

}
