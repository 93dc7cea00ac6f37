// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_LineWriter_h
#define geodesic_LineWriter_h

#include "Job.h"
#include "PolyData/PowerOfTwoScale.h"
#include "contours/Isolines.h"
#include "paths/PathsToSource.h"
#include "source/SourceCurve.h"

#include "vtkType.h"

#include <cstddef>
#include <vector>

class vtkPolyData;

namespace geodesic
{

struct Sources;

/// The curves as cells: a polyline each, a vertex where a curve is one point. The cell array
/// SourceId has the id of each.
///
/// \param arcLengths for the point array SourceArcLength, those of each curve's points; or empty.
void writeCurves(const TriangleMesh& mesh, const PowerOfTwoScale& scale, const Sources& sources,
  const std::vector<std::vector<double>>& arcLengths, vtkPolyData* output);

/// Lines on a mesh, with their values in the user's units.
struct WrittenIsolines
{
  const TriangleMesh& mesh;
  const Isolines& isolines;
  const std::vector<double>& values;
  /// The source, put out as the lines of the value 0, on its own mesh: a polyline a curve, a vertex
  /// where a curve is one point.
  const TriangleMesh& meshOfCurves;
  std::vector<SourceCurve> curves;
};

/// Gives an output lines as polylines that share points, with the value of each as cell and point
/// array `GeodesicDistance`, the active scalars.
void writeIsolines(
  const WrittenIsolines& lines, const PowerOfTwoScale& scale, vtkPolyData* output, const Job& job);

/// A path of a target, by places in space on the mesh's scale.
struct PathOfTarget
{
  /// Number of the target.
  std::size_t target = 0;
  double snapDistance = 0.0;
  std::vector<Vec3> points;
  PathEnd end;
  vtkIdType sourceId = -1;
  /// The input's cell between each point and the next, if cells are asked for; see
  /// PolyDataSurface::inputCellsOf().
  std::vector<vtkIdType> cells;
};

/// Which arrays about paths are asked for.
struct PathArrayChoice
{
  bool arcLengths = false;
  bool angles = false;
  bool cells = false;
};

/// Gives an output a polyline for each path, with the cell arrays TargetId, SourceId,
/// GeodesicDistance (its length), TargetSnapDistance and, if they are asked for, SourceArcLength
/// and SourceAngle, and the point arrays GeodesicDistance, which is what is left to go, and FaceId.
///
/// \param paths in the order of their targets.
/// \throws MeshError where a length is larger than numbers can be.
void writePaths(const PowerOfTwoScale& scale, const std::vector<PathOfTarget>& paths,
  const PathArrayChoice& choice, vtkPolyData* output, const Job& job);

}

#endif
