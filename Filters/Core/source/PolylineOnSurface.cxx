// SPDX-License-Identifier: BSD-3-Clause
#include "source/PolylineOnSurface.h"

#include "Errors.h"
#include "Tolerance.h"
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

/// Points put onto the surface between two calls of the watcher.
constexpr std::size_t PointsPerReport = 256;

/// A place of a polyline's point on the surface.
struct PlacedPoint : SnappedPoint
{
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
    throw SourceError("There are no points in " + polyline.name.text() +
      ". Give it one point at least, or leave it out.");
  }
  const auto isMissing = [&mesh](Id face) { return face >= mesh.numberOfFaces(); };
  for (std::size_t i = 0; i < polyline.points.size(); ++i)
  {
    const auto fail = [&](const char* what)
    { throw SourceError(polyline.nameOfPoint(i).atBeginning() + what); };
    if (!isFinite(polyline.points[i]))
    {
      fail(" has a coordinate that is not finite. Remove or repair the point.");
    }
    if (i >= polyline.faces.size() || polyline.faces[i].empty() ||
      std::any_of(polyline.faces[i].begin(), polyline.faces[i].end(), isMissing))
    {
      fail(" has not been located on a face of the surface.");
    }
  }
}

/// Puts polylines onto the surface, one after another: chooses the places of their points, leaves
/// out those that repeat their predecessors, and joins the others to curves.
class PolylinePutter
{
public:
  PolylinePutter(const TriangleMesh& mesh, double coordinatePrecision, const JoinPoints& join,
    const Job& job, std::size_t numberOfPoints)
    : mesh_(mesh)
    , coordinatePrecision_(coordinatePrecision)
    , join_(join)
    , job_(job)
    , numberOfPoints_(static_cast<double>(numberOfPoints))
    , components_(mesh)
  {
  }

  void put(const LocatedPolyline& polyline, std::size_t number)
  {
    this->number_ = number;
    const std::vector<PlacedLine> places = this->placesOf(polyline);
    const std::vector<PlacedLine> lines =
      this->linesThrough(places, this->choose(places, polyline), polyline.closed);
    const bool isClosed = polyline.closed && lines.size() == 1;
    for (const PlacedLine& line : lines)
    {
      this->result_.curves.push_back(
        this->join(this->withoutRepeats(line, polyline, isClosed), polyline));
      this->result_.curves.back().source = polyline.source;
    }
    this->pointsDone_ += static_cast<double>(polyline.points.size());
  }

  SourceCurves take() { return std::move(this->result_); }

private:
  /// The part of the job for a point of the current polyline.
  Job jobOf(std::size_t point) const
  {
    const double before = this->pointsDone_ + static_cast<double>(point);
    return this->job_.part(before / this->numberOfPoints_, (before + 1.0) / this->numberOfPoints_);
  }

  /// For each point the different places on its faces; faces that meet in its vertex or edge give
  /// the same place.
  std::vector<PlacedLine> placesOf(const LocatedPolyline& polyline)
  {
    std::vector<PlacedLine> places(polyline.points.size());
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      if (this->pointsPlaced_++ % PointsPerReport == 0)
      {
        this->jobOf(0).reach(0.0);
      }
      std::set<std::pair<SurfacePoint::Kind, Id>> elements;
      for (const Id face : polyline.faces[i])
      {
        const SnappedPoint snapped =
          snapToFace(this->mesh_, face, polyline.points[i], this->coordinatePrecision_);
        const SurfacePoint& p = snapped.place;
        const Id element = p.kind == SurfacePoint::Kind::Edge ? this->mesh_.edgeOf(p.id) : p.id;
        if (elements.emplace(p.kind, element).second)
        {
          places[i].push_back({ snapped, i });
        }
      }
    }
    return places;
  }

  std::vector<ChosenPlaces> choose(
    const std::vector<PlacedLine>& places, const LocatedPolyline& polyline)
  {
    std::vector<PossiblePlaces> possible(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      for (const PlacedPoint& placed : places[i])
      {
        possible[i].push_back(placed.place);
      }
    }
    const LengthBetween lengthBetween = [&](std::size_t point, std::size_t from, std::size_t to)
    {
      const PlacedPoint& next = places[(point + 1) % places.size()][to];
      const std::vector<SurfacePoint> path = this->joinFar(places[point][from], next, polyline);
      return this->lengthOf(path);
    };
    return choosePlaces(this->mesh_, possible, polyline.closed, this->components_, lengthBetween);
  }

  /// Several lines if the polyline changes from one sheet to another.
  std::vector<PlacedLine> linesThrough(const std::vector<PlacedLine>& places,
    const std::vector<ChosenPlaces>& chosen, bool closed) const
  {
    const std::size_t count = places.size();
    const auto isChange = [&](std::size_t i)
    {
      const auto [arrival, departure] = chosen[i];
      return arrival != departure &&
        commonFace(this->mesh_, places[i][arrival].place, places[i][departure].place) == NoId;
    };
    std::size_t first = closed ? 0 : count;
    while (first < count && !isChange(first))
    {
      ++first;
    }
    const bool isCutOpen = first < count;
    first = isCutOpen ? first : 0;
    std::vector<PlacedLine> lines = { { places[first][chosen[first].departure] } };
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

  /// Whether two places are one, as the direction between them would be rounding. Two vertices
  /// never are.
  bool isOnePlace(const PlacedPoint& a, const PlacedPoint& b) const
  {
    if (samePlace(this->mesh_, a.place, b.place))
    {
      return true;
    }
    const bool areVertices =
      a.place.kind == SurfacePoint::Kind::Vertex && b.place.kind == SurfacePoint::Kind::Vertex;
    return !areVertices &&
      norm(position(this->mesh_, a.place) - position(this->mesh_, b.place)) <=
      std::min(a.tolerance, b.tolerance) &&
      commonFace(this->mesh_, a.place, b.place) != NoId;
  }

  void noteDistance(double distance)
  {
    this->result_.snapDistance = std::max(this->result_.snapDistance, distance);
  }

  double lengthOf(const std::vector<SurfacePoint>& path) const
  {
    double length = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      length += distanceInSpace(this->mesh_, path[i - 1], path[i]);
    }
    return length;
  }

  void noteDetour(const PlacedPoint& from, const PlacedPoint& to,
    const std::vector<SurfacePoint>& path, const SegmentOfPolyline& segment)
  {
    // Ends that differ by rounding tell nothing.
    const double straight =
      std::max(distanceInSpace(this->mesh_, from.place, to.place), from.tolerance + to.tolerance);
    const double length = path.size() > 2 ? this->lengthOf(path) : 0.0;
    if (length > tolerance::Detour * straight)
    {
      this->result_.detours.push_back(segment);
      this->result_.largestDetour = std::max(this->result_.largestDetour, length / straight);
    }
  }

  void leaveOut(
    const PlacedPoint& repeated, const PlacedPoint& kept, const LocatedPolyline& polyline)
  {
    ++this->result_.repeatedPoints;
    this->noteDistance(norm(polyline.points[repeated.index] - position(this->mesh_, kept.place)));
  }

  /// A closed line, and an open one that returns to its first place, ends exactly there.
  ///
  /// \param closed whether the line's last point joins its first.
  PlacedLine withoutRepeats(const PlacedLine& line, const LocatedPolyline& polyline, bool closed)
  {
    PlacedLine kept;
    for (const PlacedPoint& next : line)
    {
      this->noteDistance(next.distance);
      if (!kept.empty() && this->isOnePlace(kept.back(), next))
      {
        this->leaveOut(next, kept.back(), polyline);
        continue;
      }
      kept.push_back(next);
    }
    if (kept.size() > 1 && this->isOnePlace(kept.front(), kept.back()))
    {
      const PlacedPoint last = kept.back();
      kept.back() = kept.front();
      kept.back().index = last.index;
      this->leaveOut(last, kept.front(), polyline);
      // An open line's last point was given by the user; a closed line repeats its first point
      // instead.
      this->result_.repeatedPoints -= closed ? 0 : 1;
    }
    else if (closed && kept.size() > 1)
    {
      kept.push_back(kept.front());
    }
    return kept;
  }

  /// Edges merely cut the curve; at vertices on its way it may bend.
  ///
  /// \param polyline of which this is a part.
  SourceCurve join(const PlacedLine& line, const LocatedPolyline& polyline)
  {
    SourceCurve curve = pointCurve(line.front().place);
    std::vector<SegmentOfPolyline>& given = this->result_.given.emplace_back();
    for (std::size_t n = 1; n < line.size(); ++n)
    {
      std::vector<SurfacePoint> path = { line[n - 1].place, line[n].place };
      if (commonFace(this->mesh_, path[0], path[1]) == NoId)
      {
        path = this->joinFar(line[n - 1], line[n], polyline);
      }
      // Points that repeat the one before have been left out.
      const std::size_t count = polyline.points.size();
      const SegmentOfPolyline segment = { this->number_, (line[n].index + count - 1) % count };
      this->noteDetour(line[n - 1], line[n], path, segment);
      given.insert(given.end(), path.size() - 1, segment);
      for (std::size_t i = 1; i < path.size(); ++i)
      {
        const bool isCut = i + 1 < path.size() && path[i].kind == SurfacePoint::Kind::Edge;
        curve.faces.push_back(commonFace(this->mesh_, path[i - 1], path[i]));
        curve.points.push_back(path[i]);
        curve.isCut.push_back(isCut ? 1 : 0);
      }
    }
    return curve;
  }

  std::vector<SurfacePoint> joinFar(
    const PlacedPoint& from, const PlacedPoint& to, const LocatedPolyline& polyline) const
  {
    std::vector<SurfacePoint> path = this->join_(from.place, to.place, this->jobOf(from.index));
    if (path.empty())
    {
      const std::string names = polyline.pointNames.empty()
        ? "Points " + std::to_string(from.index) + " and " + std::to_string(to.index) + " of " +
          polyline.name.text()
        : polyline.pointNames[from.index].atBeginning() + " and " +
          polyline.pointNames[to.index].text();
      throw SourceError(names +
        " are on different components of the surface, so that no path on it joins them. Split the "
        "polyline between them, or connect the surface.");
    }
    return path;
  }

  const TriangleMesh& mesh_;
  const double coordinatePrecision_;
  const JoinPoints& join_;
  const Job& job_;
  const double numberOfPoints_;
  /// Of the polyline that is put.
  std::size_t number_ = 0;
  /// Points of the finished polylines.
  double pointsDone_ = 0.0;
  std::size_t pointsPlaced_ = 0;
  MeshComponents components_;
  SourceCurves result_;
};

} // anonymous namespace

SourceCurves putOntoSurface(const TriangleMesh& mesh, const std::vector<LocatedPolyline>& polylines,
  double coordinatePrecision, const JoinPoints& join, const Job& job)
{
  std::size_t numberOfPoints = 0;
  for (const LocatedPolyline& polyline : polylines)
  {
    check(mesh, polyline);
    numberOfPoints += polyline.points.size();
  }
  PolylinePutter putter(mesh, coordinatePrecision, join, job, numberOfPoints);
  for (const LocatedPolyline& polyline : polylines)
  {
    putter.put(polyline, static_cast<std::size_t>(&polyline - polylines.data()));
  }
  return putter.take();
}

}
