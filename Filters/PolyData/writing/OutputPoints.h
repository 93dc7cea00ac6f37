// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_OutputPoints_h
#define geodesic_OutputPoints_h

#include "Job.h"
#include "PolyData/reading/PolyDataSurface.h"
#include "refinement/RefinedMesh.h"

#include "vtkSmartPointer.h"

#include <algorithm>
#include <vector>

class vtkPoints;

namespace geodesic
{

/// How far points of an output are from their places on the mesh, at most, on the mesh's scale.
///
/// This adds to RefinedMesh::errorBound. Let q be a point of a triangle of the refined mesh, q' the
/// same mean of the corners as they are stored, and c the point closest to q' of the face that the
/// triangle is a part of. Faces are convex, so |cq| <= |q'q|, which is no more than the largest
/// displacement of a corner, and the distance changes by no more than |cq| from q to c. So the
/// interpolant at q' differs from the distance at c by no more than errorBound + displacement.
struct Displacements
{
  /// How far the input's points are displaced: they are rounded if single precision is asked for,
  /// and away from their vertex if they were joined with others.
  double ofInputPoints = 0.0;
  /// The same of the points that refinement adds.
  double ofNewPoints = 0.0;

  double largest() const { return std::max(this->ofInputPoints, this->ofNewPoints); }
};

/// All ranks that share the surface call this together.
///
/// \param inputs the blocks that the surface was read from.
/// \param precision vtkAlgorithm::DesiredOutputPrecision.
Displacements displacementsOfPoints(const PolyDataSurface& surface,
  const std::vector<PolyDataBlock>& inputs, int precision, const Job& job);

/// \throws MeshError if coordinates are too large for this precision.
void requireRangeOf(int precision, const PolyDataSurface& surface);

/// VTK's type of the points of an output.
///
/// \param input its points; may be null.
/// \param hasNewPoints whether refinement has added some.
int typeOfPoints(vtkPoints* input, int precision, bool hasNewPoints);

/// The points of an output: those of the input, then those that refinement has added. If that is
/// what the input has, it is the input's object, or null.
///
/// \param scale of the new points.
vtkSmartPointer<vtkPoints> storePoints(vtkPoints* input, int type,
  const std::vector<RefinedPoint>& added, const PowerOfTwoScale& scale, const Job& job = {});

}

#endif
