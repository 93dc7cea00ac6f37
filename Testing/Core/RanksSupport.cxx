// SPDX-License-Identifier: BSD-3-Clause
#include "RanksSupport.h"

#include "source/SourceWindows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <string>

namespace geodesictest
{

Piece pieceOf(const CutMesh& cut, int rank)
{
  Piece piece;
  std::map<Index, geodesic::Id> vertexOf;
  for (Index face = 0; face < cut.mesh.triangles.size(); ++face)
  {
    if (cut.rankOfFace[face] != rank)
    {
      continue;
    }
    geodesic::Triangle triangle;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Index whole = cut.mesh.triangles[face][k];
      const auto found =
        vertexOf.try_emplace(whole, static_cast<geodesic::Id>(piece.points.size()));
      if (found.second)
      {
        const Vec3& p = cut.mesh.points[whole];
        piece.points.push_back({ p[0], p[1], p[2] });
        piece.keys.push_back(std::uint64_t(1) << 40 | whole);
        piece.wholeVertices.push_back(whole);
      }
      triangle[k] = found.first->second;
    }
    piece.triangles.push_back(triangle);
    piece.wholeFaces.push_back(face);
  }
  return piece;
}

namespace
{

/// The address of each face of the whole mesh; a collective call of all ranks.
std::vector<geodesic::RankAddress> facesOnRanks(
  const CutMesh& cut, const Piece& piece, const geodesic::MeshPartition& part)
{
  geodesic::Message message;
  for (geodesic::Id face = part.firstOwnFace(); face < part.endOfOwnFaces(); ++face)
  {
    geodesic::put(message, piece.wholeFaces[part.triangleOf(face)]);
    geodesic::put(message, face);
  }
  std::vector<geodesic::RankAddress> result(
    cut.mesh.triangles.size(), geodesic::RankAddress{ -1, geodesic::NoId });
  geodesic::readEach(part.exchange().tellAll(message),
    [&](int rank, geodesic::MessageReader& reader)
    {
      const auto face = reader.get<Index>();
      result[face] = { rank, reader.get<geodesic::Id>() };
    });
  return result;
}

std::vector<Polyline> onPatch(std::vector<Polyline> curves, const geodesic::ReplicatedPatch& patch,
  const std::vector<geodesic::RankAddress>& faces)
{
  for (Polyline& curve : curves)
  {
    for (MeshSegment& segment : curve.segments)
    {
      segment.face = patch.faceAt(faces[segment.face]);
    }
  }
  return curves;
}

CutMesh cutBy(const PlainMesh& mesh, int numberOfRanks, const std::function<int(Index)>& rankOf)
{
  CutMesh cut = { mesh, numberOfRanks, {} };
  for (Index face = 0; face < mesh.triangles.size(); ++face)
  {
    cut.rankOfFace.push_back(rankOf(face));
  }
  return cut;
}

} // anonymous namespace

CutMesh cutAtRandom(const PlainMesh& mesh, int numberOfRanks, Random& random)
{
  return cutBy(mesh, numberOfRanks,
    [&](Index) { return static_cast<int>(random.below(static_cast<std::size_t>(numberOfRanks))); });
}

CutMesh cutInSpace(const PlainMesh& mesh, int numberOfRanks, Random& random)
{
  std::vector<Vec3> centres;
  for (int rank = 0; rank < numberOfRanks; ++rank)
  {
    centres.push_back(mesh.points[random.below(mesh.points.size())]);
  }
  return cutBy(mesh, numberOfRanks,
    [&](Index face)
    {
      const Vec3& p = mesh.points[mesh.triangles[face][0]];
      const auto nearest = std::min_element(centres.begin(), centres.end(),
        [&](const Vec3& a, const Vec3& b) { return spaceDistance(a, p) < spaceDistance(b, p); });
      return static_cast<int>(nearest - centres.begin());
    });
}

std::vector<WayToCut> someWaysToCut()
{
  return { { 2, false }, { 3, true }, { 4, false }, { 7, true }, { 7, false } };
}

void forEachCut(const PlainMesh& mesh, const std::vector<WayToCut>& ways, Random& random,
  const std::function<void(const CutMesh&)>& test)
{
  for (const auto& [ranks, inSpace] : ways)
  {
    SCOPED_TRACE(std::to_string(ranks) + (inSpace ? " ranks in space" : " ranks at random"));
    test(inSpace ? cutInSpace(mesh, ranks, random) : cutAtRandom(mesh, ranks, random));
  }
}

Index wholeFaceOf(const RankOfRun& rank, const geodesic::RankAddress& face)
{
  const auto found = std::find_if(rank.facesOnRanks.begin(), rank.facesOnRanks.end(),
    [&face](const geodesic::RankAddress& f) { return f.rank == face.rank && f.id == face.id; });
  return static_cast<Index>(found - rank.facesOnRanks.begin());
}

std::vector<geodesic::Id> ownFacesOf(const geodesic::MeshPartition& part)
{
  std::vector<geodesic::Id> faces(part.endOfOwnFaces() - part.firstOwnFace());
  std::iota(faces.begin(), faces.end(), part.firstOwnFace());
  return faces;
}

void onRanks(const CutMesh& cut, const std::vector<Polyline>& curves, std::uint64_t disorder,
  const std::function<void(const RankOfRun&)>& work)
{
  MemoryRanks ranks(cut.numberOfRanks, disorder);
  ranks.run(
    [&](geodesic::Exchange& exchange)
    {
      const Piece piece = pieceOf(cut, exchange.rank());
      const geodesic::MeshPartition part(piece.points, piece.triangles, piece.keys, exchange);
      const std::vector<geodesic::RankAddress> faces = facesOnRanks(cut, piece, part);
      std::vector<geodesic::Id> selected;
      for (const Polyline& curve : curves)
      {
        for (const MeshSegment& segment : curve.segments)
        {
          if (faces[segment.face].rank == exchange.rank() && part.isOwn(faces[segment.face].id))
          {
            selected.push_back(faces[segment.face].id);
          }
        }
      }
      const geodesic::ReplicatedPatch patch(part, selected);
      const std::vector<geodesic::SourceCurve> curvesOnPatch =
        engineCurves(patch.mesh(), onPatch(curves, patch, faces));
      const geodesic::SourceWindows sources = makeSourceWindows(part, patch, curvesOnPatch);
      work({ exchange, part, piece.wholeVertices, piece.wholeFaces, faces, patch, curvesOnPatch,
        sources });
    });
}

}
