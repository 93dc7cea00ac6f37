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

/// \param corners the caller's points at the face's corners.
/// \param rank this one.
RefinedMesh refinedFace(const RefinedMesh& refined, Id id, const Triangle& corners, int rank)
{
  RefinedMesh face;
  face.numberOfInputPoints = 3;
  std::unordered_map<Id, Id> numbers = { { corners[0], 0 }, { corners[1], 1 }, { corners[2], 2 } };
  const auto add = [&](RefinedPoint point, Id number)
  {
    point.place = {};
    face.points.push_back(point);
    face.copied.push_back({ rank, number - refined.numberOfInputPoints });
    return 2 + static_cast<Id>(face.points.size());
  };
  const auto [first, last] = std::equal_range(refined.faces.begin(), refined.faces.end(), id);
  for (auto part = first; part != last; ++part)
  {
    Triangle t = refined.triangles[static_cast<std::size_t>(part - refined.faces.begin())];
    for (Id& corner : t)
    {
      corner = numberElsewhere(
        corner, numbers, [&](Id number) { return refined.pointAt(number); }, add);
    }
    face.triangles.push_back(t);
  }
  return face;
}

} // anonymous namespace

std::vector<RefinedMesh> findRefinedFaces(const std::vector<RankAddress>& faces,
  const MeshPartition& part, const RefinedMesh& refined, const std::vector<Triangle>& cornerPoints)
{
  Questions questions(part.exchange());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (faces[i].id != NoId)
    {
      questions.ask(faces[i].rank, i, faces[i].id);
    }
  }
  std::vector<RefinedMesh> result(faces.size());
  questions.exchangeAnswers(
    [&](MessageReader& question, Message& answer)
    {
      const Id id = question.get<Id>();
      const RefinedMesh face = refinedFace(refined, id,
        cornerPoints.empty() ? part.mesh().triangle(id) : cornerPoints[id], part.exchange().rank());
      putAll(answer, face.points);
      putAll(answer, face.copied);
      putAll(answer, face.triangles);
    },
    [&](std::size_t i, MessageReader& answer)
    {
      result[i].numberOfInputPoints = 3;
      result[i].points = answer.getAll<RefinedPoint>();
      result[i].copied = answer.getAll<RankAddress>();
      result[i].triangles = answer.getAll<Triangle>();
    });
  return result;
}

namespace
{

/// A place on an edge, equal on all ranks that have one of its faces: the face with the edge's
/// lowest halfedge, the halfedge's number there, and the fraction along it, which refinement
/// computes from the same splits everywhere.
struct PlaceOnSeam
{
  RankAddress face;
  Id halfedge;
  double fraction;

  bool operator<(const PlaceOnSeam& other) const
  {
    return std::tie(this->face, this->halfedge, this->fraction) <
      std::tie(other.face, other.halfedge, other.fraction);
  }
};

/// \param place on an edge, or at a vertex, which all ranks know by its global id.
PlaceOnSeam onSeam(const MeshPartition& part, const SurfacePoint& place)
{
  if (place.kind == SurfacePoint::Kind::Vertex)
  {
    return { { -1, static_cast<Id>(part.globalId(place.id)) }, 0, 0.0 };
  }
  return { part.addressOf(TriangleMesh::faceOf(place.id)), TriangleMesh::indexInFace(place.id),
    place.u };
}

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
    if (!points[i].hasPlace())
    {
      continue;
    }
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
        else if (const int rank = part.addressOf(face).rank;
                 otherRanks.empty() || otherRanks.back() != rank)
        {
          otherRanks.push_back(rank); // faces of one rank are consecutive
        }
      });
    if (otherRanks.empty())
    {
      continue;
    }
    const PlaceOnSeam onEdge = onSeam(part, place);
    PointsAtPlace& at = places[onEdge];
    at.here.push_back(i);
    if (isKnown && at.there.id == NoId)
    {
      at.there = { part.exchange().rank(), i };
      for (const int rank : otherRanks)
      {
        put(messages[rankIndex(rank)], onEdge);
        put(messages[rankIndex(rank)], i);
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
      const auto found = places.find(reader.get<PlaceOnSeam>());
      const Id point = reader.get<Id>();
      if (found != places.end() && rank < found->second.there.rank)
      {
        found->second.there = { rank, point };
      }
    });
  SeamPoints result;
  for (const auto& [place, at] : places)
  {
    if (at.there.id != NoId && at.there.rank != exchange.rank())
    {
      result.here.insert(result.here.end(), at.here.begin(), at.here.end());
      result.there.resize(result.here.size(), at.there);
    }
  }
  return result;
}

}
