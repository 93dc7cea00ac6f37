// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/RefinedPiece.h"

#include "PolyData/writing/GlobalFaces.h"
#include "PolyData/writing/SplitTriangle.h"
#include "refinement/RefinedFaces.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <utility>

namespace geodesic
{

namespace
{

/// Calls visit(triangle, face) for each triangle of a piece that is open, with its face or the copy
/// of the face that stands for it.
template <typename Visit>
void forEachOpen(const PolyDataSurface& surface, Visit&& visit)
{
  Id next = 0;
  for (Id i = 0; i < surface.numberOfTriangles(); ++i)
  {
    if (surface.role(i) == TriangleRole::Open)
    {
      visit(i, surface.partition().faceOfTriangle(next++));
    }
  }
}

/// For each face of the part's mesh the triangle that it is made of; NoId for other ranks'. Of
/// triangles on the same vertices it is the first.
std::vector<Id> trianglesOfFaces(const PolyDataSurface& surface)
{
  std::vector<Id> triangles(surface.mesh().numberOfFaces(), NoId);
  forEachOpen(surface,
    [&](Id triangle, Id face)
    {
      if (face != NoId && surface.partition().isOwn(face) && triangles[face] == NoId)
      {
        triangles[face] = triangle;
      }
    });
  return triangles;
}

/// For each triangle the face that is made of it; NoId where none here is.
std::vector<Id> facesOfTriangles(const PolyDataSurface& surface)
{
  std::vector<Id> faces(surface.numberOfTriangles(), NoId);
  const std::vector<Id> triangles = trianglesOfFaces(surface);
  for (Id face = 0; face < triangles.size(); ++face)
  {
    if (triangles[face] != NoId)
    {
      faces[triangles[face]] = face;
    }
  }
  return faces;
}

/// How a face of the whole is refined.
struct RefinedTemplate
{
  FaceOfWhole face;
  RefinedFace parts;
};

/// A triangle of a piece that is no face that the piece owns, and what it has to look like.
struct UnmeshedTriangle
{
  Id triangle = NoId;
  /// By PieceVertices::numbers, and where they lie.
  Triangle vertices{};
  std::array<Vec3, 3> positions{};
  RefinedTemplate like;
  /// Of a barrier, on whose vertices no face is, the faces at its edges, and which of their points
  /// split the edge, from corner k on.
  std::vector<RefinedTemplate> atEdges;
  std::array<std::vector<Id>, 3> splits;

  bool isBarrier() const { return !this->atEdges.empty(); }
  std::size_t numberOfParts() const
  {
    return this->isBarrier()
      ? 1 + this->splits[0].size() + this->splits[1].size() + this->splits[2].size()
      : this->like.parts.triangles.size();
  }
};

/// The points that split an edge of a face, from one end to the other, by their numbers in the
/// face.
std::vector<Id> splitsBetween(const RefinedFace& parts, Id from, Id to)
{
  std::map<std::pair<Id, Id>, Id> middles;
  for (std::size_t i = 0; i < parts.points.size(); ++i)
  {
    const std::array<Id, 2>& ends = parts.points[i].parents;
    middles[std::minmax(ends[0], ends[1])] = static_cast<Id>(3 + i);
  }
  std::vector<Id> splits;
  const std::function<void(Id, Id)> add = [&](Id a, Id b)
  {
    const auto middle = middles.find(std::minmax(a, b));
    if (middle != middles.end())
    {
      add(a, middle->second);
      splits.push_back(middle->second);
      add(middle->second, b);
    }
  };
  add(from, to);
  return splits;
}

/// Gives triangles the parts of faces on their vertices, or cuts them as faces at their edges are.
class TemplateCopier
{
public:
  explicit TemplateCopier(RefinedMesh& refined)
    : refined_(refined)
    , numbering_(refined)
    , ownPoints_(refined.points.size())
  {
  }

  /// \param points the input's points at the triangle's corners.
  void add(const UnmeshedTriangle& other, const Triangle& points, std::vector<Triangle>& triangles)
  {
    const Triangle& vertices = other.vertices;
    const FaceOfWhole& face = other.like.face;
    const std::vector<Id> numbers = this->pointsLike(other.like, vertices, points);
    const auto first = std::find(vertices.begin(), vertices.end(), face.vertices[0]);
    const std::size_t next = (static_cast<std::size_t>(first - vertices.begin()) + 1) % 3;
    const bool isTurned = vertices[next] != face.vertices[1];
    for (const Triangle& t : other.like.parts.triangles)
    {
      Triangle part = { numbers[t[0]], numbers[t[1]], numbers[t[2]] };
      if (isTurned)
      {
        std::swap(part[1], part[2]);
      }
      triangles.push_back(part);
    }
  }

  /// The same for a barrier.
  void addBarrier(
    const UnmeshedTriangle& other, const Triangle& points, std::vector<Triangle>& triangles)
  {
    SplitTriangle cut{ points, {},
      [&](Id point)
      {
        const auto corner = std::find(points.begin(), points.end(), point) - points.begin();
        return corner < 3
          ? other.positions[static_cast<std::size_t>(corner)]
          : this->refined_.points[point - this->refined_.numberOfInputPoints].position;
      } };
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (!other.splits[k].empty())
      {
        const std::vector<Id> numbers = this->pointsLike(other.atEdges[k], other.vertices, points);
        for (const Id point : other.splits[k])
        {
          cut.splits[k].push_back(numbers[point]);
        }
      }
    }
    cut.cut(triangles);
  }

  std::vector<RankAddress> takeAdded() { return std::move(this->added_); }

private:
  /// For each point of a face a triangle's own point in its place. NoId for those that are not
  /// between corners that the triangle has, too.
  std::vector<Id> pointsLike(
    const RefinedTemplate& like, const Triangle& vertices, const Triangle& points)
  {
    std::vector<Id> numbers;
    for (const Id vertex : like.face.vertices)
    {
      const auto k = std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin();
      numbers.push_back(k < 3 ? points[static_cast<std::size_t>(k)] : NoId);
    }
    for (std::size_t i = 0; i < like.parts.points.size(); ++i)
    {
      RefinedPoint point = like.parts.points[i];
      point.parents = { numbers[point.parents[0]], numbers[point.parents[1]] };
      if (point.parents[0] == NoId || point.parents[1] == NoId)
      {
        numbers.push_back(NoId);
        continue;
      }
      numbers.push_back(this->numbering_.numberOf(point));
      if (this->ownPoints_ + this->added_.size() < this->refined_.points.size())
      {
        this->added_.push_back({ like.face.address.rank, like.parts.numbersThere[i] });
      }
    }
    return numbers;
  }

  RefinedMesh& refined_;
  SplitPointNumbering numbering_;
  std::size_t ownPoints_;
  std::vector<RankAddress> added_;
};

/// Where the parts of each face begin among the refined triangles.
std::vector<std::size_t> firstParts(const std::vector<Id>& faces, Id numberOfFaces)
{
  std::vector<std::size_t> first(static_cast<std::size_t>(numberOfFaces) + 1, 0);
  for (const Id face : faces)
  {
    ++first[face + std::size_t(1)];
  }
  for (Id face = 0; face < numberOfFaces; ++face)
  {
    first[face + std::size_t(1)] += first[face];
  }
  return first;
}

/// Finds the faces on the vertices of triangles, and where there are none those at their edges.
///
/// \returns the faces that were found.
std::vector<RefinedTemplate*> findFaces(
  const PolyDataSurface& surface, std::vector<UnmeshedTriangle>& others)
{
  const GlobalFaces faces(surface);
  std::vector<Triangle> wanted;
  for (UnmeshedTriangle& other : others)
  {
    wanted.push_back(surface.verticesOf(surface.triangle(other.triangle)));
    other.vertices = faces.numbersOf(wanted.back());
    for (std::size_t k = 0; k < 3; ++k)
    {
      other.positions[k] = faces.position(wanted.back()[k]);
    }
  }
  const std::vector<FaceOfWhole> onVertices = faces.find(wanted);
  std::vector<Triangle> edges;
  std::vector<RefinedTemplate*> asked;
  for (std::size_t i = 0; i < others.size(); ++i)
  {
    const Triangle& t = wanted[i];
    others[i].like.face = onVertices[i];
    asked.push_back(&others[i].like);
    if (!onVertices[i].isThere() && t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
    {
      others[i].atEdges.resize(3);
      for (std::size_t k = 0; k < 3; ++k)
      {
        edges.push_back(GlobalFaces::edge(t[k], t[(k + 1) % 3]));
      }
    }
  }
  const std::vector<FaceOfWhole> atEdges = faces.find(edges);
  auto next = atEdges.begin();
  for (UnmeshedTriangle& other : others)
  {
    for (RefinedTemplate& like : other.atEdges)
    {
      like.face = *next++;
      asked.push_back(&like);
    }
  }
  asked.erase(std::remove_if(asked.begin(), asked.end(),
                [](const RefinedTemplate* like) { return !like->face.isThere(); }),
    asked.end());
  return asked;
}

/// All ranks call this together.
std::vector<UnmeshedTriangle> findOtherTriangles(const PolyDataSurface& surface,
  const std::vector<Id>& faceOfTriangle, const std::vector<Triangle>& cornerPoints,
  const RefinedMesh& refined)
{
  std::vector<UnmeshedTriangle> others;
  for (Id i = 0; i < faceOfTriangle.size(); ++i)
  {
    if (faceOfTriangle[i] == NoId)
    {
      others.emplace_back().triangle = i;
    }
  }
  if (!surface.partition().exchange().isTrueAnywhere(!others.empty()))
  {
    return others;
  }
  const std::vector<RefinedTemplate*> found = findFaces(surface, others);
  std::vector<RankAddress> asked;
  for (const RefinedTemplate* like : found)
  {
    asked.push_back(like->face.address);
  }
  std::vector<RefinedFace> answers =
    findRefinedFaces(asked, surface.partition(), refined, cornerPoints);
  for (std::size_t i = 0; i < answers.size(); ++i)
  {
    found[i]->parts = std::move(answers[i]);
  }
  for (UnmeshedTriangle& other : others)
  {
    for (std::size_t k = 0; k < other.atEdges.size(); ++k)
    {
      const RefinedTemplate& like = other.atEdges[k];
      if (like.face.isThere())
      {
        other.splits[k] = splitsBetween(like.parts, like.face.cornerAt(other.vertices[k]),
          like.face.cornerAt(other.vertices[(k + 1) % 3]));
      }
    }
  }
  return others;
}

/// Whether all ranks have more triangles than they may; copies do not count.
bool areTooMany(const PolyDataSurface& surface, const std::vector<UnmeshedTriangle>& others,
  const RefinedMesh& refined, std::uint64_t maximumFaces)
{
  std::uint64_t total = refined.triangles.size();
  for (const UnmeshedTriangle& other : others)
  {
    total += surface.isCopy(other.triangle) ? 0 : other.numberOfParts();
  }
  return sumOverRanks(surface.partition().exchange(), total).all > maximumFaces && maximumFaces > 0;
}

} // anonymous namespace

std::vector<Triangle> cornerPointsOfPiece(const PolyDataSurface& surface)
{
  std::vector<Triangle> points;
  points.reserve(surface.mesh().numberOfFaces());
  for (const Id triangle : trianglesOfFaces(surface))
  {
    points.push_back(triangle == NoId ? Triangle{ NoId, NoId, NoId } : surface.triangle(triangle));
  }
  return points;
}

std::uint64_t countOwnTriangles(const PolyDataSurface& surface)
{
  return sumOverRanks(surface.partition().exchange(), surface.numberOfOwnTriangles()).all;
}

std::vector<RankAddress> addOtherTrianglesOfPiece(const PolyDataSurface& surface,
  std::uint64_t maximumFaces, const std::vector<Triangle>& cornerPoints, RefinedMesh& refined)
{
  const std::vector<Id> faceOfTriangle = facesOfTriangles(surface);
  const std::vector<UnmeshedTriangle> others =
    findOtherTriangles(surface, faceOfTriangle, cornerPoints, refined);
  const bool stayWhole = areTooMany(surface, others, refined, maximumFaces);
  const std::vector<std::size_t> first = firstParts(refined.faces, surface.mesh().numberOfFaces());
  TemplateCopier parts(refined);
  std::vector<Triangle> triangles;
  std::vector<Id> parents;
  auto other = others.begin();
  for (Id i = 0; i < faceOfTriangle.size(); ++i)
  {
    const Id face = faceOfTriangle[i];
    if (face != NoId)
    {
      const auto begin = refined.triangles.begin();
      triangles.insert(triangles.end(), begin + static_cast<std::ptrdiff_t>(first[face]),
        begin + static_cast<std::ptrdiff_t>(first[face + std::size_t(1)]));
    }
    else
    {
      const bool staysWhole = other->numberOfParts() == 0 || (stayWhole && !surface.isCopy(i));
      if (other->isBarrier())
      {
        parts.addBarrier(*other, surface.triangle(i), triangles);
      }
      else if (staysWhole)
      {
        triangles.push_back(surface.triangle(i));
      }
      else
      {
        parts.add(*other, surface.triangle(i), triangles);
      }
      ++other;
    }
    parents.resize(triangles.size(), i);
  }
  refined.triangles = std::move(triangles);
  refined.faces = std::move(parents);
  return parts.takeAdded();
}

}
