// SPDX-License-Identifier: BSD-3-Clause
#include "truth/MeshFiles.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <istream>
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

std::string testName(const std::string& file)
{
  std::string name = file.substr(0, file.find('.'));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

namespace
{

/// Gathers a mesh from a file's points and polygons; points at one place become one.
class MeshOfFile
{
public:
  void addPoint(const Vec3& p)
  {
    const auto [found, isNew] =
      this->vertexAt_.emplace(p, static_cast<Index>(this->mesh_.points.size()));
    if (isNew)
    {
      this->mesh_.points.push_back(p);
    }
    this->vertexOf_.push_back(found->second);
  }
  void addTriangle(std::size_t a, std::size_t b, std::size_t c)
  {
    const Triangle t = { this->vertexOf_.at(a), this->vertexOf_.at(b), this->vertexOf_.at(c) };
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
    {
      this->mesh_.triangles.push_back(t);
    }
  }
  void addPolygon(const std::vector<std::size_t>& points)
  {
    for (std::size_t i = 2; i < points.size(); ++i)
    {
      this->addTriangle(points[0], points[i - 1], points[i]);
    }
  }
  PlainMesh mesh() const { return compacted(this->mesh_); }

private:
  PlainMesh mesh_;
  std::map<Vec3, Index> vertexAt_;
  std::vector<Index> vertexOf_;
};

PlainMesh readObj(std::istream& file)
{
  MeshOfFile mesh;
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
      mesh.addPoint(p);
    }
    else if (key == "f")
    {
      std::vector<std::size_t> corners;
      while (words >> key)
      {
        corners.push_back(std::stoul(key) - 1);
      }
      mesh.addPolygon(corners);
    }
  }
  return mesh.mesh();
}

/// The next number of a binary file, little endian as the file and the machine are.
template <typename Number>
Number next(std::istream& file)
{
  std::array<char, sizeof(Number)> bytes{};
  file.read(bytes.data(), bytes.size());
  Number number{};
  std::memcpy(&number, bytes.data(), bytes.size());
  return number;
}

/// The strip's triangles turn alternately; a negative index begins another strip.
void addStrip(MeshOfFile& mesh, const std::vector<std::int32_t>& strip)
{
  std::size_t begin = 0;
  for (std::size_t i = 0; i < strip.size(); ++i)
  {
    if (strip[i] < 0)
    {
      begin = i + 1;
    }
    else if (i >= begin + 2)
    {
      const bool turned = (i - begin) % 2 == 1;
      const auto point = [&](std::size_t k) { return static_cast<std::size_t>(strip[k]); };
      mesh.addTriangle(point(turned ? i - 1 : i - 2), point(turned ? i - 2 : i - 1), point(i));
    }
  }
}

/// How many elements of a kind a PLY file has, and their properties in one line each.
struct PlyElement
{
  std::string name;
  std::size_t count = 0;
  std::vector<std::string> properties;
};

/// Empty where the format is none that is read here.
std::vector<PlyElement> readPlyHeader(std::istream& file)
{
  std::vector<PlyElement> elements;
  std::string line;
  bool isLittleEndian = false;
  while (std::getline(file, line) && line != "end_header")
  {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "element")
    {
      elements.emplace_back();
      words >> elements.back().name >> elements.back().count;
    }
    else if (key == "property" && !elements.empty())
    {
      elements.back().properties.push_back(line);
    }
    isLittleEndian = isLittleEndian || line == "format binary_little_endian 1.0";
  }
  return isLittleEndian ? elements : std::vector<PlyElement>();
}

/// Points as three floats, then strips of triangles: the form in which scanned surfaces come.
PlainMesh readPly(std::istream& file)
{
  const std::vector<PlyElement> elements = readPlyHeader(file);
  const std::vector<std::string> coordinates = { "property float x", "property float y",
    "property float z" };
  const std::vector<std::string> strips = { "property list int int vertex_indices" };
  if (elements.size() != 2 || elements[0].name != "vertex" ||
    elements[0].properties != coordinates || elements[1].name != "tristrips" ||
    elements[1].properties != strips)
  {
    return {};
  }
  MeshOfFile mesh;
  for (std::size_t i = 0; i < elements[0].count && file; ++i)
  {
    const float x = next<float>(file);
    const float y = next<float>(file);
    const float z = next<float>(file);
    mesh.addPoint({ x, y, z });
  }
  for (std::size_t i = 0; i < elements[1].count && file; ++i)
  {
    std::vector<std::int32_t> strip;
    for (auto left = next<std::int32_t>(file); left > 0 && file; --left)
    {
      strip.push_back(next<std::int32_t>(file));
    }
    addStrip(mesh, strip);
  }
  return file ? mesh.mesh() : PlainMesh();
}

}

PlainMesh readMesh(const std::string& name)
{
  std::ifstream file(meshFolder() + "/" + name, std::ios::binary);
  const std::string ending = ".ply";
  const bool isPly = name.size() > ending.size() &&
    name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
  return isPly ? readPly(file) : readObj(file);
}

}
