// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/reading/TriangleRoles.h"

#include "PolyData/Hash.h"
#include "Questions.h"

#include "vtkDataArray.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace geodesic
{

namespace
{

using Label = PieceVertices::Label;
using Range = TriangleList::Range;

std::vector<Id> verticesOf(
  const Range& cell, const VertexOfPoint& vertexOf, const TriangleList& triangles)
{
  std::set<Id> vertices;
  for (std::size_t i = cell.first; i < cell.second; ++i)
  {
    const Triangle corners = vertexOf(triangles.corners[i]);
    vertices.insert(corners.begin(), corners.end());
  }
  return { vertices.begin(), vertices.end() };
}

/// Cells on the same vertices have as many triangles, unless they touch themselves.
void copyCut(const Range& original, const Range& duplicate, const VertexOfPoint& vertexOf,
  TriangleList& triangles)
{
  const std::size_t count = original.second - original.first;
  if (duplicate.second - duplicate.first < count)
  {
    return;
  }
  std::map<Id, Id> ownPoints;
  for (std::size_t i = duplicate.first; i < duplicate.first + count; ++i)
  {
    for (const Id point : triangles.corners[i])
    {
      ownPoints.emplace(vertexOf(point), point);
    }
  }
  for (std::size_t i = 0; i < count; ++i)
  {
    Triangle triangle = triangles.corners[original.first + i];
    for (Id& corner : triangle)
    {
      const auto own = ownPoints.find(vertexOf(corner));
      if (own == ownPoints.end())
      {
        return;
      }
      corner = own->second;
    }
    triangles.corners[duplicate.first + i] = triangle;
  }
}

/// If a cell was cut into several triangles, its duplicates get the same cut.
void copyCuts(const VertexOfPoint& vertexOf, TriangleList& triangles)
{
  const auto forEachCut = [&triangles](bool isMarked, const auto& visit)
  {
    triangles.forEachCell(
      [&](const Range& cell)
      {
        if (cell.second > cell.first + 1 && triangles.isDuplicate[cell.first] == isMarked)
        {
          visit(cell);
        }
      });
  };
  std::map<std::vector<Id>, std::vector<Range>> duplicates;
  forEachCut(true,
    [&](const Range& cell) { duplicates[verticesOf(cell, vertexOf, triangles)].push_back(cell); });
  if (duplicates.empty())
  {
    return;
  }
  forEachCut(false,
    [&](const Range& cell)
    {
      const auto found = duplicates.find(verticesOf(cell, vertexOf, triangles));
      if (found != duplicates.end())
      {
        for (const Range& duplicate : found->second)
        {
          copyCut(cell, duplicate, vertexOf, triangles);
        }
      }
    });
}

/// \param labels of the cell's corners; sorted then, each once.
Fingerprint keyOf(std::vector<Label>& labels)
{
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  Fingerprint key{};
  addWord(labels.size(), key); // a label 0 at the beginning changes nothing by itself
  for (const Label label : labels)
  {
    addWord(label, key);
  }
  return key;
}

/// The label of a vertex that no other cell has.
constexpr Label NoLabel = ~Label(0);

/// Marks the copies among some cells of all ranks, which call this together: of cells on the same
/// vertices, marked ones beside an original, or beside the first of marked ones. Cells that are
/// copies already do not count.
///
/// \param forEachCell calls its argument for each cell: (const Range&).
/// \param labelOf of a point: (Id) -> Label.
template <typename ForEachCell, typename LabelOf>
void findCopiesAmong(const ForEachCell& forEachCell, const LabelOf& labelOf,
  const TriangleList& triangles, Exchange& exchange, std::vector<TriangleRole>& roles)
{
  Questions questions(exchange);
  const auto ranks = static_cast<std::uint64_t>(exchange.numberOfRanks());
  std::vector<Range> asked; // few: most cells have a vertex of their own
  std::vector<Label> labels;
  forEachCell(
    [&](const Range& cell)
    {
      if (roles[cell.first] == TriangleRole::Copy)
      {
        return;
      }
      labels.clear();
      for (std::size_t i = cell.first; i < cell.second; ++i)
      {
        for (const Id point : triangles.corners[i])
        {
          labels.push_back(labelOf(point));
          if (labels.back() == NoLabel)
          {
            return;
          }
        }
      }
      const Fingerprint key = keyOf(labels);
      const bool isMarked = triangles.isDuplicate[cell.first];
      questions.ask(static_cast<int>(key[1] % ranks), asked.size(), key, isMarked);
      asked.push_back(cell);
    });
  std::map<Fingerprint, bool> isTaken;
  questions.exchangeAnswers(
    [&](int, MessageReader& question)
    {
      bool& taken = isTaken[question.get<Fingerprint>()];
      taken = !question.get<bool>() || taken;
    },
    [&](MessageReader& question, Message& answer)
    {
      bool& taken = isTaken[question.get<Fingerprint>()];
      const bool isMarked = question.get<bool>();
      put(answer, isMarked && taken);
      taken = true;
    },
    [&](std::size_t cell, MessageReader& answer)
    {
      const bool isCopy = answer.get<bool>();
      for (std::size_t i = asked[cell].first; isCopy && i < asked[cell].second; ++i)
      {
        roles[i] = TriangleRole::Copy;
      }
    });
}

/// Marks the triangles that are copies of others of this rank.
void findCopiesHere(
  const VertexOfPoint& vertexOf, const TriangleList& triangles, std::vector<TriangleRole>& roles)
{
  std::set<Id> marked;
  for (std::size_t i = 0; i < triangles.corners.size(); ++i)
  {
    if (triangles.isDuplicate[i])
    {
      const Triangle vertices = vertexOf(triangles.corners[i]);
      marked.insert(vertices.begin(), vertices.end());
    }
  }
  const auto forEachTriangle = [&](const auto& visit)
  {
    for (std::size_t i = 0; i < triangles.corners.size() && !marked.empty(); ++i)
    {
      visit(Range(i, i + 1));
    }
  };
  const auto labelOf = [&](Id point)
  { return marked.count(vertexOf(point)) > 0 ? Label(vertexOf(point)) : NoLabel; };
  findCopiesAmong(forEachTriangle, labelOf, triangles, OneRank::instance(), roles);
}

/// Marks the triangles that are copies of others.
///
/// \returns the roles; empty if no rank has marked triangles.
std::vector<TriangleRole> findCopies(
  const PieceVertices& vertices, TriangleList& triangles, Exchange& exchange)
{
  const std::vector<bool>& marks = triangles.isDuplicate;
  if (!exchange.isTrueAnywhere(std::find(marks.begin(), marks.end(), true) != marks.end()))
  {
    return {};
  }
  std::vector<TriangleRole> roles(triangles.corners.size(), TriangleRole::Open);
  copyCuts(vertices.of, triangles);
  findCopiesHere(vertices.of, triangles, roles);
  // Among the others those that are copies of other ranks' cells.
  findCopiesAmong([&](const auto& visit) { triangles.forEachCell(visit); },
    [&](Id point)
    {
      const Id vertex = vertices.of(point);
      return vertices.isSharedAt(vertex) ? vertices.labelOf(vertex) : NoLabel;
    },
    triangles, exchange, roles);
  return roles;
}

/// Marks the open triangles of a block that are barriers. A triangle with two corners at one vertex
/// has no inside: it is left to the mesh, which leaves it out.
void findBarriers(vtkDataArray* barriers, std::size_t block, const VertexOfPoint& vertexOf,
  const TriangleList& triangles, std::vector<TriangleRole>& roles)
{
  roles.resize(triangles.corners.size(), TriangleRole::Open);
  for (std::size_t i = triangles.firstOfBlock[block]; i < triangles.firstOfBlock[block + 1]; ++i)
  {
    if (roles[i] == TriangleRole::Open && hasThreeVertices(vertexOf(triangles.corners[i])) &&
      barriers->GetComponent(triangles.cells[i], 0) != 0.0)
    {
      roles[i] = TriangleRole::Barrier;
    }
  }
}

} // anonymous namespace

std::vector<TriangleRole> findRoles(const std::vector<PolyDataBlock>& inputs,
  const PieceVertices& vertices, TriangleList& triangles, Exchange& exchange)
{
  std::vector<TriangleRole> roles = findCopies(vertices, triangles, exchange);
  const char* name = nullptr;
  for (std::size_t block = 0; block < inputs.size(); ++block)
  {
    if (vtkDataArray* barriers = inputs[block].barriers)
    {
      name = barriers->GetName();
      findBarriers(barriers, block, vertices.of, triangles, roles);
    }
  }
  const auto open =
    static_cast<std::size_t>(std::count(roles.begin(), roles.end(), TriangleRole::Open));
  const bool isAnyOpen = open > 0 || roles.size() < triangles.corners.size();
  if (!exchange.isTrueAnywhere(isAnyOpen) && name)
  {
    throw MeshError(
      std::string("All faces of the surface (input port 0) are barriers: the cell array ") + name +
      " (BarrierArrayName) is 0 at none of them. Set it to 0 where paths may pass, or choose no "
      "barrier array.");
  }
  if (open == roles.size())
  {
    return {};
  }
  return roles;
}

}
