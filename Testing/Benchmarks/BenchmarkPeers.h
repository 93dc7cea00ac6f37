// SPDX-License-Identifier: BSD-3-Clause
#ifndef BenchmarkPeers_h
#define BenchmarkPeers_h

#include "vtkType.h"

#include <string>
#include <vector>

class vtkPolyData;

/// What to compare with; see peerNames().
bool isPeer(const std::string& name);

/// The peers that are built in, separated by commas.
std::string peerNames();

struct PeerRun
{
  /// Of a fresh filter's Update(), or what comes nearest to it.
  double seconds = 0.0;
  /// Of each point.
  std::vector<double> distances;
};

/// The distances of all points from one of them.
PeerRun runPeer(const std::string& name, vtkPolyData* mesh, vtkIdType vertex);

#endif
