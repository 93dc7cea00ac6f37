// SPDX-License-Identifier: BSD-3-Clause
#include "front/PseudoSource.h"

#include "source/LeavingWindow.h"

namespace geodesic
{

Emission emissionOf(TriangleMesh::PseudoSource kind)
{
  switch (kind)
  {
    case TriangleMesh::PseudoSource::Saddle:
      return Emission::Shadow;
    case TriangleMesh::PseudoSource::Irregular:
      return Emission::Everywhere;
    default:
      return Emission::Nothing;
  }
}

void findEmittedIntervals(const TriangleMesh& mesh, Id vertex, Emission emission,
  const Arrival& arrival, std::vector<EmittedInterval>& intervals)
{
  if (emission == Emission::Shadow && findSaddleWedge(mesh, vertex, arrival, intervals))
  {
    return;
  }
  intervals.clear();
  if (emission != Emission::Nothing)
  {
    for (const Id corner : mesh.cornersAt(vertex))
    {
      intervals.push_back({ corner, 0.0, mesh.length(TriangleMesh::nextInFace(corner)) });
    }
  }
}

Window emittedWindow(const TriangleMesh& mesh, const EmittedInterval& interval, double sigma)
{
  const double length = mesh.length(TriangleMesh::nextInFace(interval.corner));
  Window window = vertexWindow(mesh, interval.corner, sigma).window;
  window.begin = length - interval.end;
  window.end = length - interval.begin;
  window.origin = mesh.origin(interval.corner);
  return window;
}

}
