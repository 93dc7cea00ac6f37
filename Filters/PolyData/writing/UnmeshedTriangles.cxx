// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/UnmeshedTriangles.h"

#include "PolyData/writing/GlobalFaces.h"
#include "mesh/FacesWithoutArea.h"
#include "refinement/RefinedOnRanks.h"

#include <algorithm>
#include <array>
#include <utility>

namespace geodesic
{

namespace
{

/// How a face of the whole surface is refined: the template of triangles on its vertices or at its
/// edges.
struct RefinedTemplate
{
  GlobalFace face;
  RefinedFace parts;

  /// Adds the points that split an edge or a part of it, from one end to the other, by their
  /// numbers in the face.
  void addSplits(Id a, Id b, std::vector<Id>& splits) const
  {
    const auto isMiddle = [a, b](const RefinedPoint& point)
    { return std::minmax(a, b) == std::minmax(point.parents[0], point.parents[1]); };
    const std::vector<RefinedPoint>& points = this->parts.points;
    const auto found = std::find_if(points.begin(), points.end(), isMiddle);
    if (found != points.end())
    {
      const auto middle = static_cast<Id>(3 + (found - points.begin()));
      this->addSplits(a, middle, splits);
      splits.push_back(middle);
      this->addSplits(middle, b, splits);
    }
  }
};

/// The points on the edges of a triangle, on edge k from corner k to corner k + 1.
using EdgeSplits = std::array<std::vector<Id>, 3>;

/// A part of this rank that is not a face of the mesh, and what it has to look like.
struct UnmeshedTriangle
{
  Id part;
  /// Global numbers of its vertices.
  Triangle vertices;
  /// The template on its vertices; NoId if no face is there.
  Id like = NoId;
  /// The templates at a barrier's edges from corner k on; NoId at edges without a face.
  std::array<Id, 3> atEdges{ NoId, NoId, NoId };
  /// The points that split these edges, by their numbers in the template and along its edge.
  EdgeSplits splits{};
};

/// The parts of this rank that are not faces, in their order, and their templates.
struct UnmeshedTriangles
{
  std::vector<UnmeshedTriangle> triangles;
  std::vector<RefinedTemplate> templates;

  std::size_t numberOfParts(const UnmeshedTriangle& triangle) const
  {
    const auto& [a, b, c] = triangle.splits;
    return triangle.like != NoId ? this->templates[triangle.like].parts.triangles.size()
                                 : 1 + a.size() + b.size() + c.size();
  }
};

/// For each part the face that is made of it; NoId if none here is.
std::vector<Id> facesOfParts(const PolyDataSurface& surface)
{
  std::vector<Id> faces(surface.numberOfParts, NoId);
  const MeshPartition& partition = surface.partition;
  for (Id face = partition.firstOwnFace(); face < partition.endOfOwnFaces(); ++face)
  {
    faces[surface.partOf(face)] = face;
  }
  return faces;
}

/// Finds the faces on the vertices of triangles, and those at the edges of triangles without such a
/// face.
void findTemplates(
  const PolyDataSurface& surface, const GlobalFaces& faces, UnmeshedTriangles& unmeshed)
{
  const auto add = [&](const GlobalFace& face, Id& index)
  {
    if (face.isThere())
    {
      index = static_cast<Id>(unmeshed.templates.size());
      unmeshed.templates.push_back({ face, {} });
    }
  };
  std::vector<Triangle> wanted;
  for (const UnmeshedTriangle& triangle : unmeshed.triangles)
  {
    wanted.push_back(surface.verticesAt(triangle.part));
  }
  const std::vector<GlobalFace> onVertices = faces.find(wanted);
  std::vector<Triangle> edges;
  std::vector<Id*> indices;
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    const Triangle& t = wanted[i];
    UnmeshedTriangle& triangle = unmeshed.triangles[i];
    triangle.vertices = faces.globalIds(t);
    add(onVertices[i], triangle.like);
    if (triangle.like == NoId && hasThreeVertices(t))
    {
      faces.forEachEdgeWithFaces(t,
        [&](std::size_t k, const Triangle& edge)
        {
          edges.push_back(edge);
          indices.push_back(&triangle.atEdges[k]);
        });
    }
  }
  const std::vector<GlobalFace> atEdges = faces.find(edges);
  for (std::size_t i = 0; i < atEdges.size(); ++i)
  {
    add(atEdges[i], *indices[i]);
  }
}

UnmeshedTriangles findUnmeshedTriangles(const PolyDataSurface& surface, const GlobalFaces& faces,
  const std::vector<Id>& faceOfPart, const std::vector<Triangle>& cornerPoints,
  const RefinedMesh& refined)
{
  UnmeshedTriangles unmeshed;
  for (Id i = 0; i < faceOfPart.size(); ++i)
  {
    if (faceOfPart[i] == NoId)
    {
      unmeshed.triangles.push_back({ i, {} });
    }
  }
  findTemplates(surface, faces, unmeshed);
  std::vector<RankAddress> asked;
  for (const RefinedTemplate& like : unmeshed.templates)
  {
    asked.push_back(like.face.address);
  }
  std::vector<RefinedFace> answers =
    findRefinedFaces(asked, surface.partition, refined, cornerPoints);
  for (std::size_t i = 0; i < answers.size(); ++i)
  {
    unmeshed.templates[i].parts = std::move(answers[i]);
  }
  for (UnmeshedTriangle& triangle : unmeshed.triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (triangle.atEdges[k] != NoId)
      {
        const RefinedTemplate& like = unmeshed.templates[triangle.atEdges[k]];
        const Id edge = like.face.edgeBetween(triangle.vertices[k], triangle.vertices[(k + 1) % 3]);
        like.addSplits(edge, (edge + 1) % 3, triangle.splits[k]);
      }
    }
  }
  return unmeshed;
}

/// Gives triangles the parts of their templates, with points of their own.
struct TemplateCopier
{
  const PolyDataSurface& surface;
  const GlobalFaces& faces;
  const UnmeshedTriangles& unmeshed;
  RefinedMesh& refined;
  SplitPointNumbering numbering{ refined };
  const std::size_t ownPoints = refined.points.size();
  /// The points that the added ones are copies of.
  std::vector<RankAddress> copied{};
  const RefinedTemplate* like = nullptr;
  /// The numbers of the template's corners and points; NoId where the triangle has no point yet.
  std::vector<Id> numbers{};

  /// \param isWhole whether a triangle on the vertices of a face is not cut.
  void add(const UnmeshedTriangle& triangle, bool isWhole, std::vector<Triangle>& triangles)
  {
    if (triangle.like == NoId)
    {
      this->addCut(triangle, triangles);
    }
    else if (isWhole || this->unmeshed.numberOfParts(triangle) <= 1)
    {
      triangles.push_back(this->surface.cornersOf(triangle.part));
    }
    else
    {
      this->addParts(triangle, triangles);
    }
  }

  /// What follows is about a triangle and one of its templates.
  void begin(const UnmeshedTriangle& triangle, Id number)
  {
    this->like = &this->unmeshed.templates[number];
    this->numbers.assign(3 + this->like->parts.points.size(), NoId);
    const Triangle points = this->surface.cornersOf(triangle.part);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Id corner = cornerAt(this->like->face.vertices, triangle.vertices[k]);
      if (corner < 3)
      {
        this->numbers[corner] = points[k];
      }
    }
  }

  /// The triangle's own point in place of one of the template's, which lies between corners that
  /// both have.
  Id ownPoint(Id point)
  {
    if (this->numbers[point] == NoId)
    {
      RefinedPoint copy = this->like->parts.points[point - 3];
      const std::array<Id, 2> parents = copy.parents;
      copy.parents[0] = this->ownPoint(parents[0]);
      copy.parents[1] = this->ownPoint(parents[1]);
      this->numbers[point] = this->numbering.numberOf(copy);
      if (this->ownPoints + this->copied.size() < this->refined.points.size())
      {
        this->copied.push_back(
          { this->like->face.address.rank, this->like->parts.numbersThere[point - 3] });
      }
    }
    return this->numbers[point];
  }

  void addParts(const UnmeshedTriangle& triangle, std::vector<Triangle>& triangles)
  {
    this->begin(triangle, triangle.like);
    const Triangle& vertices = triangle.vertices;
    const Triangle& there = this->like->face.vertices;
    const Id first = cornerAt(vertices, there[0]);
    const bool isTurned = vertices[(first + 1) % 3] != there[1];
    for (const Triangle& t : this->like->parts.triangles)
    {
      const Id a = this->ownPoint(t[0]);
      const Id b = this->ownPoint(t[1]);
      const Id c = this->ownPoint(t[2]);
      triangles.push_back(isTurned ? Triangle{ a, c, b } : Triangle{ a, b, c });
    }
  }

  /// Cuts a triangle as the faces at its edges are.
  void addCut(const UnmeshedTriangle& triangle, std::vector<Triangle>& triangles)
  {
    const Triangle points = this->surface.cornersOf(triangle.part);
    const Triangle vertices = this->surface.vertexOf(points);
    const auto positionOf = [&](Id point)
    {
      const Id corner = cornerAt(points, point);
      return corner < 3 ? this->faces.vertex(vertices[corner]).position
                        : this->refined.points[point - this->refined.numberOfInputPoints].position;
    };
    EdgeSplits splits;
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (triangle.atEdges[k] != NoId)
      {
        this->begin(triangle, triangle.atEdges[k]);
        for (const Id point : triangle.splits[k])
        {
          splits[k].push_back(this->ownPoint(point));
        }
        const GlobalFace& face = this->like->face;
        const Id edge = face.edgeBetween(triangle.vertices[k], triangle.vertices[(k + 1) % 3]);
        if (face.vertices[edge] != triangle.vertices[k])
        {
          std::reverse(splits[k].begin(), splits[k].end());
        }
      }
    }
    cutAtEdges(points, splits, positionOf, triangles);
  }
};

/// Whether all ranks have more triangles than they may. Copies do not count.
bool areTooMany(const PolyDataSurface& surface, const UnmeshedTriangles& unmeshed,
  const RefinedMesh& refined, std::uint64_t maximumFaces)
{
  std::uint64_t total = refined.triangles.size();
  for (const UnmeshedTriangle& triangle : unmeshed.triangles)
  {
    total += surface.isCopy(triangle.part) ? 0 : unmeshed.numberOfParts(triangle);
  }
  return sumOverRanks(surface.exchange(), total).all > maximumFaces && maximumFaces > 0;
}

} // anonymous namespace

// A face at the edge counts the barrier, on the rank that owns it.
std::unordered_map<Id, Id> barriersAtEdges(const PolyDataSurface& surface)
{
  std::unordered_map<Id, Id> count;
  if (!surface.barriers)
  {
    return count;
  }
  const GlobalFaces faces(surface);
  std::vector<Triangle> edges;
  for (const Id part : surface.barrierParts)
  {
    faces.forEachEdgeWithFaces(surface.verticesAt(part),
      [&edges](std::size_t, const Triangle& edge) { edges.push_back(edge); });
  }
  const std::vector<GlobalFace> found = faces.find(edges);
  std::vector<Message> messages = surface.exchange().noMessages();
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    if (found[i].isThere())
    {
      const Id edge = found[i].edgeBetween(
        faces.vertex(edges[i][0]).globalId, faces.vertex(edges[i][1]).globalId);
      put(messages[rankIndex(found[i].address.rank)],
        TriangleMesh::halfedgeOf(found[i].address.id, edge));
    }
  }
  readEach(surface.exchange().step(std::move(messages)),
    [&](int, MessageReader& reader) { ++count[surface.mesh().edgeOf(reader.get<Id>())]; });
  return count;
}

namespace
{

/// Counts the surface's cut points among the points of refinement: the first of these.
void takeCutPoints(
  const PolyDataSurface& surface, const std::vector<double>& vertexDistances, RefinedMesh& refined)
{
  std::vector<RefinedPoint> points;
  for (std::size_t i = 0; i < surface.cutPoints.size(); ++i)
  {
    const Id vertex = surface.vertexOf(surface.numberOfPoints + static_cast<Id>(i));
    const bool isInMesh = vertex < surface.mesh().numberOfVertices();
    points.push_back({ surface.cutPoints[i].parents, surface.cutPoints[i].weight,
      SurfacePoint::atVertex(vertex), isInMesh ? surface.mesh().point(vertex) : Vec3(),
      isInMesh ? vertexDistances[vertex] : Infinity });
  }
  points.insert(points.end(), refined.points.begin(), refined.points.end());
  refined.points = std::move(points);
  refined.numberOfInputPoints = surface.numberOfPoints;
}

} // anonymous namespace

RefinedSurface addUnmeshedTriangles(const PolyDataSurface& surface, std::uint64_t maximumFaces,
  const std::vector<Triangle>& cornerPoints, const std::vector<double>& vertexDistances,
  RefinedMesh refined)
{
  const MeshPartition& partition = surface.partition;
  const Id ownFaces = partition.endOfOwnFaces() - partition.firstOwnFace();
  if (!surface.exchange().isTrueAnywhere(surface.numberOfParts != ownFaces))
  {
    for (Id& face : refined.faces)
    {
      face = surface.triangleOf(face);
    }
    return { std::move(refined), {} };
  }
  takeCutPoints(surface, vertexDistances, refined);
  const GlobalFaces faces(surface);
  const std::vector<Id> faceOfPart = facesOfParts(surface);
  const UnmeshedTriangles unmeshed =
    findUnmeshedTriangles(surface, faces, faceOfPart, cornerPoints, refined);
  const bool stayWhole = areTooMany(surface, unmeshed, refined, maximumFaces);
  TemplateCopier copier{ surface, faces, unmeshed, refined };
  std::vector<Triangle> triangles;
  std::vector<Id> parents;
  std::size_t part = 0;
  auto next = unmeshed.triangles.begin();
  for (Id i = 0; i < faceOfPart.size(); ++i)
  {
    if (faceOfPart[i] == NoId)
    {
      copier.add(*next++, stayWhole && !surface.isCopy(i), triangles);
    }
    for (; part < refined.faces.size() && refined.faces[part] == faceOfPart[i]; ++part)
    {
      triangles.push_back(refined.triangles[part]);
    }
    parents.resize(triangles.size(), surface.triangleOfPart(i));
  }
  refined.triangles = std::move(triangles);
  refined.faces = std::move(parents);
  return { std::move(refined), std::move(copier.copied) };
}

}
