// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkPeers.h"

#include "vtkDijkstraGraphGeodesicPath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#ifdef GEODESIC_HAS_FAST_MARCHING
#include "vtkFastMarchingGeodesicDistance.h"
#include "vtkIdList.h"
#endif

#ifdef GEODESIC_HAS_CGAL
#include "BenchmarkCgal.h"
#endif

#include <algorithm>
#include <chrono>
#include <functional>
#include <utility>

namespace
{

template <typename Filter>
double secondsOfUpdate(Filter* filter)
{
  const auto start = std::chrono::steady_clock::now();
  filter->Update();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// VTK's path along mesh edges. It visits all vertices where it does not stop at the end vertex.
double dijkstra(vtkPolyData* mesh, vtkIdType vertex)
{
  vtkNew<vtkDijkstraGraphGeodesicPath> filter;
  filter->SetInputData(mesh);
  filter->SetStartVertex(vertex);
  filter->SetEndVertex(vertex);
  filter->StopWhenEndReachedOff();
  return secondsOfUpdate(filter.Get());
}

#ifdef GEODESIC_HAS_FAST_MARCHING
/// ParaView's GeodesicMeasurement plugin.
double fastMarching(vtkPolyData* mesh, vtkIdType vertex)
{
  vtkNew<vtkFastMarchingGeodesicDistance> filter;
  vtkNew<vtkIdList> seeds;
  seeds->InsertNextId(vertex);
  filter->SetInputData(mesh);
  filter->SetSeeds(seeds);
  filter->SetFieldDataName("FastMarching");
  return secondsOfUpdate(filter.Get());
}
#endif

struct Peer
{
  std::string name;
  double (*seconds)(vtkPolyData*, vtkIdType);
};

const std::vector<Peer>& peers()
{
  static const std::vector<Peer> all = {
    { "dijkstra", dijkstra },
#ifdef GEODESIC_HAS_FAST_MARCHING
    { "fastmarching", fastMarching },
#endif
#ifdef GEODESIC_HAS_CGAL
    { "cgal", secondsOfCgal },
#endif
  };
  return all;
}

std::vector<Peer>::const_iterator find(const std::string& name)
{
  return std::find_if(
    peers().begin(), peers().end(), [&](const Peer& peer) { return peer.name == name; });
}

}

bool isPeer(const std::string& name)
{
  return find(name) != peers().end();
}

std::string peerNames()
{
  std::string names;
  for (const Peer& peer : peers())
  {
    names += (names.empty() ? "" : ",") + peer.name;
  }
  return names;
}

double secondsOfPeer(const std::string& name, vtkPolyData* mesh, vtkIdType vertex)
{
  return find(name)->seconds(mesh, vertex);
}
