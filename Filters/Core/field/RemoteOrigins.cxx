// SPDX-License-Identifier: BSD-3-Clause
#include "field/RemoteOrigins.h"

#include <algorithm>

namespace geodesic
{

namespace
{

// Steps that double the way: more than any chain of vertices takes. What is open then are vertices
// at one place that name each other.
constexpr int MaximumSteps = 33;

} // anonymous namespace

RemoteOrigins::RemoteOrigins(
  const DistanceField& field, const GlobalVertices& vertices, std::vector<CurveOrigin>& atVertices)
  : field_(field)
  , vertices_(vertices)
{
  this->collect();
  for (const Id number : this->numbers_)
  {
    this->origins_.push_back({ number });
  }
  for (int steps = 0; steps < MaximumSteps && this->ask(atVertices); ++steps)
  {
  }
  for (CurveOrigin& origin : this->origins_)
  {
    origin = this->isOpen(origin) ? CurveOrigin() : origin;
  }
  for (Id vertex = 0; vertex < atVertices.size(); ++vertex)
  {
    const Id number = field.surface().globalId(vertex);
    CurveOrigin& origin = atVertices[vertex];
    if (!vertices.isHere(number))
    {
      origin = this->of(number);
    }
    else if (this->isOpen(origin))
    {
      origin = this->of(origin.origin);
    }
  }
}

// What a path to a point of the part may come from.
void RemoteOrigins::collect()
{
  const MeshPartition& part = this->field_.surface();
  const auto add = [this](Id number)
  {
    if (number < this->field_.surface().numberOfGlobalVertices() && !this->vertices_.isHere(number))
    {
      this->numbers_.push_back(number);
    }
  };
  for (Id vertex = 0; vertex < part.mesh().numberOfVertices(); ++vertex)
  {
    add(part.globalId(vertex));
    add(this->field_.arrivals()[vertex].origin);
  }
  for (Id halfedge = 3 * part.firstOwnFace(); halfedge < 3 * part.endOfOwnFaces(); ++halfedge)
  {
    Id last = NoId; // windows of one origin often stand together
    for (const Window& window : this->field_.windowsOn(halfedge))
    {
      if (window.origin != last)
      {
        add(window.origin);
        last = window.origin;
      }
    }
  }
  std::sort(this->numbers_.begin(), this->numbers_.end());
  this->numbers_.erase(
    std::unique(this->numbers_.begin(), this->numbers_.end()), this->numbers_.end());
}

// Returns whether anything was open on any rank.
bool RemoteOrigins::ask(std::vector<CurveOrigin>& atVertices)
{
  Exchange& exchange = this->field_.surface().exchange();
  std::vector<Message> questions = exchange.noMessages();
  std::vector<std::vector<std::size_t>> asked(questions.size());
  for (std::size_t i = 0; i < this->origins_.size(); ++i)
  {
    if (this->isOpen(this->origins_[i]))
    {
      const auto rank = rankIndex(this->vertices_.rankOf(this->origins_[i].origin));
      put(questions[rank], this->origins_[i].origin);
      asked[rank].push_back(i);
    }
  }
  const bool isOpenHere = std::any_of(this->origins_.begin(), this->origins_.end(),
    [this](const CurveOrigin& origin) { return this->isOpen(origin); });
  std::vector<double> least = { isOpenHere ? 0.0 : 1.0 };
  const std::vector<Message> received = exchange.step(std::move(questions), least);
  if (least.front() > 0.0)
  {
    return false;
  }
  std::vector<Message> answers = exchange.noMessages();
  readEach(received,
    [&](int rank, MessageReader& reader)
    {
      const CurveOrigin& origin = atVertices[this->vertices_.vertexAt(reader.get<Id>())];
      put(answers[rankIndex(rank)], this->isOpen(origin) ? this->of(origin.origin) : origin);
    });
  std::vector<std::size_t> next(asked.size(), 0);
  readEach(exchange.step(std::move(answers)),
    [&](int rank, MessageReader& reader)
    {
      const auto from = rankIndex(rank);
      this->origins_[asked[from][next[from]++]] = reader.get<CurveOrigin>();
    });
  return true;
}

CurveOrigin RemoteOrigins::of(Id vertex) const
{
  const auto found = std::lower_bound(this->numbers_.begin(), this->numbers_.end(), vertex);
  return found != this->numbers_.end() && *found == vertex
    ? this->origins_[static_cast<std::size_t>(found - this->numbers_.begin())]
    : CurveOrigin();
}

}
