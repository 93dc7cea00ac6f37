// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkPeers.h"

#include "vtkDijkstraGraphGeodesicPath.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#ifdef GEODESIC_HAS_FAST_MARCHING
#include "vtkFastMarchingGeodesicDistance.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
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

std::vector<double> numbersOf(vtkDataArray* array)
{
  std::vector<double> numbers(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    numbers[i] = array->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  return numbers;
}

/// VTK's path along mesh edges. It visits all vertices where it does not stop at the end vertex.
PeerRun dijkstra(vtkPolyData* mesh, vtkIdType vertex)
{
  vtkNew<vtkDijkstraGraphGeodesicPath> filter;
  filter->SetInputData(mesh);
  filter->SetStartVertex(vertex);
  filter->SetEndVertex(vertex);
  filter->StopWhenEndReachedOff();
  PeerRun run;
  run.seconds = secondsOfUpdate(filter.Get());
  vtkNew<vtkDoubleArray> distances;
  filter->GetCumulativeWeights(distances);
  run.distances = numbersOf(distances);
  return run;
}

#ifdef GEODESIC_HAS_FAST_MARCHING
/// ParaView's GeodesicMeasurement plugin.
PeerRun fastMarching(vtkPolyData* mesh, vtkIdType vertex)
{
  vtkNew<vtkFastMarchingGeodesicDistance> filter;
  vtkNew<vtkIdList> seeds;
  seeds->InsertNextId(vertex);
  filter->SetInputData(mesh);
  filter->SetSeeds(seeds);
  filter->SetFieldDataName("FastMarching");
  PeerRun run;
  run.seconds = secondsOfUpdate(filter.Get());
  run.distances = numbersOf(filter->GetOutput()->GetPointData()->GetArray("FastMarching"));
  return run;
}
#endif

#ifdef GEODESIC_HAS_CGAL
PeerRun cgal(vtkPolyData* mesh, vtkIdType vertex)
{
  PeerRun run;
  run.seconds = secondsOfCgal(mesh, vertex, run.distances);
  return run;
}
#endif

struct Peer
{
  std::string name;
  PeerRun (*run)(vtkPolyData*, vtkIdType);
};

const std::vector<Peer>& peers()
{
  static const std::vector<Peer> all = {
    { "dijkstra", dijkstra },
#ifdef GEODESIC_HAS_FAST_MARCHING
    { "fastmarching", fastMarching },
#endif
#ifdef GEODESIC_HAS_CGAL
    { "cgal", cgal },
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

PeerRun runPeer(const std::string& name, vtkPolyData* mesh, vtkIdType vertex)
{
  return find(name)->run(mesh, vertex);
}
