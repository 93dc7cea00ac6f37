// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceCells_h
#define geodesic_SourceCells_h

#include "PolyData/PolyDataBlocks.h"
#include "mesh/MeshPartition.h"
#include "source/PolylineLocator.h"

#include "vtkType.h"

#include <string>
#include <vector>

namespace geodesic
{

struct PolyDataSurface;

/// A face of a source: a polygon, or a triangle of a strip.
struct SourceFace
{
  /// A closed polyline that is not located. LocatedPolyline::source is that of its region.
  LocatedPolyline outline;
  /// Its triangles, and what the outlines of regions are made of: see cutAtFacesWithoutArea().
  std::vector<Triangle> triangles = {};
  std::vector<LocatedPolyline> parts = {};
  /// The faces of the surface that it consists of, of all ranks; see placeFaces().
  std::vector<RankAddress> covered = {};
};

/// The sources, or sets of targets, that an input has.
struct PartIds
{
  /// Ascending; the `source` of a curve is the place of an id here. The number of a cell (of a
  /// point in a set of points) over all blocks, unless an array names them.
  std::vector<vtkIdType> ids;
  /// What each of these is called: as the first of its cells. Empty unless an array says so.
  std::vector<std::string> names;
  /// Whether an array has named them.
  bool areNamed = false;
  /// All ids are below.
  vtkIdType idEnd = 0;
};

/// The cells of a source, or of sets of targets, on the surface's scale. Cells are numbered over
/// all blocks in their order; in a block that is a set of points, points are.
struct SourceCells
{
  /// Lines, outlines of polygons that are no faces, and points of vertex cells;
  /// LocatedPolyline::source is the number of the cell, or point.
  std::vector<LocatedPolyline> polylines;
  /// Which of these are cells of two points.
  std::vector<std::size_t> lines;
  std::vector<SourceFace> faces;
  /// The numbers of all that belong to the source, ascending: not of a point that no vertex cell of
  /// a set of points has, but of a cell of a vtkPolyData without points, which has no polyline.
  std::vector<vtkIdType> numbers;
  std::vector<vtkIdType> withoutPoints;
  /// All of these are below.
  vtkIdType end = 0;
  /// The values of PolyDataBlock::sourceIds and partNames for each number; empty without an array.
  std::vector<vtkIdType> values;
  std::vector<std::string> names;
  /// Cells that are neither vertices, lines nor flat faces and were left out.
  vtkIdType droppedCells = 0;
  /// The relative precision of the coordinates: that of the least precise block.
  double precision = 0.0;
  /// By readParts(): what LocatedPolyline::source is the place of an id in, and where points are.
  PartIds parts = {};
  LocatedPlaces located = {};

  bool isEmpty() const { return this->polylines.empty() && this->faces.empty(); }
  /// What belongs together has one value.
  vtkIdType valueOf(vtkIdType number) const
  {
    return this->values.empty() ? number : this->values[static_cast<std::size_t>(number)];
  }
};

/// \param areTargets whether cells with a negative value do not count.
/// \throws InputError where a cell names a point that is missing, a point is not finite or too far
///         away, or a value is no id.
SourceCells readSourceCells(
  const std::vector<PolyDataBlock>& blocks, const PolyDataSurface& surface, bool areTargets);

/// The relative precision that the coordinates' type allows: that of the least precise block.
double coordinatePrecisionOf(const std::vector<PolyDataBlock>& blocks);

/// Adds a point of a block to a polyline, on the surface's scale. If the block says which of the
/// surface's points it is, and it lies there, it is this vertex.
void addPoint(const PolyDataBlock& block, vtkIdType point, const PolyDataSurface& surface,
  double coordinatePrecision, LocatedPolyline& line);

}

#endif
