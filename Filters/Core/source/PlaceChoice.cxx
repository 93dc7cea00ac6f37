// SPDX-License-Identifier: BSD-3-Clause
#include "source/PlaceChoice.h"

#include "Tolerance.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace geodesic
{

namespace
{

/// If more joins than this are equally good, their lengths are not computed, as each needs a solve;
/// the first one is taken.
constexpr std::size_t MaximumJoins = 16;

/// The search for a closed polyline begins at no more than this many places of its first point.
constexpr std::size_t MaximumBeginnings = 16;

/// The breaks of a way along the polyline, the worst kind first.
struct Breaks
{
  /// Consecutive points that no path joins.
  Id disconnected = 0;
  /// Consecutive points that share no face.
  Id gaps = 0;
  /// Points at which the way changes from one place to another.
  Id changes = 0;

  auto key() const { return std::tie(this->disconnected, this->gaps, this->changes); }
  bool operator<(const Breaks& other) const { return this->key() < other.key(); }
  bool operator==(const Breaks& other) const { return this->key() == other.key(); }
  Breaks operator+(const Breaks& other) const
  {
    return { this->disconnected + other.disconnected, this->gaps + other.gaps,
      this->changes + other.changes };
  }
};

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
  Way to(double more, const SurfacePoint& place) const
  {
    return { this->length + more, this->dimensions + static_cast<std::uint64_t>(place.kind) };
  }
};

/// Places of two consecutive points.
struct Pair
{
  std::size_t from;
  std::size_t to;
};

/// The pairs that share a face.
std::vector<Pair> pairsInOneFace(
  const TriangleMesh& mesh, const PossiblePlaces& from, const PossiblePlaces& to)
{
  std::vector<std::pair<Id, std::size_t>> faces;
  for (std::size_t b = 0; b < to.size(); ++b)
  {
    forEachFace(mesh, to[b], [&](Id face) { faces.emplace_back(face, b); });
  }
  std::sort(faces.begin(), faces.end());
  std::vector<Pair> pairs;
  std::vector<std::size_t> found;
  for (std::size_t a = 0; a < from.size(); ++a)
  {
    found.clear();
    forEachFace(mesh, from[a],
      [&](Id face)
      {
        auto at =
          std::lower_bound(faces.begin(), faces.end(), std::make_pair(face, std::size_t(0)));
        for (; at != faces.end() && at->first == face; ++at)
        {
          found.push_back(at->second);
        }
      });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    for (const std::size_t b : found)
    {
      pairs.push_back({ a, b });
    }
  }
  return pairs;
}

const Breaks& leastOf(const std::vector<Breaks>& breaks)
{
  return *std::min_element(breaks.begin(), breaks.end());
}

/// Finds the best way through the places of a row of points. The way begins at any of the first
/// point's places with the given breaks, and ends at any of the last point's. Two passes: backwards
/// the fewest breaks from each place to the end (dynamic programming), then forwards the best way
/// among those with the fewest. A place is on one of these if a best way leads to it.
class RowOfPoints
{
public:
  struct Result
  {
    Breaks breaks;
    Way way;
    std::vector<ChosenPlaces> places;
  };

  RowOfPoints(const TriangleMesh& mesh, const std::vector<const PossiblePlaces*>& places,
    PlaceComponents& components, const LengthBetween& lengthBetween)
    : places_(places)
    , components_(components)
    , lengthBetween_(lengthBetween)
  {
    for (std::size_t i = 0; i + 1 < places.size(); ++i)
    {
      this->pairs_.push_back(pairsInOneFace(mesh, *places[i], *places[i + 1]));
    }
  }

  /// \param beginning the breaks at departing from each place of the first point.
  /// \param end the breaks after arriving at each place of the last point.
  Result run(const std::vector<Breaks>& beginning, const std::vector<Breaks>& end)
  {
    this->countBreaks(end);
    this->findWays(beginning);
    return this->trace();
  }

private:
  std::size_t last() const { return this->places_.size() - 1; }
  std::size_t countAt(std::size_t i) const { return this->places_[i]->size(); }
  const SurfacePoint& place(std::size_t i, std::size_t a) const { return (*this->places_[i])[a]; }
  Id component(std::size_t i, std::size_t a) const
  {
    return this->components_.of(this->place(i, a));
  }

  void countBreaks(const std::vector<Breaks>& end);
  std::vector<Breaks> afterChange(const std::vector<Breaks>& breaks) const;
  void joinAcross(std::size_t i, std::vector<Breaks>& from) const;
  void findWays(const std::vector<Breaks>& beginning);
  void findArrivals(std::size_t i);
  void findDepartures(std::size_t i);
  std::vector<Pair> bestJoins(std::size_t i, const Breaks& kind) const;
  void improveArrival(std::size_t i, const Pair& pair, double length);
  Result trace() const;

  const std::vector<const PossiblePlaces*>& places_;
  PlaceComponents& components_;
  const LengthBetween& lengthBetween_;
  /// For each point but the last.
  std::vector<std::vector<Pair>> pairs_;

  /// For each point and place, the fewest breaks from arriving and from departing there to the end.
  std::vector<std::vector<Breaks>> fromArrival_;
  std::vector<std::vector<Breaks>> fromDeparture_;
  Breaks fewest_;

  /// The best ways to arrive at and to depart from a place, infinitely long where none has the
  /// fewest breaks, and the preceding places: of the previous point, and of the same point.
  std::vector<std::vector<Way>> arrival_;
  std::vector<std::vector<Way>> departure_;
  std::vector<std::vector<std::size_t>> arrivalFrom_;
  std::vector<std::vector<std::size_t>> departureFrom_;
};

/// The fewest breaks if the way may change from one place of a point to another.
std::vector<Breaks> RowOfPoints::afterChange(const std::vector<Breaks>& breaks) const
{
  const Breaks changed = leastOf(breaks) + Change;
  std::vector<Breaks> result = breaks;
  for (Breaks& b : result)
  {
    b = std::min(b, changed);
  }
  return result;
}

/// Adds joins from the places of a point to those of the next without a common face: a gap within a
/// component, a disconnection between components.
void RowOfPoints::joinAcross(std::size_t i, std::vector<Breaks>& from) const
{
  const std::vector<Breaks>& to = this->fromArrival_[i + 1];
  const Breaks least = leastOf(to);
  const auto mayImprove = [&](const Breaks& b) { return least + Gap < b; };
  if (std::none_of(from.begin(), from.end(), mayImprove))
  {
    return;
  }
  std::map<Id, Breaks> leastOfComponent;
  for (std::size_t b = 0; b < to.size(); ++b)
  {
    Breaks& breaks = leastOfComponent.emplace(this->component(i + 1, b), to[b]).first->second;
    breaks = std::min(breaks, to[b]);
  }
  for (std::size_t a = 0; a < from.size(); ++a)
  {
    from[a] = std::min(from[a], least + Disconnected);
    const auto found = leastOfComponent.find(this->component(i, a));
    if (found != leastOfComponent.end())
    {
      from[a] = std::min(from[a], found->second + Gap);
    }
  }
}

void RowOfPoints::countBreaks(const std::vector<Breaks>& end)
{
  this->fromArrival_.assign(this->places_.size(), {});
  this->fromDeparture_.assign(this->places_.size(), {});
  this->fromArrival_[this->last()] = end;
  for (std::size_t i = this->last(); i-- > 0;)
  {
    std::vector<Breaks> from(this->countAt(i), Never);
    for (const Pair& pair : this->pairs_[i])
    {
      from[pair.from] = std::min(from[pair.from], this->fromArrival_[i + 1][pair.to]);
    }
    this->joinAcross(i, from);
    this->fromArrival_[i] = this->afterChange(from);
    this->fromDeparture_[i] = std::move(from);
  }
}

void RowOfPoints::findWays(const std::vector<Breaks>& beginning)
{
  this->arrival_.assign(this->places_.size(), {});
  this->departure_.assign(this->places_.size(), {});
  this->arrivalFrom_.assign(this->places_.size(), {});
  this->departureFrom_.assign(this->places_.size(), {});
  this->fewest_ = Never;
  for (std::size_t a = 0; a < this->countAt(0); ++a)
  {
    this->fewest_ = std::min(this->fewest_, beginning[a] + this->fromDeparture_[0][a]);
  }
  for (std::size_t a = 0; a < this->countAt(0); ++a)
  {
    const bool isBest = beginning[a] + this->fromDeparture_[0][a] == this->fewest_;
    this->departure_[0].push_back(isBest ? Way{ 0.0, 0 }.to(0.0, this->place(0, a)) : Way{});
    this->departureFrom_[0].push_back(a);
  }
  for (std::size_t i = 1; i <= this->last(); ++i)
  {
    this->findArrivals(i);
    this->findDepartures(i);
  }
}

/// The joins of one kind from point i to the next, without a common face, that are on ways with the
/// fewest breaks.
std::vector<Pair> RowOfPoints::bestJoins(std::size_t i, const Breaks& kind) const
{
  std::vector<Pair> joins;
  const std::vector<Breaks>& to = this->fromArrival_[i + 1];
  const Breaks least = kind + leastOf(to);
  for (std::size_t a = 0; a < this->countAt(i); ++a)
  {
    const Breaks& left = this->fromDeparture_[i][a];
    if (this->departure_[i][a].length == Infinity || left < least)
    {
      continue;
    }
    for (std::size_t b = 0; b < to.size(); ++b)
    {
      const bool areConnected = this->component(i, a) == this->component(i + 1, b);
      if (kind + to[b] == left && areConnected == (kind == Gap))
      {
        joins.push_back({ a, b });
      }
    }
  }
  return joins;
}

void RowOfPoints::improveArrival(std::size_t i, const Pair& pair, double length)
{
  const Way way = this->departure_[i - 1][pair.from].to(length, this->place(i, pair.to));
  if (way.isBetterThan(this->arrival_[i][pair.to]))
  {
    this->arrival_[i][pair.to] = way;
    this->arrivalFrom_[i][pair.to] = pair.from;
  }
}

void RowOfPoints::findArrivals(std::size_t i)
{
  this->arrival_[i].assign(this->countAt(i), {});
  this->arrivalFrom_[i].assign(this->countAt(i), 0);
  // All places of a point are at one point in space.
  for (const Pair& pair : this->pairs_[i - 1])
  {
    if (this->fromDeparture_[i - 1][pair.from] == this->fromArrival_[i][pair.to])
    {
      this->improveArrival(i, pair, 0.0);
    }
  }
  for (const Pair& pair : this->bestJoins(i - 1, Disconnected))
  {
    this->improveArrival(i, pair, 0.0);
  }
  const std::vector<Pair> joins = this->bestJoins(i - 1, Gap);
  const bool areMeasured = joins.size() <= MaximumJoins;
  for (const Pair& pair : joins)
  {
    this->improveArrival(
      i, pair, areMeasured ? this->lengthBetween_(i - 1, pair.from, pair.to) : 0.0);
  }
}

void RowOfPoints::findDepartures(std::size_t i)
{
  const std::size_t count = this->countAt(i);
  this->departure_[i].assign(count, {});
  this->departureFrom_[i].assign(count, 0);
  if (i == this->last())
  {
    return;
  }
  const std::vector<Breaks>& left = this->fromDeparture_[i];
  const Breaks afterChange = leastOf(left) + Change;
  // A change may come from any place with as many breaks left, so the best of these suffices.
  Way changed;
  std::size_t bestToLeave = count;
  for (std::size_t a = 0; a < count; ++a)
  {
    if (this->fromArrival_[i][a] == afterChange && this->arrival_[i][a].isBetterThan(changed))
    {
      changed = this->arrival_[i][a];
      bestToLeave = a;
    }
  }
  for (std::size_t a = 0; a < count; ++a)
  {
    if (this->fromArrival_[i][a] == left[a])
    {
      this->departure_[i][a] = this->arrival_[i][a];
      this->departureFrom_[i][a] = a;
    }
    const Way way = changed.to(0.0, this->place(i, a));
    if (bestToLeave < count && left[a] + Change == afterChange &&
      way.isBetterThan(this->departure_[i][a]))
    {
      this->departure_[i][a] = way;
      this->departureFrom_[i][a] = bestToLeave;
    }
  }
}

RowOfPoints::Result RowOfPoints::trace() const
{
  std::size_t place = 0;
  const std::vector<Way>& ends = this->arrival_[this->last()];
  for (std::size_t a = 1; a < ends.size(); ++a)
  {
    place = ends[a].isBetterThan(ends[place]) ? a : place;
  }
  Result result{ this->fewest_, ends[place], std::vector<ChosenPlaces>(this->places_.size()) };
  result.places.back().arrival = place;
  for (std::size_t i = this->last(); i > 0; --i)
  {
    result.places[i].arrival = place;
    place = this->arrivalFrom_[i][place];
    result.places[i - 1].departure = place;
    place = this->departureFrom_[i - 1][place];
  }
  result.places[0].arrival = result.places[0].departure;
  result.places.back().departure = result.places.back().arrival;
  return result;
}

/// A row that ends with its first point again: the way must return to the place from which it
/// departs.
RowOfPoints::Result bestLoop(RowOfPoints& row, std::size_t numberOfBeginnings)
{
  RowOfPoints::Result best;
  for (std::size_t a = 0; a < std::min(numberOfBeginnings, MaximumBeginnings); ++a)
  {
    std::vector<Breaks> beginning(numberOfBeginnings, Never);
    std::vector<Breaks> end(numberOfBeginnings, Change);
    beginning[a] = {};
    end[a] = {};
    RowOfPoints::Result result = row.run(beginning, end);
    if (a == 0 || result.breaks < best.breaks ||
      (result.breaks == best.breaks && result.way.isBetterThan(best.way)))
    {
      best = std::move(result);
    }
  }
  return best;
}

/// \param isLoop whether the row ends with its first point again.
std::vector<ChosenPlaces> chooseInRow(const TriangleMesh& mesh,
  const std::vector<const PossiblePlaces*>& places, bool isLoop, PlaceComponents& components,
  const LengthBetween& lengthBetween)
{
  const auto isChoice = [](const PossiblePlaces* p) { return p->size() > 1; };
  if (std::none_of(places.begin(), places.end(), isChoice))
  {
    return std::vector<ChosenPlaces>(places.size());
  }
  RowOfPoints row(mesh, places, components, lengthBetween);
  if (isLoop)
  {
    return bestLoop(row, places.front()->size()).places;
  }
  const std::vector<Breaks> beginning(places.front()->size());
  const std::vector<Breaks> end(places.back()->size());
  return row.run(beginning, end).places;
}

} // anonymous namespace

Id PlaceComponents::of(const SurfacePoint& place)
{
  if (this->componentOfVertex_.empty())
  {
    this->componentOfVertex_ = this->mesh_.components();
  }
  const Id vertex = place.kind == SurfacePoint::Kind::Vertex
    ? place.id
    : this->mesh_.triangle(someFace(this->mesh_, place))[0];
  return this->componentOfVertex_[vertex];
}

std::vector<ChosenPlaces> choosePlaces(const TriangleMesh& mesh,
  const std::vector<PossiblePlaces>& places, bool closed, PlaceComponents& components,
  const LengthBetween& lengthBetween)
{
  const std::size_t count = places.size();
  std::vector<ChosenPlaces> result(count);
  if (count < 2)
  {
    const auto isOnLess = [](const SurfacePoint& a, const SurfacePoint& b)
    { return a.kind < b.kind; };
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto best = std::min_element(places[i].begin(), places[i].end(), isOnLess);
      result[i].arrival = static_cast<std::size_t>(best - places[i].begin());
      result[i].departure = result[i].arrival;
    }
    return result;
  }
  // A closed polyline begins and ends at a point with the fewest places.
  const auto fewest = std::min_element(places.begin(), places.end(),
    [](const PossiblePlaces& a, const PossiblePlaces& b) { return a.size() < b.size(); });
  const auto first = closed ? static_cast<std::size_t>(fewest - places.begin()) : std::size_t(0);
  const auto at = [&](std::size_t i) { return (first + i) % count; };
  const std::size_t last = closed ? count : count - 1;

  // A point with a single place separates the polyline into independent rows.
  for (std::size_t begin = 0, end = 1; begin < last; begin = end, ++end)
  {
    while (end < last && places[at(end)].size() > 1)
    {
      ++end;
    }
    std::vector<const PossiblePlaces*> row;
    for (std::size_t i = begin; i <= end; ++i)
    {
      row.push_back(&places[at(i)]);
    }
    const auto lengthInRow = [&](std::size_t point, std::size_t from, std::size_t to)
    { return lengthBetween(at(begin + point), from, to); };
    const bool isLoop = closed && end - begin == last;
    const std::vector<ChosenPlaces> best = chooseInRow(mesh, row, isLoop, components, lengthInRow);
    for (std::size_t i = begin; i < end; ++i)
    {
      result[at(i)].departure = best[i - begin].departure;
      result[at(i + 1)].arrival = best[i + 1 - begin].arrival;
    }
  }
  if (!closed)
  {
    result.front().arrival = result.front().departure;
    result.back().departure = result.back().arrival;
  }
  return result;
}

}
