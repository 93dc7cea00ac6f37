// SPDX-License-Identifier: BSD-3-Clause
#include "Chains.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>

namespace geodesic
{

namespace
{

/// For each end, the end of another segment that continues it, or NoId.
std::vector<Id> findPartners(const std::vector<Id>& places)
{
  Id numberOfPlaces = 0;
  for (const Id place : places)
  {
    numberOfPlaces = place == NoId ? numberOfPlaces : std::max(numberOfPlaces, place + 1);
  }
  struct Meeting
  {
    Id count = 0;
    std::array<Id, 2> ends = { NoId, NoId };
  };
  std::vector<Meeting> meetings(numberOfPlaces);
  for (Id end = 0; end < places.size(); ++end)
  {
    if (places[end] != NoId)
    {
      Meeting& meeting = meetings[places[end]];
      meeting.ends[meeting.count == 0 ? 0 : 1] = end;
      ++meeting.count;
    }
  }
  std::vector<Id> partners(places.size(), NoId);
  for (const Meeting& meeting : meetings)
  {
    if (meeting.count == 2)
    {
      partners[meeting.ends[0]] = meeting.ends[1];
      partners[meeting.ends[1]] = meeting.ends[0];
    }
  }
  return partners;
}

} // anonymous namespace

void Chain::reverse()
{
  std::reverse(this->ends.begin() + (this->isLoop ? 1 : 0), this->ends.end());
  for (Id& end : this->ends)
  {
    end ^= 1U;
  }
}

std::vector<Chain> followChains(const std::vector<Id>& places)
{
  const std::vector<Id> partners = findPartners(places);
  std::vector<std::uint8_t> isUsed(places.size() / 2, 0);
  std::vector<Chain> chains;
  for (Id lowest = 0; lowest < isUsed.size(); ++lowest)
  {
    if (isUsed[lowest])
    {
      continue;
    }
    Id first = 2 * lowest;
    Id before = partners[first];
    while (before != NoId && before / 2 != lowest)
    {
      first = before ^ 1U;
      before = partners[first];
    }
    Chain& chain = chains.emplace_back();
    chain.isLoop = before != NoId;
    for (Id end = chain.isLoop ? 2 * lowest : first; end != NoId && !isUsed[end / 2];
         end = partners[end ^ 1U])
    {
      isUsed[end / 2] = 1;
      chain.ends.push_back(end);
    }
  }
  return chains;
}

void beginAtLowestEnds(std::vector<Chain>& chains)
{
  for (Chain& chain : chains)
  {
    if (!chain.isLoop && (chain.ends.back() ^ 1U) < chain.ends.front())
    {
      chain.reverse();
    }
  }
  std::sort(chains.begin(), chains.end(),
    [](const Chain& a, const Chain& b)
    { return std::tie(a.isLoop, a.ends.front()) < std::tie(b.isLoop, b.ends.front()); });
}

}
