// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/SourceArrays.h"

#include "Errors.h"
#include "PolyData/Memory.h"
#include "PolyData/ranks/BorrowedValues.h"
#include "PolyData/writing/RefinedPolyData.h"
#include "field/Gradients.h"
#include "refinement/SeamPoints.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <utility>

namespace geodesic
{

namespace
{

constexpr const char* SourceIdName = "SourceId";
constexpr const char* ClosestPointName = "ClosestSourcePoint";
constexpr const char* GradientName = "DistanceGradient";
constexpr const char* SignedDistanceName = "SignedGeodesicDistance";

/// Calls fill(tuple, values, index) for all points of a block: with the values at vertices, then
/// with those at new points.
template <typename Fill>
void forEachPoint(const PolyDataSurface& surface, const SurfaceBlock& block,
  const SourceValues& atVertices, const SourceValues& atNewPoints, vtkIdType count, Fill&& fill)
{
  for (Id i = 0; i < block.numberOfPoints; ++i)
  {
    fill(static_cast<vtkIdType>(i), atVertices, surface.vertexOf(block.firstPoint + i));
  }
  for (vtkIdType i = static_cast<vtkIdType>(block.numberOfPoints); i < count; ++i)
  {
    fill(i, atNewPoints, static_cast<std::size_t>(i) - block.numberOfPoints);
  }
}

template <typename Array>
vtkNew<Array> makeArray(const char* name, int components, vtkIdType tuples)
{
  requireMemory(tuples, components * static_cast<vtkIdType>(sizeof(double)));
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

} // anonymous namespace

std::vector<const char*> namesOf(const SourceArrayChoice& choice)
{
  std::vector<const char*> names;
  const std::pair<bool, const char*> all[] = { { choice.sourceIds, SourceIdName },
    { choice.closestPoints, ClosestPointName }, { choice.gradients, GradientName },
    { choice.signedDistances, SignedDistanceName } };
  for (const auto& [isAskedFor, name] : all)
  {
    if (isAskedFor)
    {
      names.push_back(name);
    }
  }
  return names;
}

void addEmptyArrays(const SourceArrayChoice& choice, vtkPolyData* output)
{
  for (const char* name : namesOf(choice))
  {
    if (name == std::string(SourceIdName))
    {
      output->GetPointData()->AddArray(makeArray<vtkIdTypeArray>(name, 1, 0));
      continue;
    }
    const int components = name == std::string(SignedDistanceName) ? 1 : 3;
    output->GetPointData()->AddArray(makeArray<vtkDoubleArray>(name, components, 0));
  }
}

// Calls visit(member, none) for the values that are asked for: where SourceValues has them, and the
// value of a point without a face.
template <typename Visit>
void SourceArrays::forEachKind(const Visit& visit) const
{
  if (this->choice_.sourceIds)
  {
    visit(&SourceValues::sources, NoId);
  }
  if (this->choice_.closestPoints)
  {
    visit(&SourceValues::closestPoints, Vec3{});
  }
  if (this->choice_.gradients)
  {
    visit(&SourceValues::gradients, Vec3{});
  }
  if (this->choice_.signedDistances)
  {
    visit(&SourceValues::isOnRight, std::uint8_t(0));
  }
}

void SourceArrays::completeValues(SourceValues& atVertices) const
{
  this->forEachKind(
    [&](auto kind, const auto& none) { this->surface_.completeValues(none, atVertices.*kind); });
}

void SourceArrays::replaceAtSeams(const SeamPoints& seams, SourceValues& atNewPoints) const
{
  Exchange& exchange = this->surface_.exchange();
  const BorrowedValues told(seams.there, exchange);
  this->forEachKind(
    [&](auto kind, const auto&) { told.replace(seams.here, atNewPoints.*kind, exchange); });
}

void SourceArrays::appendCopies(
  const std::vector<RankAddress>& copied, SourceValues& atNewPoints) const
{
  Exchange& exchange = this->surface_.exchange();
  const BorrowedValues copies(copied, exchange);
  this->forEachKind(
    [&](auto kind, const auto& none) { copies.append(none, atNewPoints.*kind, exchange); });
}

std::vector<SourceValues> SourceArrays::valuesByBlock(
  SourceValues atNewPoints, const RefinedMesh& refined) const
{
  std::vector<SourceValues> values(this->surface_.blocks().size());
  if (values.size() == 1)
  {
    values.front() = std::move(atNewPoints);
    return values;
  }
  const std::vector<std::size_t> blocks = blocksOfNewPoints(this->surface_, refined);
  this->forEachKind(
    [&](auto kind, const auto&)
    {
      const auto ofAll = std::move(atNewPoints.*kind);
      for (std::size_t i = 0; i < blocks.size(); ++i)
      {
        (values[blocks[i]].*kind).push_back(ofAll[i]);
      }
    });
  return values;
}

void SourceArrays::reserve(std::size_t count, SourceValues& values) const
{
  this->forEachKind([&](auto kind, const auto&) { (values.*kind).reserve(count); });
}

void SourceArrays::add(const Foot& foot, const NearestSource& nearest, SourceValues& values) const
{
  if (this->choice_.sourceIds)
  {
    values.sources.push_back(foot.isKnown() ? this->curves_[foot.curve].source : NoId);
  }
  if (this->choice_.closestPoints)
  {
    values.closestPoints.push_back(foot.isKnown()
        ? this->surface_.scale().toUser(position(nearest.meshOfCurves(), nearest.pointOf(foot)))
        : Vec3{});
  }
  if (this->choice_.signedDistances)
  {
    values.isOnRight.push_back(isOnRight(foot, this->curves_, this->firstBoundarySource_) ? 1 : 0);
  }
}

SourceValues SourceArrays::atVertices(const DistanceField& computed, const NearestSource& nearest,
  const ProgressCallback& callback) const
{
  SourceValues values;
  LoopProgress progress(callback);
  progress.nextUntil(1.0);
  const Id count = this->surface_.partition().numberOfOwnVertices();
  this->reserve(count, values);
  Gradients gradients(computed, values.gradients);
  for (Id vertex = 0; vertex < count; ++vertex)
  {
    progress.at(vertex, count);
    if (this->choice_.areFeetNeeded())
    {
      this->add(nearest.atVertex(vertex), nearest, values);
    }
    if (this->choice_.gradients)
    {
      gradients.add(incomingSegmentTo(computed, SurfacePoint::atVertex(vertex)));
    }
  }
  if (this->choice_.gradients)
  {
    gradients.finish();
  }
  return values;
}

SourceValues SourceArrays::atPoints(const std::vector<RefinedPoint>& points, std::size_t count,
  const DistanceField& computed, const DistanceField& exact, NearestSource& nearest,
  const ProgressCallback& callback) const
{
  SourceValues values;
  LoopProgress progress(callback);
  progress.nextUntil(1.0);
  this->reserve(count, values);
  Gradients gradients(computed, values.gradients);
  for (std::size_t i = 0; i < count; ++i)
  {
    progress.at(i, count);
    const bool isReached = points[i].distance < Infinity;
    const IncomingSegment piece =
      isReached ? incomingSegmentTo(exact, points[i].place) : IncomingSegment();
    if (this->choice_.areFeetNeeded())
    {
      this->add(nearest.of(piece), nearest, values);
    }
    if (this->choice_.gradients)
    {
      const bool isOther = isReached && &computed != &exact;
      gradients.add(isOther ? incomingSegmentTo(computed, points[i].place) : piece);
    }
  }
  if (this->choice_.gradients)
  {
    gradients.finish();
  }
  return values;
}

void SourceArrays::write(const SurfaceBlock& block, const SourceValues& atVertices,
  const SourceValues& atNewPoints, const double* distances, double unreached,
  vtkPolyData* output) const
{
  const vtkIdType count = output->GetNumberOfPoints();
  const auto fillAll = [&](auto&& fill)
  { forEachPoint(this->surface_, block, atVertices, atNewPoints, count, fill); };
  if (this->choice_.sourceIds)
  {
    const auto array = makeArray<vtkIdTypeArray>(SourceIdName, 1, count);
    fillAll(
      [&](vtkIdType i, const SourceValues& from, std::size_t at)
      {
        const Id source = from.sources[at];
        array->SetValue(i, source == NoId ? -1 : static_cast<vtkIdType>(source));
      });
    output->GetPointData()->AddArray(array);
  }
  if (this->choice_.closestPoints)
  {
    const auto array = makeArray<vtkDoubleArray>(ClosestPointName, 3, count);
    fillAll(
      [&](vtkIdType i, const SourceValues& from, std::size_t at)
      {
        const bool isReached = distances[i] < Infinity;
        array->SetTuple(i, isReached ? from.closestPoints[at].data() : output->GetPoint(i));
      });
    output->GetPointData()->AddArray(array);
  }
  if (this->choice_.gradients)
  {
    const auto array = makeArray<vtkDoubleArray>(GradientName, 3, count);
    fillAll(
      [&](vtkIdType i, const SourceValues& from, std::size_t at)
      {
        // A point on the source may lie a rounding beside it.
        array->SetTuple(i, (distances[i] > 0.0 ? from.gradients[at] : Vec3{}).data());
      });
    output->GetPointData()->AddArray(array);
  }
  if (this->choice_.signedDistances)
  {
    const auto array = makeArray<vtkDoubleArray>(SignedDistanceName, 1, count);
    fillAll(
      [&](vtkIdType i, const SourceValues& from, std::size_t at)
      {
        const double d = distances[i];
        const double signedDistance = from.isOnRight[at] != 0 && d > 0.0 ? -d : d;
        array->SetValue(i, d < Infinity ? signedDistance : unreached);
      });
    output->GetPointData()->AddArray(array);
  }
}

Id findFaceWithoutSides(const TriangleMesh& mesh, Id first, Id end)
{
  for (Id halfedge = 3 * first; halfedge < 3 * end; ++halfedge)
  {
    if (!mesh.isBoundary(halfedge) && mesh.acrossOriented(halfedge) == NoId)
    {
      return TriangleMesh::faceOf(halfedge);
    }
  }
  return NoId;
}

void requireSides(const PolyDataSurface& surface, const std::vector<PolyDataBlock>& inputs,
  const std::string& property)
{
  const MeshPartition& part = surface.partition();
  const Id face = findFaceWithoutSides(surface.mesh(), part.firstOwnFace(), part.endOfOwnFaces());
  if (face == NoId)
  {
    return;
  }
  if (part.isDistributed())
  {
    throw MeshError(property +
      " needs a surface whose faces have one orientation and whose edges have at most two faces, "
      "which faces of this one (input port 0) on rank " +
      std::to_string(part.exchange().rank()) +
      " do not fit. Orient the surface upstream (Generate Surface Normals with Consistency), split "
      "it, or switch " +
      property + " off.");
  }
  throw MeshError(property +
    " needs a surface whose faces have one orientation and whose edges have at most two faces: " +
    surface.nameOfCell(surface.triangleOf(face), inputs) +
    " and a neighbor do not fit. Orient the surface upstream (Generate Surface Normals with "
    "Consistency), split it, or switch " +
    property + " off.");
}

bool isOnRight(const Foot& foot, const std::vector<SourceCurve>& curves, Id firstBoundarySource)
{
  return foot.isKnown() && foot.isRight && curves[foot.curve].points.size() > 1 &&
    curves[foot.curve].source < firstBoundarySource;
}

}
