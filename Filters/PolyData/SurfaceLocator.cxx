// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/SurfaceLocator.h"

#include "vtkBoundingBox.h"

#include <algorithm>
#include <numeric>

namespace geodesic
{

std::vector<Id> SurfaceLocator::facesWithCornersAt(const std::vector<Vec3>& points) const
{
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(),
    [&points](std::size_t a, std::size_t b) { return points[a] < points[b]; });
  std::vector<Id> faces(points.size(), NoId);
  vtkBoundingBox box;
  for (const Vec3& p : points)
  {
    box.AddPoint(p[0], p[1], p[2]);
  }
  for (Id vertex = 0; vertex < this->mesh_.numberOfVertices(); ++vertex)
  {
    const Vec3& p = this->mesh_.point(vertex);
    const IdRange corners = this->mesh_.cornersAt(vertex);
    if (!box.ContainsPoint(p[0], p[1], p[2]) || corners.size() == 0)
    {
      continue;
    }
    auto at = std::lower_bound(order.begin(), order.end(), p,
      [&points](std::size_t i, const Vec3& q) { return points[i] < q; });
    for (; at != order.end() && points[*at] == p; ++at)
    {
      faces[*at] = TriangleMesh::faceOf(*corners.begin());
    }
  }
  return faces;
}

void SurfaceLocator::build(const ProgressCallback& progress)
{
  if (!this->faces_)
  {
    this->faces_ = std::make_unique<FaceLocator>(this->mesh_, progress);
  }
}

}
