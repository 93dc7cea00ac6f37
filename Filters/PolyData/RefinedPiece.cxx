// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/RefinedPiece.h"

#include "refinement/RefinedFaces.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace geodesic
{

namespace
{

/// A face of the whole, and its corners' vertices by their numbers in the whole.
struct FaceOfWhole
{
  RankAddress address{ -1, NoId };
  Triangle vertices{ NoId, NoId, NoId };
};

Triangle sorted(Triangle t)
{
  std::sort(t.begin(), t.end());
  return t;
}

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
      visit(i, surface.part()->faceOfTriangle(next++));
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
      if (face != NoId && surface.part()->isOwn(face) && triangles[face] == NoId)
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

/// A triangle of a piece that is no face that the piece owns, and what it has to look like.
struct OtherTriangle
{
  Id triangle = NoId;
  /// By their numbers in the whole.
  Triangle vertices{};
  FaceOfWhole face;
  RefinedFace parts;
};

/// Finds the faces, of any rank, on the vertices of triangles of a piece.
class FacesOfWhole
{
public:
  /// All ranks call together, as for find().
  explicit FacesOfWhole(const PolyDataSurface& surface)
    : surface_(surface)
    , part_(*surface.part())
  {
    const TriangleMesh& mesh = surface.mesh();
    for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
    {
      this->numbers_.push_back(this->part_.numberInWhole(vertex));
      this->holders_.push_back({ this->part_.exchange().rank(), vertex });
    }
    for (Id vertex = this->part_.numberOfOwnVertices(); vertex < mesh.numberOfVertices(); ++vertex)
    {
      this->haloVertices_.emplace(this->numbers_[vertex], vertex);
    }
    surface.completeValues(NoId, this->numbers_);
    surface.completeValues(RankAddress{ -1, NoId }, this->holders_);
  }

  /// Sets their vertices, and the faces on these where there are any.
  void find(std::vector<OtherTriangle>& others) const
  {
    std::vector<Message> questions = this->part_.exchange().noMessages();
    std::vector<std::vector<OtherTriangle*>> asked(questions.size());
    for (OtherTriangle& other : others)
    {
      const Triangle here = this->surface_.verticesOf(this->surface_.triangle(other.triangle));
      other.vertices = this->numbersOf(here);
      other.face = this->findHere(here);
      const RankAddress holder = this->otherHolder(here);
      if (other.face.address.id == NoId && holder.id != NoId)
      {
        const auto rank = indexOf(holder.rank);
        put(questions[rank], holder.id);
        put(questions[rank], sorted(other.vertices));
        asked[rank].push_back(&other);
      }
    }
    std::vector<std::size_t> next(asked.size(), 0);
    readEach(this->part_.exchange().step(this->answer(std::move(questions))),
      [&](int rank, MessageReader& reader)
      {
        const auto from = indexOf(rank);
        asked[from][next[from]++]->face = reader.get<FaceOfWhole>();
      });
  }

private:
  Triangle numbersOf(const Triangle& vertices) const
  {
    return { this->numbers_[vertices[0]], this->numbers_[vertices[1]],
      this->numbers_[vertices[2]] };
  }

  FaceOfWhole faceOfWhole(Id face) const
  {
    return { this->part_.addressOf(face), this->numbersOf(this->part_.mesh().triangle(face)) };
  }

  /// A face of the part's mesh, owned or not.
  FaceOfWhole findHere(const Triangle& vertices) const
  {
    const Triangle wanted = sorted(this->numbersOf(vertices));
    for (const Id vertex : vertices)
    {
      const auto halo = this->haloVertices_.find(this->numbers_[vertex]);
      if (vertex < this->part_.mesh().numberOfVertices())
      {
        return this->findAround(vertex, wanted); // the part has all faces around
      }
      if (halo != this->haloVertices_.end())
      {
        const FaceOfWhole found = this->findAround(halo->second, wanted);
        if (found.address.id != NoId)
        {
          return found;
        }
      }
    }
    return {};
  }

  FaceOfWhole findAround(Id vertex, const Triangle& wanted) const
  {
    for (const Id corner : this->part_.mesh().cornersAt(vertex))
    {
      const FaceOfWhole face = this->faceOfWhole(TriangleMesh::faceOf(corner));
      if (sorted(face.vertices) == wanted)
      {
        return face;
      }
    }
    return {};
  }

  /// A rank that owns faces at one of the triangle's vertices, where that is another one, and the
  /// vertex's number there: it has all faces around it.
  RankAddress otherHolder(const Triangle& vertices) const
  {
    for (const Id vertex : vertices)
    {
      if (this->holders_[vertex].rank >= 0 &&
        this->holders_[vertex].rank != this->part_.exchange().rank())
      {
        return this->holders_[vertex];
      }
    }
    return { -1, NoId };
  }

  std::vector<Message> answer(std::vector<Message> questions) const
  {
    std::vector<Message> answers = this->part_.exchange().noMessages();
    readEach(this->part_.exchange().step(std::move(questions)),
      [&](int rank, MessageReader& reader)
      {
        const Id vertex = reader.get<Id>();
        put(answers[indexOf(rank)], this->findAround(vertex, reader.get<Triangle>()));
      });
    return answers;
  }

  const PolyDataSurface& surface_;
  const SurfacePart& part_;
  /// Of each vertex that vertexOf() names: its number in the whole, and who owns faces there.
  std::vector<Id> numbers_;
  std::vector<RankAddress> holders_;
  std::unordered_map<Id, Id> haloVertices_;
};

/// Gives a triangle the parts of a face on its vertices.
class PartsOfFace
{
public:
  explicit PartsOfFace(RefinedMesh& refined)
    : refined_(refined)
    , numbering_(refined)
    , ownPoints_(refined.points.size())
  {
  }

  /// \param points the input's points at the triangle's corners.
  void add(const OtherTriangle& other, const Triangle& points, std::vector<Triangle>& triangles)
  {
    const Triangle& vertices = other.vertices;
    const FaceOfWhole& face = other.face;
    const RefinedFace& parts = other.parts;
    std::vector<Id> numbers;
    for (const Id vertex : face.vertices)
    {
      const auto k = std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin();
      numbers.push_back(points[static_cast<std::size_t>(k)]);
    }
    for (std::size_t i = 0; i < parts.points.size(); ++i)
    {
      RefinedPoint point = parts.points[i];
      point.parents = { numbers[point.parents[0]], numbers[point.parents[1]] };
      numbers.push_back(this->numbering_.numberOf(point));
      if (this->ownPoints_ + this->added_.size() < this->refined_.points.size())
      {
        this->added_.push_back({ face.address.rank, parts.numbersThere[i] });
      }
    }
    const auto first = std::find(vertices.begin(), vertices.end(), face.vertices[0]);
    const std::size_t next = (static_cast<std::size_t>(first - vertices.begin()) + 1) % 3;
    const bool isTurned = vertices[next] != face.vertices[1];
    for (const Triangle& t : parts.triangles)
    {
      Triangle part = { numbers[t[0]], numbers[t[1]], numbers[t[2]] };
      if (isTurned)
      {
        std::swap(part[1], part[2]);
      }
      triangles.push_back(part);
    }
  }

  std::vector<RankAddress> takeAdded() { return std::move(this->added_); }

private:
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

/// All ranks call this together.
std::vector<OtherTriangle> findOtherTriangles(const PolyDataSurface& surface,
  const std::vector<Id>& faceOfTriangle, const std::vector<Triangle>& cornerPoints,
  const RefinedMesh& refined)
{
  std::vector<OtherTriangle> others;
  for (Id i = 0; i < faceOfTriangle.size(); ++i)
  {
    if (faceOfTriangle[i] == NoId)
    {
      others.emplace_back().triangle = i;
    }
  }
  if (!surface.part()->exchange().isTrueAnywhere(!others.empty()))
  {
    return others;
  }
  const FacesOfWhole faces(surface);
  faces.find(others);
  std::vector<RankAddress> asked;
  std::vector<std::size_t> askedFor;
  for (std::size_t i = 0; i < others.size(); ++i)
  {
    if (others[i].face.address.id != NoId)
    {
      asked.push_back(others[i].face.address);
      askedFor.push_back(i);
    }
  }
  std::vector<RefinedFace> answers =
    findRefinedFaces(asked, *surface.part(), refined, cornerPoints);
  for (std::size_t i = 0; i < answers.size(); ++i)
  {
    others[askedFor[i]].parts = std::move(answers[i]);
  }
  return others;
}

/// Whether all ranks have more triangles than they may; copies do not count.
bool areTooMany(const PolyDataSurface& surface, const std::vector<OtherTriangle>& others,
  const RefinedMesh& refined, std::uint64_t maximumFaces)
{
  std::uint64_t total = refined.triangles.size();
  for (const OtherTriangle& other : others)
  {
    total += surface.isCopy(other.triangle) ? 0 : other.parts.triangles.size();
  }
  return sumOverRanks(surface.part()->exchange(), total).all > maximumFaces && maximumFaces > 0;
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
  return surface.part()
    ? sumOverRanks(surface.part()->exchange(), surface.numberOfOwnTriangles()).all
    : surface.numberOfOwnTriangles();
}

std::vector<RankAddress> addOtherTrianglesOfPiece(const PolyDataSurface& surface,
  std::uint64_t maximumFaces, const std::vector<Triangle>& cornerPoints, RefinedMesh& refined)
{
  const std::vector<Id> faceOfTriangle = facesOfTriangles(surface);
  const std::vector<OtherTriangle> others =
    findOtherTriangles(surface, faceOfTriangle, cornerPoints, refined);
  const bool stayWhole = areTooMany(surface, others, refined, maximumFaces);
  const std::vector<std::size_t> first = firstParts(refined.faces, surface.mesh().numberOfFaces());
  PartsOfFace parts(refined);
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
      if (other->parts.triangles.empty() || (stayWhole && !surface.isCopy(i)))
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
