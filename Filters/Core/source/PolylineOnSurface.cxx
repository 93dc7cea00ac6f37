// SPDX-License-Identifier: BSD-3-Clause
#include "source/PolylineOnSurface.h"

#include "Errors.h"
#include "mesh/SurfaceSnap.h"
#include "source/PlaceChoice.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

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
  /// The distance to the point in space.
  double distance;
  /// Index in the given polyline.
  std::size_t index;
};

/// Consecutive points of a polyline, joined on the surface.
using PlacedLine = std::vector<PlacedPoint>;

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
    if (!isFinite(p))
    {
      throw SourceError("Point " + std::to_string(i) + " of " + polyline.name +
        " has a coordinate that is not finite. Remove or repair the point.");
    }
    const auto isMissing = [&mesh](Id face) { return face >= mesh.numberOfFaces(); };
    if (i >= polyline.faces.size() || polyline.faces[i].empty() ||
      std::any_of(polyline.faces[i].begin(), polyline.faces[i].end(), isMissing))
    {
      throw SourceError("Point " + std::to_string(i) + " of " + polyline.name +
        " has not been located on a face of the surface.");
    }
  }
}

/// Reports how many points of all polylines are done.
class PointProgress
{
public:
  PointProgress(const ProgressCallback& callback, std::size_t numberOfPoints)
    : callback_(callback)
    , numberOfPoints_(static_cast<double>(numberOfPoints))
  {
  }

  /// \param point index in the current polyline, with the fraction of the way to the next point.
  /// \throws Aborted
  void report(double point)
  {
    const double fraction = (this->pointsDone_ + point) / this->numberOfPoints_;
    this->reported_ = std::clamp(fraction, this->reported_, 1.0); // never decreases
    reportProgress(this->callback_, this->reported_);
  }

  /// To be called for each point that was put onto the surface.
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
  /// Points of the finished polylines.
  double pointsDone_ = 0.0;
  double reported_ = 0.0;
};

/// Joins placed points into curves.
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
  SourceCurve run(const PlacedLine& line, const std::string& name)
  {
    SourceCurve curve;
    curve.points = { line.front().point };
    curve.isCut = { 0 };
    for (std::size_t i = 1; i < line.size(); ++i)
    {
      this->append(this->pathBetween(line[i - 1], line[i], name), curve);
    }
    return curve;
  }

  /// The length of the path that joins two points without a common face.
  double lengthBetween(const PlacedPoint& from, const PlacedPoint& to, const std::string& name)
  {
    const std::vector<SurfacePoint> path = this->joinFar(from, to, name);
    double length = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      length += distanceInSpace(this->mesh_, path[i - 1], path[i]);
    }
    return length;
  }

private:
  std::vector<SurfacePoint> pathBetween(
    const PlacedPoint& from, const PlacedPoint& to, const std::string& name)
  {
    const bool isNear = commonFace(this->mesh_, from.point, to.point) != NoId;
    return isNear ? std::vector<SurfacePoint>{ from.point, to.point }
                  : this->joinFar(from, to, name);
  }

  std::vector<SurfacePoint> joinFar(
    const PlacedPoint& from, const PlacedPoint& to, const std::string& name)
  {
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

  /// Appends a path that begins at the curve's last point. Edges merely cut it; at vertices it may
  /// bend.
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

/// Whether two places of one point share a face, or faces without area lie between them.
bool areJoined(const TriangleMesh& mesh, const SurfacePoint& from, const SurfacePoint& to)
{
  std::vector<Id> front;
  std::set<Id> reached;
  const auto reach = [&](Id face)
  {
    if (reached.insert(face).second && mesh.shape(face).hasZeroArea())
    {
      front.push_back(face);
    }
  };
  forEachFace(mesh, from, reach);
  while (!front.empty())
  {
    const Id face = front.back();
    front.pop_back();
    for (Id halfedge = 3 * face; halfedge < 3 * face + 3; ++halfedge)
    {
      for (Id s = mesh.nextSibling(halfedge); s != halfedge; s = mesh.nextSibling(s))
      {
        reach(TriangleMesh::faceOf(s));
      }
    }
  }
  bool isReached = false;
  forEachFace(mesh, to, [&](Id face) { isReached = isReached || reached.count(face) != 0; });
  return isReached;
}

/// Chooses the places of a polyline's points.
class PointPlacer
{
public:
  PointPlacer(const TriangleMesh& mesh, double coordinatePrecision, PointProgress& progress,
    CurveJoiner& joiner)
    : mesh_(mesh)
    , coordinatePrecision_(coordinatePrecision)
    , progress_(progress)
    , joiner_(joiner)
    , components_(mesh)
  {
  }

  /// The polyline on the surface: several lines if it changes from one sheet to another. A closed
  /// polyline that stays whole ends in its first point.
  std::vector<PlacedLine> run(const LocatedPolyline& polyline)
  {
    std::vector<PlacedLine> places; // of each point
    for (std::size_t i = 0; i < polyline.points.size(); ++i)
    {
      this->progress_.countPlaced();
      places.push_back(this->placesOf(polyline, i));
    }
    return this->linesThrough(places, this->choose(places, polyline), polyline.closed);
  }

private:
  /// The different places on a point's faces; faces that meet in its vertex or edge give the same
  /// place.
  std::vector<PlacedPoint> placesOf(const LocatedPolyline& polyline, std::size_t index) const
  {
    std::vector<PlacedPoint> places;
    std::set<std::pair<SurfacePoint::Kind, Id>> elements;
    for (const Id face : polyline.faces[index])
    {
      const SnappedPoint snapped =
        snapToFace(this->mesh_, face, polyline.points[index], this->coordinatePrecision_);
      const SurfacePoint& place = snapped.place;
      const Id element =
        place.kind == SurfacePoint::Kind::Edge ? this->mesh_.edgeOf(place.id) : place.id;
      if (elements.emplace(place.kind, element).second)
      {
        places.push_back(
          { place, position(this->mesh_, place), snapped.tolerance, snapped.distance, index });
      }
    }
    return places;
  }

  std::vector<ChosenPlaces> choose(
    const std::vector<std::vector<PlacedPoint>>& places, const LocatedPolyline& polyline)
  {
    std::vector<PossiblePlaces> possible(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      for (const PlacedPoint& place : places[i])
      {
        possible[i].push_back(place.point);
      }
    }
    const LengthBetween lengthBetween = [&](std::size_t point, std::size_t from, std::size_t to)
    {
      return this->joiner_.lengthBetween(
        places[point][from], places[(point + 1) % places.size()][to], polyline.name);
    };
    return choosePlaces(this->mesh_, possible, polyline.closed, this->components_, lengthBetween);
  }

  /// Cuts the polyline where it changes from one sheet to another. Places on both sides of faces
  /// without area are on one sheet.
  std::vector<PlacedLine> linesThrough(const std::vector<std::vector<PlacedPoint>>& places,
    const std::vector<ChosenPlaces>& chosen, bool closed) const
  {
    const std::size_t count = places.size();
    const auto isChange = [&](std::size_t i)
    {
      const auto [arrival, departure] = chosen[i];
      return arrival != departure &&
        !areJoined(this->mesh_, places[i][arrival].point, places[i][departure].point);
    };
    std::size_t change = 0;
    while (change < count && !isChange(change))
    {
      ++change;
    }
    const bool isCutOpen = closed && change < count;
    const std::size_t first = isCutOpen ? change : 0;
    std::vector<PlacedLine> lines(1);
    lines.back().push_back(places[first][chosen[first].departure]);
    for (std::size_t i = 1; i < count + (isCutOpen ? 1 : 0); ++i)
    {
      const std::size_t at = (first + i) % count;
      lines.back().push_back(places[at][chosen[at].arrival]);
      if (isChange(at) && i < count)
      {
        lines.push_back({ places[at][chosen[at].departure] });
      }
    }
    return lines;
  }

  const TriangleMesh& mesh_;
  const double coordinatePrecision_;
  PointProgress& progress_;
  CurveJoiner& joiner_;
  PlaceComponents components_;
};

/// Removes points that repeat their predecessors, and closes lines.
class RepeatRemover
{
public:
  explicit RepeatRemover(const TriangleMesh& mesh)
    : mesh_(mesh)
  {
  }

  Id repeatedPoints() const { return this->repeatedPoints_; }
  double snapDistance() const { return this->snapDistance_; }

  /// \param closed whether the line's last point joins its first.
  PlacedLine run(const LocatedPolyline& polyline, const PlacedLine& line, bool closed)
  {
    PlacedLine kept;
    for (const PlacedPoint& next : line)
    {
      this->snapDistance_ = std::max(this->snapDistance_, next.distance);
      if (!kept.empty() && this->isOnePlace(kept.back(), next))
      {
        this->leaveOut(polyline, next, kept.back());
        continue;
      }
      kept.push_back(next);
    }
    this->close(polyline, closed, kept);
    return kept;
  }

private:
  /// Whether two places are one, as the direction between them would be rounding. Two vertices
  /// never are.
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
    ++this->repeatedPoints_;
    this->snapDistance_ =
      std::max(this->snapDistance_, norm(polyline.points[repeated.index] - kept.position));
  }

  /// Ends a closed line, and an open one that returns to its first place, exactly there.
  void close(const LocatedPolyline& polyline, bool closed, PlacedLine& kept)
  {
    const bool comesBack = kept.size() > 1 && this->isOnePlace(kept.front(), kept.back());
    if (comesBack)
    {
      const PlacedPoint last = kept.back();
      kept.back() = kept.front();
      kept.back().index = last.index;
      this->leaveOut(polyline, last, kept.front());
      // An open line's last point was given by the user; a closed line repeats its first point
      // instead.
      this->repeatedPoints_ -= closed ? 0 : 1;
    }
    else if (closed && kept.size() > 1)
    {
      kept.push_back(kept.front());
    }
  }

  const TriangleMesh& mesh_;
  Id repeatedPoints_ = 0;
  double snapDistance_ = 0.0;
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
  CurveJoiner joiner(mesh, join, pointProgress);
  PointPlacer placer(mesh, options.coordinatePrecision, pointProgress, joiner);
  RepeatRemover remover(mesh);
  for (const LocatedPolyline& polyline : polylines)
  {
    const std::vector<PlacedLine> lines = placer.run(polyline);
    const bool isWhole = lines.size() == 1;
    for (const PlacedLine& line : lines)
    {
      const PlacedLine kept = remover.run(polyline, line, isWhole && polyline.closed);
      result.curves.push_back(joiner.run(kept, polyline.name));
      result.curves.back().source = polyline.source;
    }
    pointProgress.finish(polyline);
  }
  result.snapDistance = remover.snapDistance();
  result.repeatedPoints = remover.repeatedPoints();
  return result;
}

}
