// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_RanksSupport_h
#define geodesictest_RanksSupport_h

#include "EngineSupport.h"
#include "MemoryRanks.h"

#include "front/Front.h"
#include "mesh/MeshPartition.h"
#include "mesh/ReplicatedPatch.h"

#include <functional>
#include <vector>

namespace geodesictest
{

/// A mesh with the rank that owns each face.
struct CutMesh
{
  const PlainMesh& mesh;
  int numberOfRanks;
  std::vector<int> rankOfFace;
};

/// Each face goes to a random rank.
CutMesh cutAtRandom(const PlainMesh& mesh, int numberOfRanks, Random& random);
/// Each face goes to the rank of the nearest of random points, one per rank; a rank may get no
/// face.
CutMesh cutInSpace(const PlainMesh& mesh, int numberOfRanks, Random& random);

/// How a mesh is cut: the number of ranks, and whether in space or at random.
struct WayToCut
{
  int numberOfRanks;
  bool inSpace;
};
std::vector<WayToCut> someWaysToCut();

/// Tests a mesh cut in each of the ways; failure messages name the way.
void forEachCut(const PlainMesh& mesh, const std::vector<WayToCut>& ways, Random& random,
  const std::function<void(const CutMesh&)>& test);

/// The faces of a cut mesh that one rank owns.
struct Piece
{
  std::vector<geodesic::Vec3> points;
  std::vector<geodesic::Triangle> triangles;
  /// Of the points, below EndOfKeys.
  std::vector<std::uint64_t> keys;
  std::vector<Index> wholeVertices;
  std::vector<Index> wholeFaces;

  static constexpr std::uint64_t EndOfKeys = std::uint64_t(1) << 41;
};
Piece pieceOf(const CutMesh& cut, int rank);

std::vector<geodesic::Id> ownFacesOf(const geodesic::MeshPartition& part);

/// One rank of a run: its partition of the surface, and its share of the sources.
struct RankOfRun
{
  geodesic::Exchange& exchange;
  const geodesic::MeshPartition& part;
  /// The whole mesh's numbers of the partition's vertices and owned triangles.
  const std::vector<Index>& wholeVertices;
  const std::vector<Index>& wholeFaces;
  /// For each face of the whole mesh, its address.
  const std::vector<geodesic::RankAddress>& facesOnRanks;
  /// The curves on a replicated patch, and their windows for this rank's front.
  const geodesic::ReplicatedPatch& patch;
  const std::vector<geodesic::SourceCurve>& curvesOnPatch;
  const geodesic::SourceWindows& sources;
};

/// The whole mesh's number of a face of any rank.
Index wholeFaceOf(const RankOfRun& rank, const geodesic::RankAddress& face);

/// Runs the work on every rank of a cut mesh, with sources given on the whole mesh.
///
/// \param disorder as in MemoryRanks.
void onRanks(const CutMesh& cut, const std::vector<Polyline>& curves, std::uint64_t disorder,
  const std::function<void(const RankOfRun&)>& work);

}

#endif
