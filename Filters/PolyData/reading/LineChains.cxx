// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/LineChains.h"

#include "Chains.h"
#include "PolyData/Hash.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace geodesic
{

namespace
{

/// The numbers of the places of the lines' ends, two a line.
std::vector<Id> placesOfEnds(const std::vector<LocatedPolyline>& polylines,
  const std::vector<std::size_t>& lines, const std::vector<vtkIdType>& parts)
{
  // Where lines of a part meet: the coordinates, the number of the vertex and that of the part.
  using MeetingPlace = std::array<double, 5>;
  std::unordered_map<MeetingPlace, Id, Hash> numbers;
  std::vector<Id> places;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    const LocatedPolyline& line = polylines[lines[i]];
    const auto part = static_cast<double>(parts[i]);
    for (const std::size_t end : { 0U, 1U })
    {
      const Vec3 point = line.points[end] + Vec3{}; // -0 and 0 are one place
      const MeetingPlace place = { point[0], point[1], point[2],
        static_cast<double>(line.vertexOf(end)), part };
      places.push_back(numbers.try_emplace(place, static_cast<Id>(numbers.size())).first->second);
    }
  }
  return places;
}

/// Leaves out lines that repeat a lower one, and lines of one place where another line ends.
///
/// \param lines and their places; then those that are left.
void leaveOutRepeats(std::vector<std::size_t>& lines, std::vector<Id>& places)
{
  std::unordered_set<std::uint64_t, Hash> known;
  std::vector<std::uint8_t> isEnd(places.size(), 0); // of a line with a length
  std::vector<std::uint8_t> isNew(lines.size(), 0);
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    const auto [low, high] = std::minmax(places[2 * i], places[2 * i + 1]);
    isNew[i] = known.insert(std::uint64_t(low) << 32 | high).second ? 1 : 0;
    if (low != high)
    {
      isEnd[low] = isEnd[high] = 1;
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    const Id a = places[2 * i];
    const Id b = places[2 * i + 1];
    if (isNew[i] && !(a == b && isEnd[a]))
    {
      lines[kept] = lines[i];
      places[2 * kept] = a;
      places[2 * kept + 1] = b;
      ++kept;
    }
  }
  lines.resize(kept);
  places.resize(2 * kept);
}

/// \param lines the numbers of the lines in which the chain's segments are stored.
LocatedPolyline joined(const Chain& chain, const std::vector<std::size_t>& lines,
  const std::vector<LocatedPolyline>& polylines)
{
  LocatedPolyline curve;
  curve.closed = chain.isLoop;
  const auto add = [&](Id end)
  {
    const LocatedPolyline& line = polylines[lines[end / 2]];
    curve.points.push_back(line.points[end % 2]);
    curve.pointNames.push_back(line.nameOfPoint(end % 2));
    curve.vertices.push_back(line.vertexOf(end % 2));
  };
  std::for_each(chain.ends.begin(), chain.ends.end(), add);
  if (!chain.isLoop)
  {
    add(chain.ends.back() ^ 1U);
  }
  return curve;
}

/// Turns a chain to the direction of most of its lines.
void turnToMost(Chain& chain)
{
  const auto reversed = static_cast<std::size_t>(
    std::count_if(chain.ends.begin(), chain.ends.end(), [](Id end) { return end % 2 != 0; }));
  if (2 * reversed > chain.ends.size())
  {
    chain.reverse();
  }
}

} // anonymous namespace

void joinLines(std::vector<LocatedPolyline>& polylines, const std::vector<std::size_t>& lines,
  const std::vector<vtkIdType>& parts)
{
  std::vector<bool> isGone(polylines.size(), false);
  for (const std::size_t line : lines)
  {
    isGone[line] = true;
  }
  std::vector<Id> places = placesOfEnds(polylines, lines, parts);
  std::vector<std::size_t> kept = lines;
  leaveOutRepeats(kept, places);
  for (Chain& chain : followChains(places))
  {
    const std::size_t lowest = kept[*std::min_element(chain.ends.begin(), chain.ends.end()) / 2];
    isGone[lowest] = false;
    if (chain.ends.size() > 1)
    {
      turnToMost(chain);
      LocatedPolyline curve = joined(chain, kept, polylines);
      curve.name = polylines[lowest].name;
      curve.source = polylines[lowest].source;
      polylines[lowest] = std::move(curve);
    }
  }
  std::size_t left = 0;
  for (std::size_t i = 0; i < polylines.size(); ++i)
  {
    if (!isGone[i])
    {
      std::swap(polylines[left++], polylines[i]);
    }
  }
  polylines.resize(left);
}

}
