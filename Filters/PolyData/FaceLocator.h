// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceLocator_h
#define geodesic_FaceLocator_h

#include "Progress.h"
#include "mesh/TriangleMesh.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkGenericCell;
class vtkPoints;
class vtkStaticCellLocator;

namespace geodesic
{

/// Finds the closest face by vtkStaticCellLocator: one for each part of the faces, so that there is
/// progress to tell while they are built.
class FaceLocator
{
public:
  /// \param mesh must outlive the locator.
  /// \param progress called after each part; returning false throws Aborted.
  FaceLocator(const TriangleMesh& mesh, const ProgressCallback& progress);
  ~FaceLocator();

  /// The face with the closest point of the surface to a point. Not thread-safe.
  Id closest(const Vec3& point);

private:
  void addPart(vtkPoints* points, Id first, Id last);
  void tryFace(Id face, const Vec3& point);

  const TriangleMesh& mesh_;
  std::vector<vtkSmartPointer<vtkStaticCellLocator>> parts_;
  /// Some faces all over the surface: how far they are is a bound to begin the search with.
  std::vector<Id> samples_;
  /// Faces without area, which VTK's locator passes over.
  std::vector<Id> zeroAreaFaces_;
  vtkNew<vtkGenericCell> cell_;
  /// The best so far.
  Id face_ = NoId;
  double distance_ = Infinity;
};

}

#endif
