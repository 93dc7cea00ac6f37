// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/RefinedOnRanks.h"

#include "Questions.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>
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

namespace
{

/// A place on an edge, equal on all ranks that have one of its faces: the face with the edge's
/// lowest halfedge, the halfedge's number there, and the fraction along it, which refinement
/// computes from the same splits everywhere.
using PlaceOnSeam = std::tuple<RankAddress, Id, double>;

/// What a rank that knows a face at a place sends to the others there.
struct PointMessage
{
  RankAddress face;
  Id halfedge;
  Id point;
  double fraction;

  PlaceOnSeam place() const { return { this->face, this->halfedge, this->fraction }; }
};

/// This rank's points at one place; there are several if a vertex has several of the caller's
/// points.
struct PointsAtPlace
{
  std::vector<Id> here;
  /// The lowest rank that provides values, if any, and its point.
  RankAddress there{ std::numeric_limits<int>::max(), NoId };
};

/// This rank's points on edges of several ranks' faces. Adds its values to the messages for the
/// others.
std::map<PlaceOnSeam, PointsAtPlace> collect(const std::vector<RefinedPoint>& points,
  std::size_t count, const DistanceField& field, const DistanceField& exact,
  std::vector<Message>& messages)
{
  const MeshPartition& part = field.surface();
  std::map<PlaceOnSeam, PointsAtPlace> places;
  for (Id i = 0; i < count; ++i)
  {
    const SurfacePoint& place = points[i].place;
    bool isKnown = false;
    std::vector<int> otherRanks; // in their order, each once
    forEachFace(part.mesh(), place,
      [&](Id face)
      {
        if (part.isOwn(face))
        {
          isKnown = isKnown || (field.knowsInside(face) && exact.knowsInside(face));
        }
        else if (const int rank = part.ownerOf(face).rank;
                 otherRanks.empty() || otherRanks.back() != rank)
        {
          otherRanks.push_back(rank); // faces of one rank are consecutive
        }
      });
    if (otherRanks.empty())
    {
      continue;
    }
    const RankAddress face = part.addressOf(TriangleMesh::faceOf(place.id));
    const PointMessage sent = { face, place.id % 3, i, place.u };
    PointsAtPlace& at = places[sent.place()];
    at.here.push_back(i);
    if (isKnown && at.there.id == NoId)
    {
      at.there = { part.exchange().rank(), i };
      for (const int rank : otherRanks)
      {
        put(messages[rankIndex(rank)], sent);
      }
    }
  }
  return places;
}

} // anonymous namespace

SeamPoints findSeamPoints(const std::vector<RefinedPoint>& points, std::size_t count,
  const DistanceField& field, const DistanceField& exact)
{
  Exchange& exchange = field.surface().exchange();
  std::vector<Message> messages = exchange.noMessages();
  std::map<PlaceOnSeam, PointsAtPlace> places = collect(points, count, field, exact, messages);
  readEach(exchange.step(std::move(messages)),
    [&](int rank, MessageReader& reader)
    {
      const auto sent = reader.get<PointMessage>();
      const auto found = places.find(sent.place());
      if (found != places.end() && rank < found->second.there.rank)
      {
        found->second.there = { rank, sent.point };
      }
    });
  SeamPoints result;
  for (const auto& [place, at] : places)
  {
    const bool isElsewhere = at.there.id != NoId && at.there.rank != exchange.rank();
    for (std::size_t i = 0; i < at.here.size() && isElsewhere; ++i)
    {
      result.here.push_back(at.here[i]);
      result.there.push_back(at.there);
    }
  }
  return result;
}

}
