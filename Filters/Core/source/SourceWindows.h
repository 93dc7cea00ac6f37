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

/// The beginning of a front: windows and vertices of the sources (paper, sections 4.1 and 4.2).
struct SourceWindows
{
  std::vector<LeavingWindow> windows;
  /// In the order of the faces.
  std::vector<SourceInFace> inFaces;
  /// If ranks share the surface: the sources in the halo, in the same order. Their owners start
  /// from them.
  std::vector<SourceInFace> inHalo;
  /// Mesh vertices on a source, ascending, each once.
  std::vector<Id> vertices;
  /// Vertices so near to a source's point that the point's windows cannot represent the directions
  /// around them: they become pseudo-sources.
  std::vector<Id> nearVertices;
};

/// Joins the curves at their ends (CurveChains); windows and SourceInFace use the chains' numbers.
///
/// Emits linear windows to both sides of every segment, and circular windows from every vertex of a
/// curve into its wedge: the directions at right angles or more to all its segments. A point where
/// a mesh edge merely cuts the curve has no wedge. Takes time in proportion to the segments and to
/// the faces around their ends.
///
/// \param progress called now and then with the fraction done; returning false throws Aborted.
SourceWindows makeSourceWindows(const TriangleMesh& mesh, const std::vector<SourceCurve>& curves,
  const ProgressCallback& progress = {});

}

#endif
