// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkCgal.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

namespace
{

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>;
using ShortestPath = CGAL::Surface_mesh_shortest_path<Traits>;

Mesh toMesh(vtkPolyData* data)
{
  Mesh mesh;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    const double* p = data->GetPoint(i);
    mesh.add_vertex({ p[0], p[1], p[2] });
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < data->GetNumberOfPolys(); ++i)
  {
    data->GetPolys()->GetCellAtId(i, ids);
    const auto vertex = [&](vtkIdType k)
    { return Mesh::Vertex_index(static_cast<Mesh::size_type>(ids->GetId(k))); };
    if (mesh.add_face(vertex(0), vertex(1), vertex(2)) == Mesh::null_face())
    {
      throw std::runtime_error("--against cgal: CGAL takes oriented manifolds only");
    }
  }
  return mesh;
}

}

double secondsOfCgal(vtkPolyData* data, vtkIdType vertex, std::vector<double>& distances)
{
  const Mesh mesh = toMesh(data);
  distances.clear();
  distances.reserve(mesh.number_of_vertices());
  const auto start = std::chrono::steady_clock::now();
  ShortestPath paths(mesh);
  paths.add_source_point(Mesh::Vertex_index(static_cast<Mesh::size_type>(vertex)));
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    distances.push_back(paths.shortest_distance_to_source_points(v).first);
  }
  const double seconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!(*std::max_element(distances.begin(), distances.end()) > 0.0))
  {
    throw std::runtime_error("--against cgal: CGAL has found no distance");
  }
  return seconds;
}
