// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/SourceArrays.h"

#include "Errors.h"
#include "PolyData/Memory.h"
#include "PolyData/ranks/BorrowedValues.h"
#include "PolyData/writing/RefinedPolyData.h"
#include "field/Gradients.h"
#include "refinement/RefinedOnRanks.h"

#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

namespace geodesic
{

namespace
{

constexpr const char* SourceIdName = "SourceId";
constexpr const char* ClosestPointName = "ClosestSourcePoint";
constexpr const char* GradientName = "DistanceGradient";
constexpr const char* SignedDistanceName = "SignedGeodesicDistance";
constexpr const char* ArcLengthName = "SourceArcLength";
constexpr const char* AngleName = "SourceAngle";
constexpr const char* TextureCoordinateName = "SourceTextureCoordinates";

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

/// Adds arrays to the points of an output.
///
/// \tparam ForEachPoint (visit) calls visit(vtkIdType point, const SourceValues&, std::size_t index
///         of its values) for each point.
template <typename ForEachPoint>
class ArraysOfPoints
{
public:
  ArraysOfPoints(const ForEachPoint& forEachPoint, vtkPolyData* output)
    : forEachPoint_(forEachPoint)
    , output_(output)
  {
  }

  /// \param valueAt takes the arguments of visit() and returns a vtkIdType.
  template <typename ValueAt>
  void addIds(const char* name, const ValueAt& valueAt) const
  {
    const auto array = makeArray<vtkIdTypeArray>(name, 1, this->output_->GetNumberOfPoints());
    this->forEachPoint_([&](vtkIdType point, const SourceValues& values, std::size_t i)
      { array->SetValue(point, valueAt(point, values, i)); });
    this->output_->GetPointData()->AddArray(array);
  }

  /// \param valueAt the same, but returns a std::array of the components.
  template <typename ValueAt>
  vtkNew<vtkDoubleArray> addDoubles(const char* name, const ValueAt& valueAt) const
  {
    using Value = std::invoke_result_t<ValueAt, vtkIdType, const SourceValues&, std::size_t>;
    auto array = makeArray<vtkDoubleArray>(
      name, static_cast<int>(std::tuple_size<Value>::value), this->output_->GetNumberOfPoints());
    this->forEachPoint_([&](vtkIdType point, const SourceValues& values, std::size_t i)
      { array->SetTypedTuple(point, valueAt(point, values, i).data()); });
    this->output_->GetPointData()->AddArray(array);
    return array;
  }

private:
  const ForEachPoint& forEachPoint_;
  vtkPolyData* output_;
};

double signedDistance(SourceSide side, double distance)
{
  return side == SourceSide::Right && distance > 0.0 ? -distance : distance;
}

std::array<double, 2> textureCoordinates(const SourceValues& values, std::size_t i, double distance)
{
  if (values.sides[i] == SourceSide::Point)
  {
    return { distance * std::cos(values.angles[i]), distance * std::sin(values.angles[i]) };
  }
  return { values.arcLengths[i], signedDistance(values.sides[i], distance) };
}

/// Adds the arrays that are asked for: SourceArrays::write().
template <typename ForEachPoint>
void writeArrays(const SourceArrayChoice& choice, const ForEachPoint& forEachPoint,
  const double* distances, double unreached, vtkPolyData* output)
{
  const ArraysOfPoints<ForEachPoint> arrays(forEachPoint, output);
  const auto isReached = [distances](vtkIdType point) { return distances[point] < Infinity; };
  if (choice.sourceIds)
  {
    arrays.addIds(SourceIdName,
      [](vtkIdType, const SourceValues& values, std::size_t i)
      { return values.sources[i] == NoId ? -1 : static_cast<vtkIdType>(values.sources[i]); });
  }
  if (choice.closestPoints)
  {
    arrays.addDoubles(ClosestPointName,
      [&](vtkIdType point, const SourceValues& values, std::size_t i)
      {
        Vec3 closest = isReached(point) ? values.closestPoints[i] : Vec3();
        if (!isReached(point))
        {
          output->GetPoint(point, closest.data());
        }
        return closest;
      });
  }
  if (choice.gradients)
  {
    // A point on the source may lie a rounding beside it.
    arrays.addDoubles(GradientName,
      [&](vtkIdType point, const SourceValues& values, std::size_t i)
      { return distances[point] > 0.0 ? values.gradients[i] : Vec3(); });
  }
  const auto addScalars = [&](bool isAskedFor, const char* name, const auto& valueAt)
  {
    if (isAskedFor)
    {
      arrays.addDoubles(name,
        [&](vtkIdType point, const SourceValues& values, std::size_t i) -> std::array<double, 1>
        { return { isReached(point) ? valueAt(distances[point], values, i) : unreached }; });
    }
  };
  addScalars(choice.signedDistances, SignedDistanceName,
    [](double distance, const SourceValues& values, std::size_t i)
    { return signedDistance(values.sides[i], distance); });
  addScalars(choice.arcLengths, ArcLengthName,
    [](double, const SourceValues& values, std::size_t i) { return values.arcLengths[i]; });
  addScalars(choice.angles, AngleName,
    [](double distance, const SourceValues& values, std::size_t i)
    { return distance > 0.0 ? values.angles[i] : 0.0; });
  if (choice.textureCoordinates)
  {
    output->GetPointData()->SetTCoords(arrays.addDoubles(TextureCoordinateName,
      [&](vtkIdType point, const SourceValues& values, std::size_t i)
      {
        return isReached(point) ? textureCoordinates(values, i, distances[point])
                                : std::array<double, 2>{ unreached, unreached };
      }));
  }
}

} // anonymous namespace

std::vector<const char*> namesOf(const SourceArrayChoice& choice)
{
  std::vector<const char*> names;
  const std::pair<bool, const char*> all[] = { { choice.sourceIds, SourceIdName },
    { choice.closestPoints, ClosestPointName }, { choice.gradients, GradientName },
    { choice.signedDistances, SignedDistanceName }, { choice.arcLengths, ArcLengthName },
    { choice.angles, AngleName }, { choice.textureCoordinates, TextureCoordinateName } };
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
  writeArrays(
    choice, [](const auto&) {}, nullptr, 0.0, output);
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
  if (this->choice_.areSidesNeeded())
  {
    visit(&SourceValues::sides, SourceSide::Left);
  }
  if (this->choice_.areArcLengthsNeeded())
  {
    visit(&SourceValues::arcLengths, 0.0);
  }
  if (this->choice_.areAnglesNeeded())
  {
    visit(&SourceValues::angles, 0.0);
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
  if (this->choice_.areSidesNeeded())
  {
    values.sides.push_back(this->sideOf(foot));
  }
  if (this->choice_.areArcLengthsNeeded())
  {
    values.arcLengths.push_back(
      foot.isKnown() ? this->surface_.scale().toUser(nearest.arcLengthOf(foot)) : 0.0);
  }
  if (this->choice_.areAnglesNeeded())
  {
    values.angles.push_back(foot.isKnown() ? nearest.angleOf(foot) : 0.0);
  }
}

SourceSide SourceArrays::sideOf(const Foot& foot) const
{
  if (foot.isKnown() && this->curves_[foot.curve].points.size() == 1)
  {
    return SourceSide::Point;
  }
  return isOnRight(foot, this->curves_, this->firstBoundarySource_) ? SourceSide::Right
                                                                    : SourceSide::Left;
}

// Calls add(i, values, gradients) for each point.
template <typename Add>
SourceValues SourceArrays::collect(std::size_t count, const DistanceField& computed,
  const ProgressCallback& callback, const Add& add) const
{
  SourceValues values;
  LoopProgress progress(callback);
  progress.nextUntil(1.0);
  this->reserve(count, values);
  Gradients gradients(computed, values.gradients);
  for (std::size_t i = 0; i < count; ++i)
  {
    progress.at(i, count);
    add(i, values, gradients);
  }
  if (this->choice_.gradients)
  {
    gradients.finish();
  }
  return values;
}

SourceValues SourceArrays::atVertices(const DistanceField& computed, const NearestSource& nearest,
  const ProgressCallback& progress) const
{
  const auto add = [&](std::size_t i, SourceValues& values, Gradients& gradients)
  {
    const auto vertex = static_cast<Id>(i);
    if (this->choice_.areFeetNeeded())
    {
      this->add(nearest.atVertex(vertex), nearest, values);
    }
    if (this->choice_.gradients)
    {
      gradients.add(incomingSegmentTo(computed, SurfacePoint::atVertex(vertex)));
    }
  };
  return this->collect(this->surface_.partition().numberOfOwnVertices(), computed, progress, add);
}

SourceValues SourceArrays::atPoints(const std::vector<RefinedPoint>& points, std::size_t count,
  const DistanceField& computed, const DistanceField& exact, NearestSource& nearest,
  const ProgressCallback& progress) const
{
  const auto add = [&](std::size_t i, SourceValues& values, Gradients& gradients)
  {
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
  };
  return this->collect(count, computed, progress, add);
}

void SourceArrays::write(const SurfaceBlock& block, const SourceValues& atVertices,
  const SourceValues& atNewPoints, const double* distances, double unreached,
  vtkPolyData* output) const
{
  // The points of the input, which have the values of their vertices, come before the new ones.
  const auto forEachPoint = [&](const auto& visit)
  {
    for (Id i = 0; i < block.numberOfPoints; ++i)
    {
      visit(static_cast<vtkIdType>(i), atVertices, this->surface_.vertexOf(block.firstPoint + i));
    }
    const auto count = static_cast<Id>(output->GetNumberOfPoints());
    for (Id i = block.numberOfPoints; i < count; ++i)
    {
      visit(static_cast<vtkIdType>(i), atNewPoints, i - block.numberOfPoints);
    }
  };
  writeArrays(this->choice_, forEachPoint, distances, unreached, output);
}

std::vector<SourceFrame> SourceArrays::frames(const NearestSource& nearest) const
{
  return this->choice_.angles
    ? framesBySource(this->curves_, [&nearest](Id curve) { return nearest.frameOf(curve); })
    : std::vector<SourceFrame>();
}

std::vector<std::vector<double>> SourceArrays::arcLengthsOfCurves(
  const NearestSource& nearest) const
{
  std::vector<std::vector<double>> lengths;
  for (Id curve = 0; this->choice_.arcLengths && curve < this->curves_.size(); ++curve)
  {
    lengths.push_back(nearest.arcLengthsOf(curve));
    for (double& length : lengths.back())
    {
      length = this->surface_.scale().toUser(length);
    }
  }
  return lengths;
}

void addSourceFrames(const std::vector<SourceFrame>& frames, vtkDataObject* output)
{
  const auto array =
    makeArray<vtkDoubleArray>("SourceFrame", 9, static_cast<vtkIdType>(frames.size()));
  for (std::size_t source = 0; source < frames.size(); ++source)
  {
    const SourceFrame& frame = frames[source];
    int component = 0;
    for (const Vec3* axis : { &frame.x, &frame.y, &frame.normal })
    {
      for (const double value : *axis)
      {
        array->SetComponent(static_cast<vtkIdType>(source), component++, value);
      }
    }
  }
  output->GetFieldData()->AddArray(array);
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
  const std::string where = part.isDistributed()
    ? ", which faces of this one (input port 0) on rank " + std::to_string(part.exchange().rank())
    : ": " + surface.nameOfCell(surface.triangleOf(face), inputs) + " and a neighbor";
  throw MeshError(property +
    " needs a surface whose faces have one orientation and whose edges have at most two faces" +
    where +
    " do not fit. Orient the surface upstream (Generate Surface Normals with Consistency), split "
    "it, or switch " +
    property + " off.");
}

bool isOnRight(const Foot& foot, const std::vector<SourceCurve>& curves, Id firstBoundarySource)
{
  return foot.isKnown() && foot.isRight && curves[foot.curve].points.size() > 1 &&
    curves[foot.curve].source < firstBoundarySource;
}

}
