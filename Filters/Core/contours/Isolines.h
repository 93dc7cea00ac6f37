// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Isolines_h
#define geodesic_Isolines_h

#include "field/DistanceField.h"

#include <vector>

namespace geodesic
{

struct IsolineOptions
{
  /// The values, positive and finite, ascending, each once, in the surface's units.
  std::vector<double> values;
  /// The largest distance of a chord from its arc, in the surface's units, positive.
  double chordTolerance = 0.0;
  /// The result does not depend on its threads.
  Job job;
};

/// One line of equal distance.
struct Isoline
{
  /// Which of the values.
  std::size_t value;
  /// Numbers of its points, at least two. A closed line has its first point again at the end.
  std::vector<Id> points;
  /// The face of each chord; one fewer than points.
  std::vector<Id> faces;

  bool isClosed() const { return this->points.front() == this->points.back(); }
};

/// Lines of equal distance: offset curves of the source.
struct Isolines
{
  /// Each lies on an edge or in a face. Lines that meet share a point.
  std::vector<SurfacePoint> points;
  /// By value, then in the order of the faces. The distance grows to the left of a line, seen with
  /// the normals of the faces towards the viewer.
  std::vector<Isoline> lines;
  /// The number of lines that cross faces of opposite orientation, so that their direction has no
  /// meaning.
  std::size_t linesWithoutDirection = 0;
};

/// Draws the isolines of a field: in each face arcs around unfolded sources and straight pieces,
/// with corners where two paths are equally long (paper, sections 3.3 and 4.2.2, in the face
/// instead of on its edges). All points are exactly at the value, and no interpolant is used.
///
/// Lines end at the boundary, and at edges of three and more faces, where they share a point. A
/// vertex at exactly the value counts as beyond it. Values over the largest distance give no lines.
///
/// All ranks draw together, each in the faces that it owns. Lines end at seams; there a line of
/// another rank continues from a point with the same coordinates.
///
/// \param field made by solveForIsolines() for these values, or with all windows kept.
/// \throws Error if the values or the tolerance are invalid, or windows that are needed were not
///         kept; Aborted.
Isolines drawIsolines(const DistanceField& field, const IsolineOptions& options);

}

#endif
