// SPDX-License-Identifier: BSD-3-Clause
#include "source/PolylineOnSurface.h"

#include "Errors.h"
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
struct PlacedPoint
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

/// Tells how many of all polylines' points are done.
class PointProgress
{
public:
  PointProgress(const ProgressCallback& callback, std::size_t numberOfPoints)
    : callback_(callback)
    , numberOfPoints_(static_cast<double>(numberOfPoints))
  {
  }

  /// \param point index in the polyline that is being worked on, with a fraction of the way on.
  /// \throws Aborted
  void report(double point)
  {
    const double fraction = (this->pointsDone_ + point) / this->numberOfPoints_;
    this->reported_ = std::clamp(fraction, this->reported_, 1.0); // never back
    if (this->callback_ && !this->callback_(this->reported_))
    {
      throw Aborted();
    }
  }

  /// At each point that has been put onto the surface.
  ///
  /// \throws Aborted
  void countPlaced()
  {
    if (this->pointsPlaced_++ % PointsPerReport == 0)
    {
      this->report(0.0);
    }
  }

  void finish(const LocatedPolyline& polyline)
  {
    this->pointsDone_ += static_cast<double>(polyline.points.size());
  }

private:
  const ProgressCallback& callback_;
  const double numberOfPoints_;
  std::size_t pointsPlaced_ = 0;
  /// Points of the polylines that are finished.
  double pointsDone_ = 0.0;
  double reported_ = 0.0;
};

/// Puts the points of polylines onto the surface and leaves out those that repeat the one before.
class PointPlacer
{
public:
  /// \param totals where the snap distance and the repeated points are told.
  PointPlacer(const TriangleMesh& mesh, const SnapOptions& options, PointProgress& progress,
    SourceCurves& totals)
    : mesh_(mesh)
    , options_(options)
    , progress_(progress)
    , totals_(totals)
  {
  }

  std::vector<PlacedPoint> run(const LocatedPolyline& polyline)
  {
    std::vector<PlacedPoint> placed;
    for (std::size_t i = 0; i < polyline.points.size(); ++i)
    {
      this->progress_.countPlaced();
      const PlacedPoint next = this->place(polyline, i);
      if (!placed.empty() && this->isOnePlace(placed.back(), next))
      {
        this->leaveOut(polyline, next, placed.back());
        continue;
      }
      placed.push_back(next);
    }
    this->close(polyline, placed);
    return placed;
  }

private:
  PlacedPoint place(const LocatedPolyline& polyline, std::size_t index)
  {
    const SnappedPoint snapped = snapToFace(this->mesh_, polyline.faces[index],
      polyline.points[index], this->options_.coordinatePrecision);
    this->totals_.snapDistance = std::max(this->totals_.snapDistance, snapped.distance);
    return { snapped.place, position(this->mesh_, snapped.place), snapped.tolerance, index };
  }

  /// Whether two places cannot be told apart: the direction from one to the other would be
  /// rounding. Two vertices always can.
  bool isOnePlace(const PlacedPoint& a, const PlacedPoint& b) const
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

  void leaveOut(
    const LocatedPolyline& polyline, const PlacedPoint& repeated, const PlacedPoint& kept)
  {
    ++this->totals_.repeatedPoints;
    this->totals_.snapDistance =
      std::max(this->totals_.snapDistance, norm(polyline.points[repeated.index] - kept.position));
  }

  /// Ends a closed polyline, and an open one that comes back to its first place, exactly there.
  void close(const LocatedPolyline& polyline, std::vector<PlacedPoint>& placed)
  {
    const bool comesBack = placed.size() > 1 && this->isOnePlace(placed.front(), placed.back());
    if (comesBack)
    {
      const PlacedPoint last = placed.back();
      placed.pop_back();
      this->leaveOut(polyline, last, placed.front());
      // An open polyline has its last point given; a closed one repeats its first point with it.
      this->totals_.repeatedPoints -= polyline.closed ? 0 : 1;
    }
    if (comesBack || (polyline.closed && placed.size() > 1))
    {
      placed.push_back(placed.front());
      placed.back().index = comesBack && !polyline.closed ? polyline.points.size() - 1 : 0;
    }
  }

  const TriangleMesh& mesh_;
  const SnapOptions& options_;
  PointProgress& progress_;
  SourceCurves& totals_;
};

/// Joins placed points to curves.
class CurveJoiner
{
public:
  CurveJoiner(const TriangleMesh& mesh, const JoinPoints& join, PointProgress& progress)
    : mesh_(mesh)
    , join_(join)
    , progress_(progress)
  {
  }

  /// \param name of the polyline, for error messages.
  SourceCurve run(const std::vector<PlacedPoint>& placed, const std::string& name)
  {
    SourceCurve curve;
    curve.points = { placed.front().point };
    curve.isCut = { 0 };
    for (std::size_t i = 1; i < placed.size(); ++i)
    {
      this->append(this->pathBetween(placed[i - 1], placed[i], name), curve);
    }
    return curve;
  }

private:
  std::vector<SurfacePoint> pathBetween(
    const PlacedPoint& from, const PlacedPoint& to, const std::string& name)
  {
    if (commonFace(this->mesh_, from.point, to.point) != NoId)
    {
      return { from.point, to.point };
    }
    const auto report = [&](double fraction)
    {
      this->progress_.report(static_cast<double>(from.index) + fraction);
      return true;
    };
    std::vector<SurfacePoint> path = this->join_(from.point, to.point, report);
    if (path.empty())
    {
      throw SourceError("Points " + std::to_string(from.index) + " and " +
        std::to_string(to.index) + " of " + name +
        " are on different components of the surface, so that no path on it joins them. Split the "
        "polyline between them, or connect the surface.");
    }
    return path;
  }

  /// Appends a path from the curve's last point on: it is merely cut where it crosses edges; at
  /// vertices it may bend.
  void append(const std::vector<SurfacePoint>& path, SourceCurve& curve) const
  {
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      const bool isInner = i + 1 < path.size();
      const bool isCut = isInner && path[i].kind == SurfacePoint::Kind::Edge;
      curve.faces.push_back(commonFace(this->mesh_, path[i - 1], path[i]));
      curve.points.push_back(path[i]);
      curve.isCut.push_back(isCut ? 1 : 0);
    }
  }

  const TriangleMesh& mesh_;
  const JoinPoints& join_;
  PointProgress& progress_;
};

} // anonymous namespace

SourceCurves putOntoSurface(const TriangleMesh& mesh, const std::vector<LocatedPolyline>& polylines,
  const SnapOptions& options, const JoinPoints& join, const ProgressCallback& progress)
{
  std::size_t numberOfPoints = 0;
  for (const LocatedPolyline& polyline : polylines)
  {
    check(mesh, polyline);
    numberOfPoints += polyline.points.size();
  }
  SourceCurves result;
  PointProgress pointProgress(progress, numberOfPoints);
  PointPlacer placer(mesh, options, pointProgress, result);
  CurveJoiner joiner(mesh, join, pointProgress);
  for (const LocatedPolyline& polyline : polylines)
  {
    result.curves.push_back(joiner.run(placer.run(polyline), polyline.name));
    pointProgress.finish(polyline);
  }
  return result;
}

}
