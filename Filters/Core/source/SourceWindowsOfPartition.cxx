// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceWindowsOfPartition.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// The origin of a window of the patch, with global ids.
Id globalOrigin(const MeshPartition& part, const ReplicatedPatch& patch, Id origin)
{
  const Id vertices = patch.mesh().numberOfVertices();
  return CurveSide::isOne(origin, vertices)
    ? CurveSide::first(part.numberOfGlobalVertices()) + (origin - CurveSide::first(vertices))
    : patch.globalId(origin);
}

std::vector<Id> verticesOfPart(const ReplicatedPatch& patch, const std::vector<Id>& vertices)
{
  std::vector<Id> result;
  for (const Id vertex : vertices)
  {
    if (patch.vertexOfPart(vertex) != NoId)
    {
      result.push_back(patch.vertexOfPart(vertex));
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

} // anonymous namespace

SourceWindows sourceWindowsOfPartition(
  const MeshPartition& part, const ReplicatedPatch& patch, const SourceWindows& onPatch)
{
  SourceWindows result;
  const auto ownFace = [&](Id face)
  {
    const Id own = patch.faceOfPart(face);
    return own != NoId && part.isOwn(own) ? own : NoId;
  };
  for (const LeavingWindow& leaving : onPatch.windows)
  {
    const Id face = ownFace(TriangleMesh::faceOf(leaving.halfedge));
    if (face != NoId)
    {
      result.windows.push_back({ 3 * face + leaving.halfedge % 3, leaving.window });
      result.windows.back().window.origin = globalOrigin(part, patch, leaving.window.origin);
    }
  }
  for (const SourceInFace& source : onPatch.inFaces)
  {
    const Id face = patch.faceOfPart(source.face);
    if (face != NoId)
    {
      std::vector<SourceInFace>& sources = part.isOwn(face) ? result.inFaces : result.inHalo;
      sources.push_back(source);
      sources.back().face = face;
    }
  }
  result.vertices = verticesOfPart(patch, onPatch.vertices);
  result.nearVertices = verticesOfPart(patch, onPatch.nearVertices);
  return result;
}

}
