// SPDX-License-Identifier: BSD-3-Clause
#include "field/RemoteOrigins.h"

#include "Questions.h"

#include <algorithm>

namespace geodesic
{

namespace
{

// Each round doubles the length, so that no chain of vertices needs more rounds. Origins that are
// open after these rounds are vertices at one place that name each other.
constexpr int MaximumSteps = 33;

} // anonymous namespace

RemoteOrigins::RemoteOrigins(const DistanceField& field, std::vector<CurveOrigin>& atVertices)
  : field_(field)
{
  this->collect();
  for (const Id number : this->numbers_)
  {
    this->origins_.push_back({ number });
  }
  const auto isOpenHere = [this]()
  {
    return std::any_of(this->origins_.begin(), this->origins_.end(),
      [this](const CurveOrigin& origin) { return this->isOpen(origin); });
  };
  for (int steps = 0;
       steps < MaximumSteps && field.surface().exchange().isTrueAnywhere(isOpenHere()); ++steps)
  {
    this->ask(atVertices);
  }
  for (CurveOrigin& origin : this->origins_)
  {
    origin = this->isOpen(origin) ? CurveOrigin() : origin;
  }
  for (Id vertex = 0; vertex < atVertices.size(); ++vertex)
  {
    const Id number = field.surface().globalId(vertex);
    CurveOrigin& origin = atVertices[vertex];
    if (field.surface().countedVertex(number) == NoId)
    {
      origin = this->of(number);
    }
    else if (this->isOpen(origin))
    {
      origin = this->of(origin.origin);
    }
  }
}

// Collects the vertices, counted elsewhere, that paths to points of the part may come from.
void RemoteOrigins::collect()
{
  const MeshPartition& part = this->field_.surface();
  const auto add = [&](Id number)
  {
    if (number < part.numberOfGlobalVertices() && part.countedVertex(number) == NoId)
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

// Asks once about every origin that is still open here.
void RemoteOrigins::ask(std::vector<CurveOrigin>& atVertices)
{
  Questions questions(this->field_.surface().exchange());
  for (std::size_t i = 0; i < this->origins_.size(); ++i)
  {
    const Id vertex = this->origins_[i].origin;
    if (this->isOpen(this->origins_[i]))
    {
      questions.ask(this->field_.surface().rankCounting(vertex), i, vertex);
    }
  }
  questions.exchangeAnswers(
    [&](MessageReader& question, Message& answer)
    {
      const CurveOrigin& origin =
        atVertices[this->field_.surface().countedVertex(question.get<Id>())];
      put(answer, this->isOpen(origin) ? this->of(origin.origin) : origin);
    },
    [&](std::size_t i, MessageReader& answer) { this->origins_[i] = answer.get<CurveOrigin>(); });
}

CurveOrigin RemoteOrigins::of(Id vertex) const
{
  const auto found = std::lower_bound(this->numbers_.begin(), this->numbers_.end(), vertex);
  return found != this->numbers_.end() && *found == vertex
    ? this->origins_[static_cast<std::size_t>(found - this->numbers_.begin())]
    : CurveOrigin();
}

}
