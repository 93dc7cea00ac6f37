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

/// A mesh cut into parts: the rank that owns each face.
struct CutMesh
{
  const PlainMesh& mesh;
  int numberOfRanks;
  std::vector<int> rankOfFace;
};

/// Each face goes to any rank.
CutMesh cutAtRandom(const PlainMesh& mesh, int numberOfRanks, Random& random);
/// Each face goes to the nearest of random points, one a rank: ranks may have none.
CutMesh cutInSpace(const PlainMesh& mesh, int numberOfRanks, Random& random);

/// How a mesh is cut: the number of ranks, and whether in space or at random.
struct WayToCut
{
  int numberOfRanks;
  bool inSpace;
};
std::vector<WayToCut> someWaysToCut();
/// Each number of ranks both at random and in space.
std::vector<WayToCut> bothWaysToCut(const std::vector<int>& numbersOfRanks);

/// Tests a mesh cut in each of the ways. What fails is told with the way.
void forEachCut(const PlainMesh& mesh, const std::vector<WayToCut>& ways, Random& random,
  const std::function<void(const CutMesh&)>& test);

/// One rank of a run: its part of the surface, and what the sources are to it.
struct RankOfRun
{
  geodesic::Exchange& exchange;
  const geodesic::MeshPartition& part;
  /// The vertices and faces of the whole mesh that the part's vertices and owned triangles are.
  const std::vector<Index>& wholeVertices;
  const std::vector<Index>& wholeFaces;
  /// What each face of the whole mesh is on the rank that has it.
  const std::vector<geodesic::RankAddress>& facesOnRanks;
  /// The curves on a patch that all ranks have, and what they give this part's front.
  const geodesic::ReplicatedPatch& patch;
  const std::vector<geodesic::SourceCurve>& curvesOnPatch;
  const geodesic::SourceWindows& sources;
};

/// The face of the whole mesh that a face of any rank is.
Index wholeFaceOf(const RankOfRun& rank, const geodesic::RankAddress& face);

/// Runs the work on every rank of a cut mesh, with sources given on the whole one.
///
/// \param disorder as of MemoryRanks.
void onRanks(const CutMesh& cut, const std::vector<Polyline>& curves, std::uint64_t disorder,
  const std::function<void(const RankOfRun&)>& work);

/// What a front over ranks finds.
struct RanksResult
{
  /// At the whole mesh's vertices; not a number where ranks that share one have found different
  /// ones.
  std::vector<double> vertices;
  double relativeErrorBound = 0.0;
  std::uint64_t windowsPropagated = 0;
};
RanksResult distancesOnRanks(const CutMesh& cut, const std::vector<Polyline>& curves,
  const geodesic::FrontOptions& options, std::uint64_t disorder = 0);

}

#endif
