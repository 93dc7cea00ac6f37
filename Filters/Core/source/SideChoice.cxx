// SPDX-License-Identifier: BSD-3-Clause
#include "source/SideChoice.h"

#include "Tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace geodesic
{

namespace
{

/// How a way along a polyline compares with others: first by its changes from one side to the
/// other, then by how much farther its places are than the closest ones.
struct Cost
{
  Id changes = NoId;
  double excess = 0.0;

  bool operator<(const Cost& other) const
  {
    return this->changes != other.changes ? this->changes < other.changes
                                          : this->excess < other.excess;
  }
  Cost plus(bool isChange, double excessOfPlace) const
  {
    return this->changes == NoId
      ? *this
      : Cost{ this->changes + (isChange ? 1 : 0), this->excess + excessOfPlace };
  }
};

double distanceTo(const std::vector<ClosestFace>& faces)
{
  double least = Infinity;
  for (const ClosestFace& face : faces)
  {
    least = std::min(least, norm(face.toPlace));
  }
  return least;
}

/// How far a place on face b is off the side of the wall that face a is on, given the step between
/// their points: along the mean of their normals, which is at right angles to a chord of a bent
/// wall, too. The faces' orientations do not matter. 0 if the faces are not about parallel, as on
/// two sides of an edge.
double offTheSide(const ClosestFace& a, const Vec3& step, const ClosestFace& b)
{
  const double cosine = dot(a.normal, b.normal);
  if (std::abs(cosine) < tolerance::AboutParallel)
  {
    return 0.0;
  }
  const Vec3 mean = a.normal + (cosine < 0.0 ? -1.0 : 1.0) * b.normal;
  return std::abs(dot(step + b.toPlace - a.toPlace, mean)) / norm(mean);
}

/// Finds the best way along one polyline by dynamic programming. Each point has two sides: 0, that
/// of its closest faces, and 1, the opposite one.
class WayOnSides
{
public:
  using Sides = std::vector<std::uint8_t>;
  /// For each place a side that it must have.
  using Given = std::vector<std::optional<std::uint8_t>>;

  WayOnSides(const std::vector<Vec3>& places, const RowOfPlaces& row, const ClosestFaces& closest,
    const ClosestFaces& opposite)
    : places_(places)
    , row_(row)
    , faces_{ &closest, &opposite }
  {
  }

  /// The sides of the polyline's points.
  Sides best(const Given& given)
  {
    const bool isLoop = this->row_.closed && this->row_.places.size() > 1;
    this->least_ = {};
    for (std::uint8_t side = 0; side < (isLoop ? 2 : 1); ++side)
    {
      this->run(given, isLoop ? std::optional<std::uint8_t>(side) : std::nullopt);
    }
    return this->sides_;
  }

private:
  struct Layer
  {
    std::array<Cost, 2> cost;
    std::array<std::uint8_t, 2> from{};
  };

  const std::vector<ClosestFace>& facesOf(std::size_t i, std::uint8_t side) const
  {
    return (*this->faces_[side])[this->row_.places[i]];
  }
  /// The thickness of the wall in which a point has a choice; infinite if it has none.
  double thicknessAt(std::size_t i) const
  {
    return distanceTo(this->facesOf(i, 0)) + distanceTo(this->facesOf(i, 1));
  }

  /// Whether consecutive points with these sides are on two sides of the wall. It counts only where
  /// one of them has a choice.
  bool isChange(std::size_t i, std::uint8_t side, std::size_t next, std::uint8_t sideOfNext) const
  {
    const double thickness = std::min(this->thicknessAt(i), this->thicknessAt(next));
    const Vec3 step = this->placeOf(next) - this->placeOf(i);
    const std::vector<ClosestFace>& from = this->facesOf(i, side);
    const std::vector<ClosestFace>& to = this->facesOf(next, sideOfNext);
    return thickness < Infinity &&
      std::all_of(from.begin(), from.end(),
        [&](const ClosestFace& a)
        {
          return std::all_of(to.begin(), to.end(),
            [&](const ClosestFace& b)
            { return offTheSide(a, step, b) > tolerance::OtherSide * thickness; });
        });
  }
  const Vec3& placeOf(std::size_t i) const { return this->places_[this->row_.places[i]]; }
  bool isPossible(std::size_t i, std::uint8_t side, const Given& given) const
  {
    return !this->facesOf(i, side).empty() && given[this->row_.places[i]].value_or(side) == side;
  }
  double excess(std::size_t i, std::uint8_t side) const
  {
    return side == 0 ? 0.0 : distanceTo(this->facesOf(i, 1)) - distanceTo(this->facesOf(i, 0));
  }

  /// \param loopFrom the side of the first point, to which a closed polyline returns.
  void run(const Given& given, std::optional<std::uint8_t> loopFrom)
  {
    const std::size_t count = this->row_.places.size();
    std::vector<Layer> layers(count);
    for (std::uint8_t side = 0; side < 2; ++side)
    {
      if (loopFrom.value_or(side) == side && this->isPossible(0, side, given))
      {
        layers[0].cost[side] = { 0, this->excess(0, side) };
      }
    }
    for (std::size_t i = 1; i < count; ++i)
    {
      for (std::uint8_t side = 0; side < 2; ++side)
      {
        for (std::uint8_t from = 0; from < 2 && this->isPossible(i, side, given); ++from)
        {
          const Cost cost = layers[i - 1].cost[from].plus(
            this->isChange(i - 1, from, i, side), this->excess(i, side));
          if (cost < layers[i].cost[side])
          {
            layers[i].cost[side] = cost;
            layers[i].from[side] = from;
          }
        }
      }
    }
    for (std::uint8_t side = 0; side < 2; ++side)
    {
      const Cost cost = layers.back().cost[side].plus(
        loopFrom && this->isChange(count - 1, side, 0, *loopFrom), 0.0);
      if (cost < this->least_)
      {
        this->least_ = cost;
        this->trace(layers, side);
      }
    }
  }

  void trace(const std::vector<Layer>& layers, std::uint8_t last)
  {
    this->sides_.assign(layers.size(), last);
    for (std::size_t i = layers.size() - 1; i > 0; --i)
    {
      this->sides_[i - 1] = layers[i].from[this->sides_[i]];
    }
  }

  const std::vector<Vec3>& places_;
  const RowOfPlaces& row_;
  const std::array<const ClosestFaces*, 2> faces_;
  Cost least_;
  Sides sides_;
};

} // anonymous namespace

std::vector<std::uint8_t> chooseSides(const std::vector<Vec3>& places,
  const std::vector<RowOfPlaces>& rows, const ClosestFaces& closest, const ClosestFaces& opposite)
{
  std::vector<std::size_t> uses(closest.size(), 0);
  for (const RowOfPlaces& row : rows)
  {
    for (const std::size_t place : row.places)
    {
      ++uses[place];
    }
  }
  WayOnSides::Given given(closest.size());
  std::vector<std::uint8_t> isOpposite(closest.size(), 0);
  for (const RowOfPlaces& row : rows)
  {
    WayOnSides way(places, row, closest, opposite);
    WayOnSides::Sides sides = way.best(given);
    bool isGivenNow = false;
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      std::optional<std::uint8_t>& here = given[row.places[i]];
      if (uses[row.places[i]] > 1 && !here)
      {
        here = sides[i];
        isGivenNow = true;
      }
    }
    sides = isGivenNow ? way.best(given) : sides;
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      isOpposite[row.places[i]] = sides[i];
    }
  }
  return isOpposite;
}

}
