// SPDX-License-Identifier: BSD-3-Clause
#include "MeshFiles.h"

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <vector>

namespace geodesictest
{

std::string meshFolder()
{
  const char* folder = std::getenv("GEODESIC_TEST_MESHES");
  return folder ? folder : "";
}

std::string noMeshFolder(const std::string& wanted)
{
  return "GEODESIC_TEST_MESHES names no folder with " + wanted + ".";
}

PlainMesh readMesh(const std::string& name)
{
  PlainMesh mesh;
  std::ifstream file(meshFolder() + "/" + name);
  std::map<Vec3, Index> vertexAt;
  std::vector<Index> vertexOfLine;
  std::string line;
  while (std::getline(file, line))
  {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "v")
    {
      Vec3 p{};
      words >> p[0] >> p[1] >> p[2];
      const auto [found, isNew] = vertexAt.emplace(p, static_cast<Index>(mesh.points.size()));
      if (isNew)
      {
        mesh.points.push_back(p);
      }
      vertexOfLine.push_back(found->second);
    }
    else if (key == "f")
    {
      std::vector<Index> corners;
      while (words >> key)
      {
        corners.push_back(vertexOfLine.at(std::stoul(key) - 1));
      }
      for (std::size_t i = 2; i < corners.size(); ++i)
      {
        mesh.triangles.push_back({ corners[0], corners[i - 1], corners[i] });
      }
    }
  }
  return compacted(mesh);
}

}
