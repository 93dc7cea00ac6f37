// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RefinedFaces.h"

#include "Questions.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace geodesic
{

namespace
{

/// Numbers the points of one face as RefinedFace does.
class FaceNumbers
{
public:
  FaceNumbers(const RefinedMesh& refined, const Triangle& corners, RefinedFace& face)
    : refined_(refined)
    , face_(face)
  {
    for (Id k = 0; k < 3; ++k)
    {
      this->numbers_[corners[k]] = k;
    }
  }

  Id of(Id point)
  {
    const auto known = this->numbers_.find(point);
    if (known != this->numbers_.end())
    {
      return known->second;
    }
    RefinedPoint copy = this->refined_.points[point - this->refined_.numberOfInputPoints];
    copy.parents = { this->of(copy.parents[0]), this->of(copy.parents[1]) };
    copy.place = {};
    this->face_.points.push_back(copy);
    this->face_.numbersThere.push_back(point - this->refined_.numberOfInputPoints);
    return this->numbers_[point] = 2 + static_cast<Id>(this->face_.points.size());
  }

private:
  const RefinedMesh& refined_;
  RefinedFace& face_;
  std::unordered_map<Id, Id> numbers_;
};

RefinedFace refinedFace(const RefinedMesh& refined, Id id, const Triangle& corners)
{
  RefinedFace face;
  FaceNumbers numbers(refined, corners, face);
  const auto [first, last] = std::equal_range(refined.faces.begin(), refined.faces.end(), id);
  for (auto part = first; part != last; ++part)
  {
    const Triangle& t = refined.triangles[static_cast<std::size_t>(part - refined.faces.begin())];
    const Id a = numbers.of(t[0]);
    const Id b = numbers.of(t[1]);
    face.triangles.push_back({ a, b, numbers.of(t[2]) });
  }
  return face;
}

} // anonymous namespace

std::vector<RefinedFace> findRefinedFaces(const std::vector<RankAddress>& faces,
  const MeshPartition& part, const RefinedMesh& refined, const std::vector<Triangle>& cornerPoints)
{
  Questions questions(part.exchange());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    questions.ask(faces[i].rank, i, faces[i].id);
  }
  std::vector<RefinedFace> result(faces.size());
  questions.exchangeAnswers(
    [&](MessageReader& question, Message& answer)
    {
      const Id id = question.get<Id>();
      const RefinedFace face = refinedFace(
        refined, id, cornerPoints.empty() ? part.mesh().triangle(id) : cornerPoints[id]);
      putAll(answer, face.points);
      putAll(answer, face.numbersThere);
      putAll(answer, face.triangles);
    },
    [&](std::size_t i, MessageReader& answer)
    {
      result[i].points = answer.getAll<RefinedPoint>();
      result[i].numbersThere = answer.getAll<Id>();
      result[i].triangles = answer.getAll<Triangle>();
    });
  return result;
}

}
