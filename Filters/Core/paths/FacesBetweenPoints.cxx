// SPDX-License-Identifier: BSD-3-Clause
#include "paths/FacesBetweenPoints.h"

#include "mesh/SurfaceSnap.h"
#include "paths/PathCorridor.h"

#include <algorithm>
#include <utility>

namespace geodesic
{

namespace
{

using PointPair = std::pair<SurfacePoint, SurfacePoint>;

/// The pairs of places of two points that share no face.
std::vector<PointPair> farPairs(const TriangleMesh& mesh, const LocatedPolyline& polyline,
  std::size_t first, std::size_t second, double coordinatePrecision)
{
  std::vector<PointPair> pairs;
  const auto place = [&](Id face, std::size_t point)
  { return snapToFace(mesh, face, polyline.points[point], coordinatePrecision).place; };
  for (const Id a : polyline.faces[first])
  {
    for (const Id b : polyline.faces[second])
    {
      const PointPair pair = { place(a, first), place(b, second) };
      const auto isSame = [&](const PointPair& other) {
        return samePlace(mesh, pair.first, other.first) &&
          samePlace(mesh, pair.second, other.second);
      };
      if (commonFace(mesh, pair.first, pair.second) == NoId &&
        std::none_of(pairs.begin(), pairs.end(), isSame))
      {
        pairs.push_back(pair);
      }
    }
  }
  return pairs;
}

} // anonymous namespace

std::vector<Id> facesBetweenPoints(const MeshPartition& part, const ReplicatedPatch& patch,
  const std::vector<LocatedPolyline>& polylines, double coordinatePrecision, const Job& job)
{
  std::vector<Id> faces;
  for (std::size_t line = 0; line < polylines.size(); ++line)
  {
    const LocatedPolyline& polyline = polylines[line];
    const double done = static_cast<double>(line) / static_cast<double>(polylines.size());
    const Job search = job.part(done, done);
    const std::size_t count = polyline.points.size();
    for (std::size_t i = 0; i + 1 < count + (polyline.closed && count > 1 ? 1 : 0); ++i)
    {
      for (const PointPair& pair :
        farPairs(patch.mesh(), polyline, i, (i + 1) % count, coordinatePrecision))
      {
        const Corridor corridor = corridorTo(part, patch, pair.first, pair.second, nullptr, search);
        if (corridor.length < Infinity)
        {
          const std::vector<Id> passed =
            facesInCorridor(part, patch, pair.second, corridor, search);
          faces.insert(faces.end(), passed.begin(), passed.end());
        }
      }
    }
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}
