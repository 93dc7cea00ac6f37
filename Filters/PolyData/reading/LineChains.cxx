// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/LineChains.h"

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

constexpr std::size_t NoLine = static_cast<std::size_t>(-1);

/// Where lines of a part meet: the coordinates, the number of the vertex and that of the part.
using MeetingPlace = std::array<double, 5>;

MeetingPlace meetingPlace(const LocatedPolyline& line, std::size_t end, vtkIdType part)
{
  const Vec3 point = line.points[end] + Vec3{}; // -0 and 0 are one place
  return { point[0], point[1], point[2], static_cast<double>(line.vertexOf(end)),
    static_cast<double>(part) };
}

/// The numbers of the places of a line's ends.
using Ends = std::array<std::uint64_t, 2>;

/// A line as a part of a chain, which may run against the line's direction.
struct Step
{
  std::size_t line = NoLine;
  bool isReversed = false;

  Step reversed() const { return { this->line, !this->isReversed }; }
};

struct Chain
{
  std::vector<Step> steps;
  /// Whether the last line meets the first one and no other. A chain that returns to a place where
  /// more lines meet is none: on the surface its ends may be on two sheets that touch there. They
  /// are joined if they are at one point of the surface.
  bool isLoop = false;
};

/// The lines that meet at a place: how many, and the first two.
struct Meeting
{
  std::size_t count = 0;
  std::array<std::size_t, 2> lines = { NoLine, NoLine };

  void add(std::size_t line)
  {
    if (this->count < 2)
    {
      this->lines[this->count] = line;
    }
    ++this->count;
  }
};

/// Finds the chains of some lines, which are numbered from 0 on.
class ChainFinder
{
public:
  /// \param placeOf (std::size_t line, std::size_t end) -> MeetingPlace
  template <typename PlaceOf>
  ChainFinder(std::size_t count, const PlaceOf& placeOf)
    : ends_(count)
    , isDone_(count, 0)
  {
    std::unordered_map<MeetingPlace, std::uint64_t, Hash> numbers;
    for (std::size_t line = 0; line < count; ++line)
    {
      for (std::size_t end = 0; end < 2; ++end)
      {
        this->ends_[line][end] = numbers.emplace(placeOf(line, end), numbers.size()).first->second;
      }
    }
    this->meetings_.resize(numbers.size());
    this->leaveOutRepeats();
  }

  /// In the order of their lowest lines.
  std::vector<Chain> find()
  {
    std::vector<Chain> chains;
    for (std::size_t line = 0; line < this->ends_.size(); ++line)
    {
      if (!this->isDone_[line])
      {
        chains.push_back(this->chainOf(line));
      }
    }
    return chains;
  }

private:
  bool isPoint(std::size_t line) const { return this->ends_[line][0] == this->ends_[line][1]; }

  /// What is left out is done. Of the others those with a length meet.
  void leaveOutRepeats()
  {
    std::unordered_set<Ends, Hash> known;
    for (std::size_t line = 0; line < this->ends_.size(); ++line)
    {
      const auto& [a, b] = this->ends_[line];
      this->isDone_[line] = known.insert({ std::min(a, b), std::max(a, b) }).second ? 0 : 1;
      if (!this->isDone_[line] && !this->isPoint(line))
      {
        this->meetings_[a].add(line);
        this->meetings_[b].add(line);
      }
    }
    for (std::size_t line = 0; line < this->ends_.size(); ++line)
    {
      if (this->isPoint(line) && this->meetings_[this->ends_[line][0]].count > 0)
      {
        this->isDone_[line] = 1;
      }
    }
  }

  Step next(const Step& step) const
  {
    const std::uint64_t place = this->ends_[step.line][step.isReversed ? 0 : 1];
    const Meeting& meeting = this->meetings_[place];
    if (meeting.count != 2)
    {
      return {};
    }
    const std::size_t other = meeting.lines[meeting.lines[0] == step.line ? 1 : 0];
    return { other, this->ends_[other][0] != place };
  }

  /// \param lowest line of the chain.
  Chain chainOf(std::size_t lowest)
  {
    Step first{ lowest, false };
    Step before = this->next(first.reversed());
    while (before.line != NoLine && before.line != lowest)
    {
      first = before.reversed();
      before = this->next(before);
    }
    Chain chain;
    chain.isLoop = before.line == lowest;
    std::size_t reversed = 0;
    for (Step step = chain.isLoop ? Step{ lowest, false } : first;
         step.line != NoLine && !this->isDone_[step.line]; step = this->next(step))
    {
      this->isDone_[step.line] = 1;
      reversed += step.isReversed ? 1 : 0;
      chain.steps.push_back(step);
    }
    if (2 * reversed > chain.steps.size())
    {
      turn(chain);
    }
    return chain;
  }

  /// A loop begins with the same line then.
  static void turn(Chain& chain)
  {
    std::reverse(chain.steps.begin() + (chain.isLoop ? 1 : 0), chain.steps.end());
    for (Step& step : chain.steps)
    {
      step = step.reversed();
    }
  }

  std::vector<Ends> ends_;
  std::vector<Meeting> meetings_;
  /// Whether each line is in a chain, or left out.
  std::vector<std::uint8_t> isDone_;
};

/// \param lines of the chain, in order along it.
LocatedPolyline joined(const Chain& chain, const std::vector<const LocatedPolyline*>& lines)
{
  LocatedPolyline curve;
  curve.closed = chain.isLoop;
  const auto add = [&curve](const LocatedPolyline& line, bool isLast)
  {
    curve.points.push_back(line.points[isLast ? 1 : 0]);
    curve.pointNames.push_back(line.nameOfPoint(isLast ? 1 : 0));
    curve.vertices.push_back(line.vertexOf(isLast ? 1 : 0));
  };
  for (std::size_t i = 0; i < lines.size(); ++i)
  {
    add(*lines[i], chain.steps[i].isReversed);
  }
  if (!chain.isLoop)
  {
    add(*lines.back(), !chain.steps.back().isReversed);
  }
  return curve;
}

} // anonymous namespace

std::vector<Id> joinLines(std::vector<LocatedPolyline>& polylines,
  const std::vector<std::size_t>& lines, const std::vector<vtkIdType>& parts)
{
  ChainFinder finder(lines.size(),
    [&](std::size_t line, std::size_t end)
    { return meetingPlace(polylines[lines[line]], end, parts.empty() ? 0 : parts[line]); });
  std::vector<bool> isGone(polylines.size(), false);
  for (const std::size_t line : lines)
  {
    isGone[line] = true;
  }
  for (const Chain& chain : finder.find())
  {
    std::vector<const LocatedPolyline*> inChain;
    std::size_t lowest = NoLine;
    for (const Step& step : chain.steps)
    {
      inChain.push_back(&polylines[lines[step.line]]);
      lowest = std::min(lowest, lines[step.line]);
    }
    isGone[lowest] = false;
    if (inChain.size() > 1)
    {
      LocatedPolyline curve = joined(chain, inChain);
      curve.name = polylines[lowest].name;
      curve.source = polylines[lowest].source;
      polylines[lowest] = std::move(curve);
    }
  }
  std::vector<Id> gone;
  std::vector<LocatedPolyline> left;
  for (std::size_t i = 0; i < polylines.size(); ++i)
  {
    if (isGone[i])
    {
      gone.push_back(polylines[i].source);
    }
    else
    {
      left.push_back(std::move(polylines[i]));
    }
  }
  polylines = std::move(left);
  std::sort(gone.begin(), gone.end());
  return gone;
}

}
