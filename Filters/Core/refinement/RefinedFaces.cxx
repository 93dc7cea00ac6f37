// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RefinedFaces.h"

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

template <typename Value>
void putAll(Message& message, const std::vector<Value>& values)
{
  put(message, values.size());
  put(message, values.data(), values.size());
}

template <typename Value>
void getAll(MessageReader& reader, std::vector<Value>& values)
{
  values.resize(reader.get<std::size_t>());
  reader.get(values.data(), values.size());
}

} // anonymous namespace

std::vector<RefinedFace> findRefinedFaces(const std::vector<RankAddress>& faces,
  const MeshPartition& part, const RefinedMesh& refined, const std::vector<Triangle>& cornerPoints)
{
  Exchange& exchange = part.exchange();
  std::vector<Message> questions = exchange.noMessages();
  std::vector<std::vector<std::size_t>> asked(questions.size());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const auto owner = rankIndex(faces[i].rank);
    put(questions[owner], faces[i].id);
    asked[owner].push_back(i);
  }
  std::vector<Message> answers = exchange.noMessages();
  readEach(exchange.step(std::move(questions)),
    [&](int rank, MessageReader& reader)
    {
      const Id id = reader.get<Id>();
      const RefinedFace face = refinedFace(
        refined, id, cornerPoints.empty() ? part.mesh().triangle(id) : cornerPoints[id]);
      Message& answer = answers[rankIndex(rank)];
      putAll(answer, face.points);
      putAll(answer, face.numbersThere);
      putAll(answer, face.triangles);
    });
  std::vector<RefinedFace> result(faces.size());
  std::vector<std::size_t> next(asked.size(), 0);
  readEach(exchange.step(std::move(answers)),
    [&](int rank, MessageReader& reader)
    {
      const auto owner = rankIndex(rank);
      RefinedFace& face = result[asked[owner][next[owner]++]];
      getAll(reader, face.points);
      getAll(reader, face.numbersThere);
      getAll(reader, face.triangles);
    });
  return result;
}

}
