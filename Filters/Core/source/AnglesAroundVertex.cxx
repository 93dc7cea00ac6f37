// SPDX-License-Identifier: BSD-3-Clause
#include "source/AnglesAroundVertex.h"

#include "Tolerance.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// Whether one of a corner's edges is short (tolerance::ShortEdge).
bool hasShortEdge(const TriangleMesh& mesh, Id corner)
{
  const double shortest =
    std::min(mesh.length(corner), mesh.length(TriangleMesh::previousInFace(corner)));
  return shortest < tolerance::ShortEdge * mesh.shape(TriangleMesh::faceOf(corner)).longest();
}

/// The corner at the vertex to which one of the vertex's halfedges belongs.
Id cornerOf(const TriangleMesh& mesh, Id vertex, Id halfedge)
{
  return mesh.origin(halfedge) == vertex ? halfedge : TriangleMesh::nextInFace(halfedge);
}

bool isFarther(const EdgeAngle& a, const EdgeAngle& b)
{
  return a.angle != b.angle ? a.angle > b.angle : a.halfedge > b.halfedge;
}

} // anonymous namespace

void AnglesAroundVertex::push(const EdgeAngle& leaving)
{
  this->queue_.push_back(leaving);
  std::push_heap(this->queue_.begin(), this->queue_.end(), isFarther);
}

EdgeAngle AnglesAroundVertex::pop()
{
  std::pop_heap(this->queue_.begin(), this->queue_.end(), isFarther);
  const EdgeAngle nearest = this->queue_.back();
  this->queue_.pop_back();
  return nearest;
}

// The corners at a vertex ascend.
AnglesAroundVertex::State& AnglesAroundVertex::state(
  const TriangleMesh& mesh, Id vertex, Id halfedge)
{
  const IdRange corners = mesh.cornersAt(vertex);
  const Id corner = cornerOf(mesh, vertex, halfedge);
  const auto index = static_cast<std::size_t>(
    std::lower_bound(corners.begin(), corners.end(), corner) - corners.begin());
  return this->states_[2 * index + (corner == halfedge ? 0 : 1)];
}

const std::vector<EdgeAngle>& AnglesAroundVertex::find(
  const TriangleMesh& mesh, Id vertex, const std::vector<EdgeAngle>& leaving, double limit)
{
  this->entered_.clear();
  this->queue_.clear();
  this->states_.assign(2 * mesh.cornersAt(vertex).size(), State());
  for (const EdgeAngle& start : leaving)
  {
    this->push(start);
  }
  while (!this->queue_.empty())
  {
    const EdgeAngle nearest = this->pop();
    if (!(nearest.angle < limit))
    {
      break;
    }
    this->cross(mesh, vertex, nearest);
  }
  return this->entered_;
}

// The first way across an edge enters all its faces except the one that it leaves; the first later
// way from another face enters that one. Any other way would enter at a larger angle.
void AnglesAroundVertex::cross(const TriangleMesh& mesh, Id vertex, const EdgeAngle& leaving)
{
  const Id first = this->state(mesh, vertex, leaving.halfedge).firstLeft;
  if (first == NoId)
  {
    this->state(mesh, vertex, leaving.halfedge).firstLeft = leaving.halfedge;
    for (Id s = mesh.nextSibling(leaving.halfedge); s != leaving.halfedge; s = mesh.nextSibling(s))
    {
      this->state(mesh, vertex, s).firstLeft = leaving.halfedge;
      this->enter(mesh, vertex, { s, leaving.angle });
    }
  }
  else if (first != leaving.halfedge && !this->state(mesh, vertex, first).isEntered)
  {
    this->enter(mesh, vertex, { first, leaving.angle });
  }
}

void AnglesAroundVertex::enter(const TriangleMesh& mesh, Id vertex, const EdgeAngle& entering)
{
  this->state(mesh, vertex, entering.halfedge).isEntered = true;
  this->entered_.push_back(entering);
  const Id corner = cornerOf(mesh, vertex, entering.halfedge);
  const Id across = corner == entering.halfedge ? TriangleMesh::previousInFace(corner) : corner;
  if (hasShortEdge(mesh, corner))
  {
    return;
  }
  this->push({ across, entering.angle + mesh.cornerAngle(corner) });
}

}
