// SPDX-License-Identifier: BSD-3-Clause
#include "source/PlaceChoice.h"

#include "Tolerance.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace geodesic
{

namespace
{

/// If more joins than this are equally good, their lengths are not computed, as each needs a solve;
/// the first one is taken.
constexpr std::size_t MaximumJoins = 16;

/// The search for a closed polyline begins at no more than this many places of its first point.
constexpr std::size_t MaximumBeginnings = 16;

/// The breaks of a way along the polyline, the worst kind first: consecutive points that no path
/// joins; consecutive points that share no face; points at which the way changes from one place to
/// another.
using Breaks = std::array<Id, 3>;

Breaks operator+(const Breaks& a, const Breaks& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

constexpr Breaks Disconnected{ 1, 0, 0 };
constexpr Breaks Gap{ 0, 1, 0 };
constexpr Breaks Change{ 0, 0, 1 };
/// The breaks of a place that must not be used: more than any polyline has.
constexpr Breaks Never{ NoId / 2, 0, 0 };

/// Ranks ways with equal breaks.
struct Way
{
  double length = Infinity;
  /// The sum of the dimensions of its places' elements (vertex 0, edge 1, face 2).
  std::uint64_t dimensions = 0;

  bool isBetterThan(const Way& other) const
  {
    constexpr double margin = 1.0 - tolerance::Tie;
    const bool isShorter = this->length < margin * other.length;
    const bool isLonger = other.length < margin * this->length;
    return isShorter || (!isLonger && this->dimensions < other.dimensions);
  }
};

/// From a place of a layer to a place of the next one.
using Step = std::pair<std::size_t, std::size_t>;

/// The places of one point as a layer of the search: those at which a way arrives, or those from
/// which it departs.
struct Layer
{
  const PossiblePlaces& places;
  /// The steps to the next layer without a break, and the breaks that the others may have.
  std::set<Step> steps;
  std::vector<Breaks> kinds;
  /// The fewest breaks from each place to the end.
  std::vector<Breaks> left = {};
  /// The best way to each place, infinitely long if none has the fewest breaks, and the place of
  /// the layer before from which it comes.
  std::vector<Way> ways = {};
  std::vector<std::size_t> from = {};

  const Breaks& leastLeft() const
  {
    return *std::min_element(this->left.begin(), this->left.end());
  }
};

/// Departures, with steps to places in the same face.
Layer departures(const TriangleMesh& mesh, const PossiblePlaces& from, const PossiblePlaces& to)
{
  std::map<Id, std::vector<std::size_t>> placesIn; // of each face
  for (std::size_t b = 0; b < to.size(); ++b)
  {
    forEachFace(mesh, to[b], [&](Id face) { placesIn[face].push_back(b); });
  }
  Layer layer{ from, {}, { Disconnected, Gap } };
  for (std::size_t a = 0; a < from.size(); ++a)
  {
    forEachFace(mesh, from[a],
      [&](Id face)
      {
        for (const std::size_t b : placesIn[face])
        {
          layer.steps.emplace(a, b);
        }
      });
  }
  return layer;
}

Layer arrivals(const PossiblePlaces& places)
{
  Layer layer{ places, {}, { Change } };
  for (std::size_t a = 0; a < places.size(); ++a)
  {
    layer.steps.emplace(a, a);
  }
  return layer;
}

/// Finds the best way through the places of a row of points. Two passes: backwards the fewest
/// breaks from each place to the end (dynamic programming), then forwards the best way among those
/// with the fewest. A place is on one of these if a best way leads to it.
class RowOfPoints
{
public:
  struct Result
  {
    Breaks breaks = Never;
    Way way;
    /// The place in each layer: where the first point is left, where the second is reached, where
    /// it is left, and so on.
    std::vector<std::size_t> places;
  };

  /// \param row the numbers of consecutive points.
  RowOfPoints(const TriangleMesh& mesh, const std::vector<PossiblePlaces>& places,
    const std::vector<std::size_t>& row, MeshComponents& components,
    const LengthBetween& lengthBetween)
    : row_(row)
    , components_(components)
    , lengthBetween_(lengthBetween)
  {
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
    {
      this->layers_.push_back(departures(mesh, places[row[i]], places[row[i + 1]]));
      this->layers_.push_back(arrivals(places[row[i + 1]]));
    }
    this->layers_.push_back({ places[row.back()], {}, {} });
  }

  /// \param loopFrom the place of the first point from which the way departs, in a row that ends
  ///        with its first point again and must return there; if empty, any.
  Result run(std::optional<std::size_t> loopFrom)
  {
    Layer& first = this->layers_.front();
    Layer& last = this->layers_.back();
    last.left.assign(last.places.size(), loopFrom ? Never : Breaks{});
    last.left[loopFrom.value_or(0)] = {};
    for (std::size_t l = this->layers_.size() - 1; l-- > 0;)
    {
      this->countBreaks(l);
    }
    const Breaks fewest = loopFrom ? first.left[*loopFrom] : first.leastLeft();
    first.ways.assign(first.places.size(), {});
    for (std::size_t a = 0; a < first.places.size(); ++a)
    {
      if (first.left[a] == fewest && a == loopFrom.value_or(a))
      {
        // The end of a loop counts the place.
        first.ways[a] = { 0.0, loopFrom ? 0 : static_cast<std::uint64_t>(first.places[a].kind) };
      }
    }
    for (std::size_t l = 0; l + 1 < this->layers_.size(); ++l)
    {
      this->findWays(l);
    }
    return this->trace(fewest);
  }

  /// The best way that returns to its first place, for a row that ends with its first point again.
  Result runLoops()
  {
    Result best;
    const std::size_t beginnings = this->layers_.front().places.size();
    for (std::size_t a = 0; a < std::min(beginnings, MaximumBeginnings); ++a)
    {
      Result result = this->run(a);
      if (result.breaks < best.breaks ||
        (result.breaks == best.breaks && result.way.isBetterThan(best.way)))
      {
        best = std::move(result);
      }
    }
    return best;
  }

private:
  /// Whether a step, which is none without a break, has the kind of break.
  bool isOf(const Breaks& kind, std::size_t l, const Step& step) const
  {
    return kind == Change ||
      (this->components_.of(this->layers_[l].places[step.first]) ==
        this->components_.of(this->layers_[l + 1].places[step.second])) == (kind == Gap);
  }

  void countBreaks(std::size_t l)
  {
    Layer& layer = this->layers_[l];
    const Layer& next = this->layers_[l + 1];
    layer.left.assign(layer.places.size(), Never);
    for (const auto& [a, b] : layer.steps)
    {
      layer.left[a] = std::min(layer.left[a], next.left[b]);
    }
    for (const Breaks& kind : layer.kinds)
    {
      const Breaks least = next.leastLeft() + kind;
      for (std::size_t a = 0; a < layer.left.size(); ++a)
      {
        for (std::size_t b = 0; b < next.left.size() && least < layer.left[a]; ++b)
        {
          const Breaks left = next.left[b] + kind;
          if (left < layer.left[a] && this->isOf(kind, l, { a, b }))
          {
            layer.left[a] = left;
          }
        }
      }
    }
  }

  void findWays(std::size_t l)
  {
    const Layer& layer = this->layers_[l];
    Layer& next = this->layers_[l + 1];
    next.ways.assign(next.places.size(), {});
    next.from.assign(next.places.size(), 0);
    for (const Step& step : layer.steps)
    {
      // All places of a point are at one point in space.
      if (layer.left[step.first] == next.left[step.second])
      {
        this->improve(l, step, 0.0);
      }
    }
    for (const Breaks& kind : layer.kinds)
    {
      const std::vector<Step> steps = this->bestSteps(l, kind);
      const bool areMeasured = kind == Gap && steps.size() <= MaximumJoins;
      for (const auto& [a, b] : steps)
      {
        this->improve(
          l, { a, b }, areMeasured ? this->lengthBetween_(this->row_[l / 2], a, b) : 0.0);
      }
    }
  }

  /// The steps with one break that are on ways with the fewest breaks.
  std::vector<Step> bestSteps(std::size_t l, const Breaks& kind) const
  {
    const Layer& layer = this->layers_[l];
    const Layer& next = this->layers_[l + 1];
    const Breaks least = next.leastLeft() + kind;
    std::vector<Step> steps;
    for (std::size_t a = 0; a < layer.left.size(); ++a)
    {
      const bool isOnWay = layer.ways[a].length < Infinity && !(layer.left[a] < least);
      for (std::size_t b = 0; b < next.left.size() && isOnWay; ++b)
      {
        if (next.left[b] + kind == layer.left[a] && this->isOf(kind, l, { a, b }))
        {
          steps.emplace_back(a, b);
        }
      }
    }
    return steps;
  }

  void improve(std::size_t l, const Step& step, double length)
  {
    const auto [a, b] = step;
    const bool isNewPlace = l % 2 == 0 || a != b;
    Layer& next = this->layers_[l + 1];
    Way way = this->layers_[l].ways[a];
    way.length += length;
    way.dimensions += isNewPlace ? static_cast<std::uint64_t>(next.places[b].kind) : 0;
    if (way.isBetterThan(next.ways[b]))
    {
      next.ways[b] = way;
      next.from[b] = a;
    }
  }

  Result trace(const Breaks& breaks) const
  {
    const std::vector<Way>& ends = this->layers_.back().ways;
    const auto best = std::min_element(
      ends.begin(), ends.end(), [](const Way& a, const Way& b) { return a.isBetterThan(b); });
    std::vector<std::size_t> places = { static_cast<std::size_t>(best - ends.begin()) };
    for (std::size_t l = this->layers_.size() - 1; l > 0; --l)
    {
      places.push_back(this->layers_[l].from[places.back()]);
    }
    std::reverse(places.begin(), places.end());
    return { breaks, *best, places };
  }

  const std::vector<std::size_t>& row_;
  MeshComponents& components_;
  const LengthBetween& lengthBetween_;
  std::vector<Layer> layers_;
};

} // anonymous namespace

Id MeshComponents::of(const SurfacePoint& point)
{
  if (this->ofVertices_.empty())
  {
    this->ofVertices_ = this->mesh_.components();
  }
  const bool isVertex = point.kind == SurfacePoint::Kind::Vertex;
  return this
    ->ofVertices_[isVertex ? point.id : this->mesh_.triangle(someFace(this->mesh_, point))[0]];
}

std::vector<ChosenPlaces> choosePlaces(const TriangleMesh& mesh,
  const std::vector<PossiblePlaces>& places, bool closed, MeshComponents& components,
  const LengthBetween& lengthBetween)
{
  const std::size_t count = places.size();
  std::vector<ChosenPlaces> result(count);
  // A closed polyline begins and ends at a point with the fewest places.
  const auto fewest = std::min_element(places.begin(), places.end(),
    [](const PossiblePlaces& a, const PossiblePlaces& b) { return a.size() < b.size(); });
  const bool isLoop = closed && count > 1;
  const auto first = isLoop ? static_cast<std::size_t>(fewest - places.begin()) : std::size_t(0);
  const std::size_t last = isLoop ? count : count - 1;

  // A point with a single place separates the polyline into independent rows.
  const auto isChoice = [&](std::size_t point) { return places[point].size() > 1; };
  std::vector<std::size_t> row;
  for (std::size_t i = 0; i <= last; ++i)
  {
    row.push_back((first + i) % count);
    if (i < last && (i == 0 || isChoice(row.back())))
    {
      continue;
    }
    if (std::any_of(row.begin(), row.end(), isChoice))
    {
      RowOfPoints search(mesh, places, row, components, lengthBetween);
      const std::vector<std::size_t> best =
        (isLoop && row.size() > last ? search.runLoops() : search.run({})).places;
      for (std::size_t k = 0; k < best.size(); ++k)
      {
        ChosenPlaces& chosen = result[row[(k + 1) / 2]];
        (k % 2 == 0 ? chosen.departure : chosen.arrival) = best[k];
      }
    }
    row = { row.back() };
  }
  if (!isLoop)
  {
    result.front().arrival = result.front().departure;
  }
  return result;
}

}
