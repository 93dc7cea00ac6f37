// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/RemoteDuplicates.h"

#include "PolyData/reading/CellTriangles.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace geodesic
{

namespace
{

/// The vertices of a cell, as two numbers that no other cell has.
using CellKey = std::array<std::uint64_t, 2>;

/// A cell, as other ranks are asked about it.
struct ToldCell
{
  CellKey key;
  std::uint64_t isMarked;
};

/// One cell's triangles.
struct CellOnRank
{
  std::size_t first;
  std::size_t last;
  CellKey key;
  bool isMarked;
};

class CellsOnRank
{
public:
  CellsOnRank(const RankLabels& labels, const std::vector<Id>& vertexOfPoint,
    const std::vector<SurfaceBlock>& blocks, const TriangleList& triangles)
    : labels_(labels)
    , vertexOfPoint_(vertexOfPoint)
    , blocks_(blocks)
    , triangles_(triangles)
  {
  }

  /// Those that are marked and no copies yet, and those that may be their originals.
  std::vector<CellOnRank> find(const std::vector<std::uint8_t>& isCopy) const
  {
    std::vector<CellOnRank> cells;
    forEachCell(this->blocks_, this->triangles_,
      [&](std::size_t first, std::size_t last)
      {
        if (!isCopy[first])
        {
          this->add(first, last, cells);
        }
      });
    return cells;
  }

private:
  void add(std::size_t first, std::size_t last, std::vector<CellOnRank>& cells) const
  {
    std::vector<RankLabels::Label> labels;
    for (std::size_t i = first; i < last; ++i)
    {
      for (const Id point : this->triangles_.corners[i])
      {
        const Id vertex = this->vertexOfPoint_.empty() ? point : this->vertexOfPoint_[point];
        if (!this->labels_.isShared[vertex])
        {
          return; // no other rank has such a cell
        }
        labels.push_back(this->labels_.labels[vertex]);
      }
    }
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
    const std::uint64_t hash = hashOf(labels.data(), labels.size());
    labels.push_back(~hash);
    cells.push_back({ first, last, { hash, hashOf(labels.data(), labels.size()) },
      this->triangles_.isDuplicate[first] });
  }

  const RankLabels& labels_;
  const std::vector<Id>& vertexOfPoint_;
  const std::vector<SurfaceBlock>& blocks_;
  const TriangleList& triangles_;
};

/// For each cell that was told, whether it is a copy.
std::vector<Message> judge(const std::vector<Message>& told)
{
  std::map<CellKey, bool> isTaken;
  readEach(told,
    [&](int, MessageReader& reader)
    {
      const auto cell = reader.get<ToldCell>();
      bool& taken = isTaken[cell.key];
      taken = taken || cell.isMarked == 0;
    });
  std::vector<Message> answers(told.size());
  readEach(told,
    [&](int rank, MessageReader& reader)
    {
      const auto cell = reader.get<ToldCell>();
      bool& taken = isTaken[cell.key];
      const std::uint8_t isCopy = cell.isMarked != 0 && taken ? 1 : 0;
      taken = true;
      put(answers[rankIndex(rank)], isCopy);
    });
  return answers;
}

} // anonymous namespace

void findCopiesOfOthers(const RankLabels& labels, const std::vector<Id>& vertexOfPoint,
  const std::vector<SurfaceBlock>& blocks, const TriangleList& triangles,
  std::vector<std::uint8_t>& isCopy, Exchange& exchange)
{
  const auto& marks = triangles.isDuplicate;
  if (!exchange.isTrueAnywhere(std::find(marks.begin(), marks.end(), true) != marks.end()))
  {
    return;
  }
  const std::vector<CellOnRank> cells =
    CellsOnRank(labels, vertexOfPoint, blocks, triangles).find(isCopy);
  std::vector<Message> messages = exchange.noMessages();
  std::vector<std::vector<std::size_t>> asked(messages.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const std::size_t rank = cells[i].key[1] % messages.size();
    put(messages[rank], ToldCell{ cells[i].key, cells[i].isMarked ? std::uint64_t(1) : 0 });
    asked[rank].push_back(i);
  }
  const std::vector<Message> told = exchange.step(std::move(messages));
  std::vector<std::size_t> next(asked.size(), 0);
  readEach(exchange.step(judge(told)),
    [&](int rank, MessageReader& reader)
    {
      const auto from = rankIndex(rank);
      const CellOnRank& cell = cells[asked[from][next[from]++]];
      if (reader.get<std::uint8_t>() != 0)
      {
        std::fill(isCopy.begin() + static_cast<std::ptrdiff_t>(cell.first),
          isCopy.begin() + static_cast<std::ptrdiff_t>(cell.last), std::uint8_t(1));
      }
    });
}

}
