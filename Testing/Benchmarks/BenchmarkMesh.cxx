// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkMesh.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCleanPolyData.h"
#include "vtkLoopSubdivisionFilter.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkOBJWriter.h"
#include "vtkPLYReader.h"
#include "vtkPLYWriter.h"
#include "vtkPoints.h"
#include "vtkSTLReader.h"
#include "vtkSTLWriter.h"
#include "vtkTriangleFilter.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <random>
#include <stdexcept>
#include <vector>

namespace
{

std::string extensionOf(const std::string& file)
{
  const std::size_t dot = file.rfind('.');
  return dot == std::string::npos ? "" : file.substr(dot + 1);
}

[[noreturn]] void refuse(const std::string& file)
{
  throw std::runtime_error(file + ": the name must end in obj, ply, stl or vtp");
}

template <typename Reader>
vtkSmartPointer<vtkPolyData> readWith(const std::string& file)
{
  vtkNew<Reader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  return reader->GetOutput();
}

/// The lines of a PLY file up to end_header, joined by single spaces.
std::string plyHeader(std::istream& file)
{
  std::string header;
  for (std::string line; std::getline(file, line) && header.size() < 10000;)
  {
    header += line.substr(0, line.find('\r')) + ' ';
    if (line.compare(0, 10, "end_header") == 0)
    {
      return header;
    }
  }
  return "";
}

/// Reads binary numbers of this machine's byte order.
template <typename Number>
std::vector<Number> readNumbers(std::istream& file, std::size_t count)
{
  std::vector<Number> numbers(count);
  file.read(
    reinterpret_cast<char*>(numbers.data()), static_cast<std::streamsize>(count * sizeof(Number)));
  if (!file)
  {
    throw std::runtime_error("the PLY file ends too early");
  }
  return numbers;
}

/// PLY files of the Stanford 3D Scanning Repository hold one list of triangle strips, separated by
/// -1, which vtkPLYReader passes over. Returns null for any other file.
vtkSmartPointer<vtkPolyData> readStripsOfPly(const std::string& name)
{
  std::ifstream file(name, std::ios::binary);
  const std::string header = plyHeader(file);
  const std::string begin = "ply format binary_little_endian 1.0 element vertex ";
  const std::string end = " property float x property float y property float z element tristrips 1 "
                          "property list int int vertex_indices end_header ";
  if (header.compare(0, begin.size(), begin) != 0 || header.size() < begin.size() + end.size() ||
    header.compare(header.size() - end.size(), end.size(), end) != 0)
  {
    return nullptr;
  }
  const std::size_t count = std::stoull(header.substr(begin.size()));
  const auto coordinates = readNumbers<float>(file, 3 * count);
  const auto length = readNumbers<std::int32_t>(file, 1).front();
  auto ids = readNumbers<std::int32_t>(file, static_cast<std::size_t>(std::max(length, 0)));
  ids.push_back(-1);

  vtkNew<vtkPoints> points;
  for (std::size_t i = 0; i < count; ++i)
  {
    points->InsertNextPoint(&coordinates[3 * i]);
  }
  vtkNew<vtkCellArray> strips;
  std::vector<vtkIdType> strip;
  for (const std::int32_t id : ids)
  {
    if (id >= 0)
    {
      strip.push_back(id);
    }
    else if (!strip.empty())
    {
      strips->InsertNextCell(static_cast<vtkIdType>(strip.size()), strip.data());
      strip.clear();
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetStrips(strips);
  return mesh;
}

template <typename Writer>
void writeWith(Writer* writer, vtkPolyData* mesh, const std::string& file)
{
  writer->SetInputData(mesh);
  writer->SetFileName(file.c_str());
  if (!writer->Write())
  {
    throw std::runtime_error(file + " cannot be written");
  }
}

double meanEdgeLength(vtkPolyData* mesh)
{
  double sum = 0.0;
  const auto iterator = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(size, ids);
    for (vtkIdType k = 0; k < size; ++k)
    {
      double a[3];
      double b[3];
      mesh->GetPoint(ids[k], a);
      mesh->GetPoint(ids[(k + 1) % size], b);
      sum += std::sqrt(vtkMath::Distance2BetweenPoints(a, b)) / static_cast<double>(size);
    }
  }
  return sum / static_cast<double>(mesh->GetNumberOfPolys());
}

}

vtkSmartPointer<vtkPolyData> readMesh(const std::string& file)
{
  if (!std::ifstream(file))
  {
    throw std::runtime_error(file + " cannot be opened");
  }
  const std::string extension = extensionOf(file);
  if (extension == "obj")
  {
    return readWith<vtkOBJReader>(file);
  }
  if (extension == "ply")
  {
    const vtkSmartPointer<vtkPolyData> strips = readStripsOfPly(file);
    return strips ? strips : readWith<vtkPLYReader>(file);
  }
  if (extension == "stl")
  {
    return readWith<vtkSTLReader>(file);
  }
  if (extension == "vtp")
  {
    return readWith<vtkXMLPolyDataReader>(file);
  }
  refuse(file);
}

vtkSmartPointer<vtkPolyData> plainTriangles(vtkPolyData* mesh)
{
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(mesh->GetPoints());
  bare->SetPolys(mesh->GetPolys());
  bare->SetStrips(mesh->GetStrips());
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(bare);
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputConnection(triangles->GetOutputPort());
  clean->SetTolerance(0.0);
  clean->ConvertLinesToPointsOff();
  clean->ConvertPolysToLinesOff();
  clean->Update();
  return clean->GetOutput();
}

vtkSmartPointer<vtkPolyData> subdivide(vtkPolyData* mesh, int levels)
{
  vtkNew<vtkLoopSubdivisionFilter> loop;
  loop->SetInputData(mesh);
  loop->SetNumberOfSubdivisions(levels);
  loop->Update();
  if (loop->GetOutput()->GetNumberOfPolys() == 0)
  {
    throw std::runtime_error("the mesh cannot be subdivided");
  }
  return loop->GetOutput();
}

vtkSmartPointer<vtkPolyData> addNoise(vtkPolyData* mesh, double fraction)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->DeepCopy(mesh);
  const double size = fraction * meanEdgeLength(mesh);
  std::mt19937_64 random(2007);
  std::uniform_real_distribution<double> offset(-size, size);
  for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
  {
    double p[3];
    result->GetPoint(i, p);
    for (double& x : p)
    {
      x += offset(random);
    }
    result->GetPoints()->SetPoint(i, p);
  }
  return result;
}

void writeMesh(vtkPolyData* mesh, const std::string& file)
{
  const std::string extension = extensionOf(file);
  if (extension == "obj")
  {
    writeWith(vtkNew<vtkOBJWriter>().Get(), mesh, file);
  }
  else if (extension == "ply")
  {
    writeWith(vtkNew<vtkPLYWriter>().Get(), mesh, file);
  }
  else if (extension == "stl")
  {
    vtkNew<vtkSTLWriter> writer;
    writer->SetFileTypeToBinary();
    writeWith(writer.Get(), mesh, file);
  }
  else if (extension == "vtp")
  {
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer
      ->SetDataModeToBinary(); // the default, appended, is unreadable beside newer expat versions
    writeWith(writer.Get(), mesh, file);
  }
  else
  {
    refuse(file);
  }
}
