// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceCurve.h"

#include "Errors.h"
#include "field/ShortestPathFinder.h"
#include "mesh/SurfaceSnap.h"

#include <algorithm>
#include <cmath>

namespace geodesic
{

namespace
{

/// Points put onto the surface between two calls of the progress callback.
constexpr std::size_t PointsPerReport = 256;

/// A point of a polyline on the surface.
struct Place
{
  SurfacePoint point;
  Vec3 position;
  double tolerance;
  /// Index in the given polyline.
  std::size_t index;
};

/// Checks one polyline before any work is done with it.
void check(const TriangleMesh& mesh, const LocatedPolyline& polyline)
{
  if (polyline.points.empty())
  {
    throw SourceError(
      "There are no points in " + polyline.name + ". Give it one point at least, or leave it out.");
  }
  for (std::size_t i = 0; i < polyline.points.size(); ++i)
  {
    const Vec3& p = polyline.points[i];
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]))
    {
      throw SourceError("Point " + std::to_string(i) + " of " + polyline.name +
        " has a coordinate that is not finite. Remove or repair the point.");
    }
    if (i >= polyline.faces.size() || polyline.faces[i] >= mesh.numberOfFaces())
    {
      throw SourceError("Point " + std::to_string(i) + " of " + polyline.name +
        " has not been located on a face of the surface.");
    }
  }
}

/// Puts polylines onto one surface, one after the other.
class CurveBuilder
{
public:
  CurveBuilder(const TriangleMesh& mesh, const SnapOptions& options,
    const ProgressCallback& progress, std::size_t numberOfPoints)
    : mesh_(mesh)
    , options_(options)
    , progress_(progress)
    , numberOfPoints_(static_cast<double>(numberOfPoints))
    , paths_(mesh)
  {
  }

  void add(const LocatedPolyline& polyline)
  {
    const std::vector<Place> places = this->place(polyline);
    SourceCurve curve;
    curve.points = { places.front().point };
    curve.isCut = { 0 };
    for (std::size_t i = 1; i < places.size(); ++i)
    {
      this->join(places[i - 1], places[i], polyline.name, curve);
    }
    this->result_.curves.push_back(std::move(curve));
    this->pointsDone_ += static_cast<double>(polyline.points.size());
  }

  SourceCurves result() { return std::move(this->result_); }

private:
  std::vector<Place> place(const LocatedPolyline& polyline);
  Place placeOne(const LocatedPolyline& polyline, std::size_t index);
  void close(const LocatedPolyline& polyline, std::vector<Place>& places);
  bool isOnePlace(const Place& a, const Place& b) const;
  void leaveOut(const LocatedPolyline& polyline, const Place& repeated, const Place& kept);
  void join(const Place& from, const Place& to, const std::string& name, SourceCurve& curve);
  std::vector<SurfacePoint> pathBetween(
    const Place& from, const Place& to, const std::string& name);
  void report(double pointsBeyond);

  const TriangleMesh& mesh_;
  const SnapOptions& options_;
  const ProgressCallback& progress_;
  const double numberOfPoints_;
  std::size_t pointsPlaced_ = 0;
  /// Points of the polylines that are finished.
  double pointsDone_ = 0.0;
  double reported_ = 0.0;
  ShortestPathFinder paths_;
  SourceCurves result_;
};

void CurveBuilder::report(double pointsBeyond)
{
  const double fraction = (this->pointsDone_ + pointsBeyond) / this->numberOfPoints_;
  this->reported_ = std::clamp(fraction, this->reported_, 1.0); // never back
  if (this->progress_ && !this->progress_(this->reported_))
  {
    throw Aborted();
  }
}

Place CurveBuilder::placeOne(const LocatedPolyline& polyline, std::size_t index)
{
  const SnappedPoint snapped = snapToFace(
    this->mesh_, polyline.faces[index], polyline.points[index], this->options_.coordinatePrecision);
  this->result_.snapDistance = std::max(this->result_.snapDistance, snapped.distance);
  return { snapped.place, position(this->mesh_, snapped.place), snapped.tolerance, index };
}

/// Whether two places cannot be told apart: the direction from one to the other would be rounding.
/// Two vertices always can.
bool CurveBuilder::isOnePlace(const Place& a, const Place& b) const
{
  if (samePlace(this->mesh_, a.point, b.point))
  {
    return true;
  }
  const bool areVertices =
    a.point.kind == SurfacePoint::Kind::Vertex && b.point.kind == SurfacePoint::Kind::Vertex;
  return !areVertices && norm(a.position - b.position) <= std::min(a.tolerance, b.tolerance) &&
    commonFace(this->mesh_, a.point, b.point) != NoId;
}

void CurveBuilder::leaveOut(
  const LocatedPolyline& polyline, const Place& repeated, const Place& kept)
{
  ++this->result_.repeatedPoints;
  this->result_.snapDistance =
    std::max(this->result_.snapDistance, norm(polyline.points[repeated.index] - kept.position));
}

std::vector<Place> CurveBuilder::place(const LocatedPolyline& polyline)
{
  std::vector<Place> places;
  for (std::size_t i = 0; i < polyline.points.size(); ++i)
  {
    if (this->pointsPlaced_++ % PointsPerReport == 0)
    {
      this->report(0.0);
    }
    const Place place = this->placeOne(polyline, i);
    if (!places.empty() && this->isOnePlace(places.back(), place))
    {
      this->leaveOut(polyline, place, places.back());
      continue;
    }
    places.push_back(place);
  }
  this->close(polyline, places);
  return places;
}

/// Ends a closed polyline, and an open one that comes back to its first place, exactly there.
void CurveBuilder::close(const LocatedPolyline& polyline, std::vector<Place>& places)
{
  const bool comesBack = places.size() > 1 && this->isOnePlace(places.front(), places.back());
  if (comesBack)
  {
    const Place last = places.back();
    places.pop_back();
    this->leaveOut(polyline, last, places.front());
    // An open polyline has its last point given; a closed one repeats its first point with it.
    this->result_.repeatedPoints -= polyline.closed ? 0 : 1;
  }
  if (comesBack || (polyline.closed && places.size() > 1))
  {
    places.push_back(places.front());
    places.back().index = comesBack && !polyline.closed ? polyline.points.size() - 1 : 0;
  }
}

std::vector<SurfacePoint> CurveBuilder::pathBetween(
  const Place& from, const Place& to, const std::string& name)
{
  const auto report = [&](double fraction)
  {
    this->report(static_cast<double>(from.index) + fraction);
    return true;
  };
  std::vector<SurfacePoint> path = this->paths_.between(from.point, to.point, report);
  if (path.empty())
  {
    throw SourceError("Points " + std::to_string(from.index) + " and " + std::to_string(to.index) +
      " of " + name +
      " are on different components of the surface, so that no path on it joins them. Split the "
      "polyline between them, or connect the surface.");
  }
  return path;
}

/// Appends the way from one place to the next: straight in a common face, or else along a shortest
/// path, which is merely cut where it crosses edges; at vertices it may bend.
void CurveBuilder::join(
  const Place& from, const Place& to, const std::string& name, SourceCurve& curve)
{
  const std::vector<SurfacePoint> path = this->pathBetween(from, to, name);
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    const bool isInner = i + 1 < path.size();
    const bool isCut = isInner && path[i].kind == SurfacePoint::Kind::Edge;
    curve.faces.push_back(commonFace(this->mesh_, path[i - 1], path[i]));
    curve.points.push_back(path[i]);
    curve.isCut.push_back(isCut ? 1 : 0);
  }
}

/// Chains the halfedges on the boundary of a surface into curves.
class BoundaryChains
{
public:
  explicit BoundaryChains(const TriangleMesh& mesh)
    : mesh_(mesh)
    , used_(mesh.numberOfHalfedges(), 0)
    , boundaryHalfedgesAt_(mesh.numberOfVertices(), 0)
  {
    for (Id halfedge = 0; halfedge < mesh.numberOfHalfedges(); ++halfedge)
    {
      if (mesh.isBoundary(halfedge))
      {
        ++this->boundaryHalfedgesAt_[mesh.origin(halfedge)];
        ++this->boundaryHalfedgesAt_[mesh.destination(halfedge)];
      }
    }
  }

  std::vector<SourceCurve> run()
  {
    // First the curves between vertices where the boundary branches or ends, then the loops left.
    for (const bool loops : { false, true })
    {
      for (Id halfedge = 0; halfedge < this->mesh_.numberOfHalfedges(); ++halfedge)
      {
        for (const Id vertex : { this->mesh_.origin(halfedge), this->mesh_.destination(halfedge) })
        {
          if (this->isFree(halfedge) && (loops || !this->goesOn(vertex)))
          {
            this->follow(halfedge, vertex);
          }
        }
      }
    }
    return std::move(this->curves_);
  }

private:
  bool isFree(Id halfedge) const { return this->mesh_.isBoundary(halfedge) && !this->used_[halfedge]; }

  Id otherEnd(Id halfedge, Id vertex) const
  {
    return this->mesh_.origin(halfedge) == vertex ? this->mesh_.destination(halfedge)
                                              : this->mesh_.origin(halfedge);
  }

  /// Whether one curve goes on through the boundary vertex.
  bool goesOn(Id vertex) const { return this->boundaryHalfedgesAt_[vertex] == 2; }

  Id freeHalfedgeAt(Id vertex) const
  {
    for (const Id corner : this->mesh_.cornersAt(vertex))
    {
      for (const Id halfedge : { corner, TriangleMesh::previousInFace(corner) })
      {
        if (this->isFree(halfedge))
        {
          return halfedge;
        }
      }
    }
    return NoId;
  }

  void follow(Id halfedge, Id vertex)
  {
    SourceCurve curve;
    curve.points = { SurfacePoint::atVertex(vertex) };
    do
    {
      this->used_[halfedge] = 1;
      vertex = this->otherEnd(halfedge, vertex);
      curve.points.push_back(SurfacePoint::atVertex(vertex));
      curve.faces.push_back(TriangleMesh::faceOf(halfedge));
      halfedge = this->goesOn(vertex) ? this->freeHalfedgeAt(vertex) : NoId;
    } while (halfedge != NoId);
    curve.isCut.assign(curve.points.size(), 0);
    this->curves_.push_back(std::move(curve));
  }

  const TriangleMesh& mesh_;
  std::vector<std::uint8_t> used_;
  std::vector<Id> boundaryHalfedgesAt_;
  std::vector<SourceCurve> curves_;
};

} // anonymous namespace

bool SourceCurve::isClosed() const
{
  if (this->points.size() < 2)
  {
    return false;
  }
  const SurfacePoint& first = this->points.front();
  const SurfacePoint& last = this->points.back();
  return first.kind == last.kind && first.id == last.id && first.u == last.u && first.v == last.v;
}

SourceCurves putOntoSurface(const TriangleMesh& mesh, const std::vector<LocatedPolyline>& polylines,
  const SnapOptions& options, const ProgressCallback& progress)
{
  std::size_t numberOfPoints = 0;
  for (const LocatedPolyline& polyline : polylines)
  {
    check(mesh, polyline);
    numberOfPoints += polyline.points.size();
  }
  CurveBuilder builder(mesh, options, progress, numberOfPoints);
  for (const LocatedPolyline& polyline : polylines)
  {
    builder.add(polyline);
  }
  return builder.result();
}

std::vector<SourceCurve> boundaryCurves(const TriangleMesh& mesh)
{
  return BoundaryChains(mesh).run();
}

}
