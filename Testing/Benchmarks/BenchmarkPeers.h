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

/// Seconds that a fresh filter takes for the distances of all vertices from one vertex.
double secondsOfPeer(const std::string& name, vtkPolyData* mesh, vtkIdType vertex);

#endif
