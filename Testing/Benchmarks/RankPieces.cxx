// SPDX-License-Identifier: BSD-3-Clause
#include "RankPieces.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <unordered_map>
#include <utility>

namespace
{

/// Spreads the lower 21 bits so that two zeros are between each.
std::uint64_t spread(std::uint64_t bits)
{
  bits = (bits | bits << 32) & 0x1f00000000ffffU;
  bits = (bits | bits << 16) & 0x1f0000ff0000ffU;
  bits = (bits | bits << 8) & 0x100f00f00f00f00fU;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3U;
  return (bits | bits << 2) & 0x1249249249249249U;
}

std::uint64_t mortonCode(const geodesic::Vec3& p, const double* bounds)
{
  constexpr double cells = 2097151.0;
  std::uint64_t code = 0;
  for (unsigned int k = 0; k < 3; ++k)
  {
    const double extent = bounds[2 * k + 1] - bounds[2 * k];
    const double fraction = extent > 0.0 ? (p[k] - bounds[2 * k]) / extent : 0.0;
    code |= spread(static_cast<std::uint64_t>(fraction * cells)) << k;
  }
  return code;
}

std::string fileOf(const std::string& prefix, int number)
{
  return prefix + "_" + std::to_string(number) + ".piece";
}

template <typename Value>
void writeAll(std::ostream& file, const std::vector<Value>& values)
{
  const std::uint64_t count = values.size();
  file.write(reinterpret_cast<const char*>(&count), sizeof(count));
  file.write(reinterpret_cast<const char*>(values.data()),
    static_cast<std::streamsize>(count * sizeof(Value)));
}

template <typename Value>
void readAll(std::istream& file, std::vector<Value>& values)
{
  std::uint64_t count = 0;
  file.read(reinterpret_cast<char*>(&count), sizeof(count));
  values.resize(file ? count : 0);
  file.read(
    reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(Value)));
}

}

std::vector<RankPiece> cutIntoPieces(vtkPolyData* mesh, int numberOfPieces)
{
  std::vector<geodesic::Triangle> triangles;
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  const auto cells = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(size, ids);
    geodesic::Triangle triangle;
    geodesic::Vec3 centre = {};
    for (vtkIdType k = 0; k < 3; ++k)
    {
      triangle[static_cast<std::size_t>(k)] = static_cast<geodesic::Id>(ids[k]);
      double p[3];
      mesh->GetPoint(ids[k], p);
      for (std::size_t i = 0; i < 3; ++i)
      {
        centre[i] += p[i] / 3.0;
      }
    }
    order.emplace_back(mortonCode(centre, mesh->GetBounds()), triangles.size());
    triangles.push_back(triangle);
  }
  std::sort(order.begin(), order.end());

  std::vector<RankPiece> pieces(static_cast<std::size_t>(numberOfPieces));
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    RankPiece& piece = pieces[i];
    std::unordered_map<geodesic::Id, geodesic::Id> pointOf;
    const std::size_t end = (i + 1) * order.size() / pieces.size();
    for (std::size_t j = i * order.size() / pieces.size(); j < end; ++j)
    {
      geodesic::Triangle triangle = triangles[order[j].second];
      for (geodesic::Id& corner : triangle)
      {
        const auto found =
          pointOf.try_emplace(corner, static_cast<geodesic::Id>(piece.points.size()));
        if (found.second)
        {
          geodesic::Vec3 p;
          mesh->GetPoint(static_cast<vtkIdType>(corner), p.data());
          piece.points.push_back(p);
          piece.keys.push_back(corner);
        }
        corner = found.first->second;
      }
      piece.triangles.push_back(triangle);
    }
  }
  return pieces;
}

void writePiece(
  const std::string& prefix, int number, const RankPiece& piece, const RankSource& source)
{
  std::ofstream file(fileOf(prefix, number), std::ios::binary);
  writeAll(file, piece.points);
  writeAll(file, piece.triangles);
  writeAll(file, piece.keys);
  writeAll(file, std::vector<std::uint8_t>{ static_cast<std::uint8_t>(source.isBoundary) });
  writeAll(file, source.points);
  if (!file.flush())
  {
    throw std::runtime_error(fileOf(prefix, number) + " could not be written");
  }
}

void readPiece(const std::string& prefix, int number, RankPiece& piece, RankSource& source)
{
  std::ifstream file(fileOf(prefix, number), std::ios::binary);
  std::vector<std::uint8_t> isBoundary;
  readAll(file, piece.points);
  readAll(file, piece.triangles);
  readAll(file, piece.keys);
  readAll(file, isBoundary);
  readAll(file, source.points);
  if (!file || isBoundary.size() != 1)
  {
    throw std::runtime_error(fileOf(prefix, number) + " could not be read");
  }
  source.isBoundary = isBoundary[0] != 0;
}
