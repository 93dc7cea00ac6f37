// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/RefinedPolyData.h"

#include "PolyData/ArrayMemory.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstring>

namespace geodesic
{

namespace
{

/// Takes the parts of one face over to another on the same vertices.
class FaceTwin
{
public:
  FaceTwin(const PolyDataSurface& surface, RefinedMesh& refined)
    : Surface(surface)
    , Refined(refined)
    , Numbering(refined)
  {
  }

  /// The face of the mesh on the triangle's vertices.
  Id faceLike(const Triangle& triangle) const
  {
    const TriangleMesh& mesh = this->Surface.mesh();
    Triangle wanted = this->vertices(triangle);
    std::sort(wanted.begin(), wanted.end());
    for (const Id corner : mesh.cornersAt(wanted[0]))
    {
      Triangle there = mesh.triangle(TriangleMesh::faceOf(corner));
      std::sort(there.begin(), there.end());
      if (there == wanted)
      {
        return TriangleMesh::faceOf(corner);
      }
    }
    return NoId;
  }

  void begin(Id face, const Triangle& triangle)
  {
    const Triangle& vertices = this->Surface.mesh().triangle(face);
    const Triangle own = this->vertices(triangle);
    this->from_ = this->Surface.cornerPoints(face);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const auto place = std::find(own.begin(), own.end(), vertices[k]) - own.begin();
      this->to_[k] = triangle[static_cast<std::size_t>(place)];
    }
    const std::size_t first = this->to_[0] == triangle[0] ? 0 : this->to_[0] == triangle[1] ? 1 : 2;
    this->flipped_ = this->to_[1] != triangle[(first + 1) % 3];
  }

  Triangle partLike(const Triangle& part)
  {
    Triangle result;
    for (std::size_t k = 0; k < 3; ++k)
    {
      result[k] = this->pointLike(part[k]);
    }
    if (this->flipped_)
    {
      std::swap(result[1], result[2]);
    }
    return result;
  }

private:
  Triangle vertices(const Triangle& triangle) const
  {
    return { this->Surface.vertexOf(triangle[0]), this->Surface.vertexOf(triangle[1]),
      this->Surface.vertexOf(triangle[2]) };
  }

  /// The same point, or one more beside it where the two faces have points of their own.
  Id pointLike(Id point)
  {
    const Id inputPoints = this->Refined.numberOfInputPoints;
    if (point < inputPoints)
    {
      const auto k = std::find(this->from_.begin(), this->from_.end(), point) - this->from_.begin();
      return this->to_[static_cast<std::size_t>(k)];
    }
    RefinedPoint copy = this->Refined.points[point - inputPoints];
    const std::array<Id, 2> parents = copy.parents;
    copy.parents = { this->pointLike(parents[0]), this->pointLike(parents[1]) };
    if (copy.parents == parents)
    {
      return point;
    }
    return this->Numbering.numberOf(copy);
  }

  const PolyDataSurface& Surface;
  RefinedMesh& Refined;
  SplitPointNumbering Numbering;
  Triangle from_{};
  Triangle to_{};
  bool flipped_ = false;
};

/// Where the parts of each face begin among the refined triangles.
std::vector<Id> firstParts(const std::vector<Id>& faces, Id numberOfFaces)
{
  std::vector<Id> first(static_cast<std::size_t>(numberOfFaces) + 1, 0);
  for (const Id face : faces)
  {
    ++first[face + 1];
  }
  for (Id face = 0; face < numberOfFaces; ++face)
  {
    first[face + 1] += first[face];
  }
  return first;
}

/// The mesh's face for each triangle of the surface; for a duplicate that of the first one.
std::vector<Id> facesOfTriangles(const PolyDataSurface& surface, const FaceTwin& twin)
{
  const TriangleMesh& mesh = surface.mesh();
  std::vector<Id> faces(static_cast<std::size_t>(surface.numberOfTriangles()), NoId);
  for (Id face = 0; face < mesh.numberOfFaces(); ++face)
  {
    faces[mesh.inputFace(face)] = face;
  }
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    faces[i] = faces[i] == NoId ? twin.faceLike(surface.triangle(static_cast<Id>(i))) : faces[i];
  }
  return faces;
}

/// How a new point lies among the corners of the face around it.
struct Blend
{
  std::array<Id, 3> corners{};
  std::array<double, 3> weights{};
  std::size_t count = 0;

  void add(Id corner, double weight)
  {
    const auto end = this->corners.begin() + static_cast<std::ptrdiff_t>(this->count);
    const auto k = static_cast<std::size_t>(
      std::find(this->corners.begin(), end, corner) - this->corners.begin());
    if (k == this->count)
    {
      this->corners[this->count++] = corner;
    }
    this->weights[k] += weight;
  }

  vtkIdType nearest() const
  {
    const auto end = this->weights.begin() + static_cast<std::ptrdiff_t>(this->count);
    const auto k = std::max_element(this->weights.begin(), end) - this->weights.begin();
    return this->corners[static_cast<std::size_t>(k)];
  }
};

std::vector<Blend> blendsOf(const RefinedMesh& refined)
{
  std::vector<Blend> blends(refined.points.size());
  for (std::size_t i = 0; i < blends.size(); ++i)
  {
    const RefinedPoint& point = refined.points[i];
    for (std::size_t k = 0; k < 2; ++k)
    {
      const double weight = k == 0 ? 1.0 - point.weight : point.weight;
      const Id parent = point.parents[k];
      if (parent < refined.numberOfInputPoints)
      {
        blends[i].add(parent, weight);
        continue;
      }
      const Blend& other = blends[parent - refined.numberOfInputPoints];
      for (std::size_t j = 0; j < other.count; ++j)
      {
        blends[i].add(other.corners[j], weight * other.weights[j]);
      }
    }
  }
  return blends;
}

void takeNearest(vtkAbstractArray* array, const std::vector<Blend>& blends, vtkIdType first,
  const LoopProgress& progress)
{
  for (std::size_t i = 0; i < blends.size(); ++i)
  {
    progress.at(i, blends.size());
    array->SetTuple(first++, blends[i].nearest(), array);
  }
}

void interpolate(vtkAbstractArray* array, const std::vector<Blend>& blends, vtkIdType first,
  const LoopProgress& progress)
{
  vtkNew<vtkIdList> corners;
  for (std::size_t i = 0; i < blends.size(); ++i)
  {
    progress.at(i, blends.size());
    const Blend& blend = blends[i];
    corners->SetNumberOfIds(static_cast<vtkIdType>(blend.count));
    for (std::size_t k = 0; k < blend.count; ++k)
    {
      corners->SetId(static_cast<vtkIdType>(k), blend.corners[k]);
    }
    std::array<double, 3> weights = blend.weights;
    array->InterpolateTuple(first++, corners, array, weights.data());
  }
}

void keepGhosts(vtkUnsignedCharArray* array, const std::vector<Blend>& blends, vtkIdType first)
{
  for (const Blend& blend : blends)
  {
    unsigned char flags = 0xff;
    for (std::size_t k = 0; k < blend.count; ++k)
    {
      flags = static_cast<unsigned char>(flags & array->GetValue(blend.corners[k]));
    }
    array->SetValue(first++, flags);
  }
}

bool isLabel(vtkPointData* data, int index)
{
  vtkAbstractArray* array = data->GetAbstractArray(index);
  const int type = array->GetDataType();
  return !vtkDataArray::SafeDownCast(array) || type == VTK_ID_TYPE || type == VTK_BIT ||
    data->IsArrayAnAttribute(index) == vtkDataSetAttributes::PEDIGREEIDS;
}

bool isGhostArray(vtkAbstractArray* array)
{
  return array->GetName() &&
    std::strcmp(array->GetName(), vtkDataSetAttributes::GhostArrayName()) == 0 &&
    vtkUnsignedCharArray::SafeDownCast(array);
}

void writePointData(const RefinedMesh& refined, vtkPointData* from, vtkPointData* to, double end,
  LoopProgress& progress)
{
  const auto old = static_cast<vtkIdType>(refined.numberOfInputPoints);
  const vtkIdType count = old + static_cast<vtkIdType>(refined.points.size());
  requireMemory(count, bytesATuple(from));
  to->CopyAllocate(from, count); // this leaves global ids out
  if (to->GetNumberOfArrays() == 0)
  {
    return;
  }
  for (int i = 0; i < to->GetNumberOfArrays(); ++i)
  {
    to->GetAbstractArray(i)->SetNumberOfTuples(count);
  }
  to->CopyData(from, 0, old, 0);
  const std::vector<Blend> blends = blendsOf(refined);
  for (int i = 0; i < to->GetNumberOfArrays(); ++i)
  {
    const int left = to->GetNumberOfArrays() - i;
    progress.nextUntil(progress.end() + (end - progress.end()) / left);
    vtkAbstractArray* array = to->GetAbstractArray(i);
    if (isGhostArray(array))
    {
      keepGhosts(vtkUnsignedCharArray::SafeDownCast(array), blends, old);
    }
    else if (isLabel(to, i))
    {
      takeNearest(array, blends, old, progress);
    }
    else
    {
      interpolate(array, blends, old, progress);
    }
  }
}

void writePoints(
  const RefinedMesh& refined, vtkPoints* from, vtkPolyData* output, const LoopProgress& progress)
{
  const auto old = static_cast<vtkIdType>(refined.numberOfInputPoints);
  const int type = from->GetDataType();
  vtkNew<vtkPoints> points;
  // Integers could not hold the new points.
  points->SetDataType(type == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE);
  requireMemory(old + static_cast<vtkIdType>(refined.points.size()), 3 * sizeof(double));
  points->SetNumberOfPoints(old + static_cast<vtkIdType>(refined.points.size()));
  points->GetData()->InsertTuples(0, old, 0, from->GetData());
  for (std::size_t i = 0; i < refined.points.size(); ++i)
  {
    progress.at(i, refined.points.size());
    points->SetPoint(old + static_cast<vtkIdType>(i), refined.points[i].position.data());
  }
  output->SetPoints(points);
}

void writeCells(const PolyDataSurface& surface, const RefinedMesh& refined, vtkCellData* from,
  vtkPolyData* output, const LoopProgress& progress)
{
  const auto count = static_cast<vtkIdType>(refined.triangles.size());
  constexpr vtkIdType idsATriangle = 5; // three points, an offset and the original cell
  requireMemory(count + 1, idsATriangle * sizeof(vtkIdType) + bytesATuple(from));
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(count, 3 * count);
  vtkNew<vtkIdTypeArray> originals;
  originals->SetName("OriginalCellIds");
  originals->SetNumberOfTuples(count);
  vtkCellData* to = output->GetCellData();
  to->CopyGlobalIdsOff();
  to->CopyAllocate(from, count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    progress.at(static_cast<std::size_t>(i), refined.triangles.size());
    const Triangle& triangle = refined.triangles[static_cast<std::size_t>(i)];
    const vtkIdType cell = surface.inputCell(refined.faces[static_cast<std::size_t>(i)]);
    triangles->InsertNextCell({ static_cast<vtkIdType>(triangle[0]),
      static_cast<vtkIdType>(triangle[1]), static_cast<vtkIdType>(triangle[2]) });
    originals->SetValue(i, cell);
    to->CopyData(from, cell, i);
  }
  output->SetPolys(triangles);
  to->AddArray(originals);
}

}

void addDuplicateFaces(
  const PolyDataSurface& surface, std::uint64_t maximumFaces, RefinedMesh& refined)
{
  const TriangleMesh& mesh = surface.mesh();
  if (surface.numberOfTriangles() == static_cast<vtkIdType>(mesh.numberOfFaces()))
  {
    for (Id& face : refined.faces)
    {
      face = mesh.inputFace(face);
    }
    return;
  }
  FaceTwin twin(surface, refined);
  const std::vector<Id> faces = facesOfTriangles(surface, twin);
  const std::vector<Id> first = firstParts(refined.faces, mesh.numberOfFaces());
  std::uint64_t total = 0;
  for (const Id face : faces)
  {
    total += first[face + 1] - first[face];
  }
  const bool whole = maximumFaces > 0 && total > maximumFaces;

  std::vector<Triangle> triangles;
  std::vector<Id> parents;
  for (Id i = 0; i < faces.size(); ++i)
  {
    const Id face = faces[i];
    const bool isDuplicate = mesh.inputFace(face) != i;
    const Triangle own = surface.triangle(i);
    if (isDuplicate && (whole || first[face + 1] - first[face] == 1))
    {
      triangles.push_back(own);
      parents.push_back(i);
      continue;
    }
    if (isDuplicate)
    {
      twin.begin(face, own);
    }
    for (Id part = first[face]; part < first[face + 1]; ++part)
    {
      const Triangle& like = refined.triangles[part];
      triangles.push_back(isDuplicate ? twin.partLike(like) : like);
      parents.push_back(i);
    }
  }
  refined.triangles = std::move(triangles);
  refined.faces = std::move(parents);
}

void writeRefined(const PolyDataSurface& surface, const RefinedMesh& refined, vtkPolyData* input,
  vtkPolyData* output, const ProgressCallback& callback)
{
  constexpr double pointsDone = 0.1;
  constexpr double pointDataDone = 0.5;
  LoopProgress progress(callback);
  progress.nextUntil(pointsDone);
  writePoints(refined, input->GetPoints(), output, progress);
  writePointData(refined, input->GetPointData(), output->GetPointData(), pointDataDone, progress);
  progress.nextUntil(1.0);
  writeCells(surface, refined, input->GetCellData(), output, progress);
}

}
