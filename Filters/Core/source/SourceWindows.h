// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceWindows_h
#define geodesic_SourceWindows_h

#include "Progress.h"
#include "mesh/TriangleMesh.h"
#include "source/LeavingWindow.h"
#include "source/SourceCurve.h"
#include "source/SourceInFace.h"

#include <vector>

namespace geodesic
{

/// What the sources give the front to begin with (paper, sections 4.1 and 4.2).
struct SourceWindows
{
  std::vector<LeavingWindow> windows;
  /// In the order of the faces.
  std::vector<SourceInFace> inFaces;
  /// On a part of a surface that ranks have together: those in the halo, in the same order. Their
  /// owners start from them.
  std::vector<SourceInFace> inHalo;
  /// Mesh vertices on a source, ascending, each once.
  std::vector<Id> vertices;
  /// Vertices so near to a source's point that the directions around them cannot be told apart in
  /// the windows of that point: they are to be pseudo-sources.
  std::vector<Id> nearVertices;
};

/// The curves are joined at their ends (CurveChains) and numbered so in windows and in
/// SourceInFace.
///
/// Linear windows to both sides of every segment, and circular windows from every vertex of a curve
/// into its wedge: the directions at right angles or more to all its segments. Where a curve is
/// only cut by a mesh edge there is no wedge. Takes time in proportion to the segments and to the
/// faces around their ends.
///
/// \param progress called now and then with a fraction done; returning false throws Aborted.
SourceWindows makeSourceWindows(const TriangleMesh& mesh, const std::vector<SourceCurve>& curves,
  const ProgressCallback& progress = {});

}

#endif
