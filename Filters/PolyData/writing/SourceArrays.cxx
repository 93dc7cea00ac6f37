// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/writing/SourceArrays.h"

#include "Errors.h"
#include "PolyData/Inputs.h"
#include "PolyData/Memory.h"
#include "PolyData/ranks/BorrowedValues.h"
#include "Trigonometry.h"
#include "refinement/RefinedOnRanks.h"
#include "source/CurvesOnPatch.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace geodesic
{

namespace
{

/// A point of an output, and what the arrays tell of it.
struct OutputPoint
{
  Vec3 position{};
  double distance = Infinity;
  SourceValues values;
  vtkIdType sourceId = -1;
  /// What stands in arrays of lengths and angles where the point is not reached.
  double unreached = Infinity;
  /// The length of a tile of texture coordinates.
  double tile = 1.0;
  /// The texture coordinate on the source, across a curve or around a point.
  double textureAtSource = 0.0;

  bool isReached() const { return this->distance < Infinity; }
  double signedDistance() const
  {
    return this->values.side == SourceSide::Right && this->distance > 0.0 ? -this->distance
                                                                          : this->distance;
  }
  Vec3 ifReached(double first, double second = 0.0) const
  {
    return this->isReached() ? Vec3{ first, second, 0.0 }
                             : Vec3{ this->unreached, this->unreached, 0.0 };
  }
};

Vec3 sourceIdOf(const OutputPoint& point)
{
  return { static_cast<double>(point.sourceId), 0.0, 0.0 };
}

Vec3 textureCoordinatesOf(const OutputPoint& point)
{
  const SourceValues& values = point.values;
  if (values.side != SourceSide::Point)
  {
    return point.ifReached(
      values.arcLength / point.tile, point.textureAtSource + point.signedDistance() / point.tile);
  }
  const Vec2 away = unitVector(values.angle);
  const double distance = point.distance / point.tile;
  return point.ifReached(
    point.textureAtSource + distance * away.x, point.textureAtSource + distance * away.y);
}

/// One of the arrays.
struct ArrayKind
{
  bool SourceArrayChoice::*isAskedFor;
  const char* name;
  int type;
  int components;
  /// The value at a point, in the first components.
  Vec3 (*valueOf)(const OutputPoint& point);
};

using Choice = SourceArrayChoice;

constexpr ArrayKind Kinds[] = { { &Choice::sourceIds, "SourceId", VTK_ID_TYPE, 1, sourceIdOf },
  // A point in a region is its own closest point.
  { &Choice::closestPoints, "ClosestSourcePoint", VTK_DOUBLE, 3,
    [](const OutputPoint& point)
    {
      const bool isOff = point.isReached() && point.distance > 0.0;
      return isOff ? point.values.closestPoint : point.position;
    } },
  // A point on the source may lie a rounding beside it.
  { &Choice::gradients, "DistanceGradient", VTK_DOUBLE, 3,
    [](const OutputPoint& point)
    { return point.distance > 0.0 ? point.values.gradient : Vec3(); } },
  { &Choice::signedDistances, "SignedGeodesicDistance", VTK_DOUBLE, 1,
    [](const OutputPoint& point) { return point.ifReached(point.signedDistance()); } },
  { &Choice::arcLengths, "SourceArcLength", VTK_DOUBLE, 1,
    [](const OutputPoint& point) { return point.ifReached(point.values.arcLength); } },
  { &Choice::angles, "SourceAngle", VTK_DOUBLE, 1,
    [](const OutputPoint& point)
    { return point.ifReached(point.distance > 0.0 ? point.values.angle : 0.0); } },
  { &Choice::textureCoordinates, "SourceTextureCoordinates", VTK_DOUBLE, 2,
    textureCoordinatesOf } };

vtkSmartPointer<vtkDataArray> makeArray(
  const char* name, int type, int components, vtkIdType tuples)
{
  requireMemory(tuples, components * static_cast<vtkIdType>(sizeof(double)));
  const auto array = vtk::TakeSmartPointer(vtkDataArray::CreateDataArray(type));
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

/// Adds the arrays that are asked for to the points of an output.
///
/// \param pointAt (vtkIdType number) -> OutputPoint
template <typename PointAt>
void addArrays(const SourceArrayChoice& choice, const PointAt& pointAt, vtkPolyData* output)
{
  for (const ArrayKind& kind : Kinds)
  {
    if (choice.*kind.isAskedFor)
    {
      const vtkIdType count = output->GetNumberOfPoints();
      const auto array = makeArray(kind.name, kind.type, kind.components, count);
      for (vtkIdType i = 0; i < count; ++i)
      {
        array->SetTuple(i, kind.valueOf(pointAt(i)).data());
      }
      output->GetPointData()->AddArray(array);
    }
  }
  if (choice.textureCoordinates)
  {
    output->GetPointData()->SetActiveTCoords("SourceTextureCoordinates");
  }
}

SourceValues valuesOf(const SourceArrays& arrays, const Foot& foot, NearestSource& nearest)
{
  SourceValues values;
  if (!foot.isKnown())
  {
    return values;
  }
  const SourceCurve& curve = arrays.sources.curves[foot.curve];
  const PowerOfTwoScale& scale = arrays.surface.scale;
  values.source = curve.source;
  values.side = curve.points.size() == 1 ? SourceSide::Point
    : isOnRight(foot, arrays.sources)    ? SourceSide::Right
                                         : SourceSide::Left;
  if (arrays.choice.closestPoints)
  {
    values.closestPoint = scale.toUser(position(nearest.meshOfCurves(), nearest.pointOf(foot)));
  }
  if (arrays.choice.areArcLengthsNeeded())
  {
    values.arcLength = scale.toUser(nearest.arcLengthOf(foot));
  }
  if (arrays.choice.areAnglesNeeded())
  {
    values.angle = nearest.angleOf(foot);
  }
  return values;
}

/// Collects the values at points.
///
/// \param at of each point, if these are asked for, the foot, and the segment for the gradient:
///        (std::size_t i) -> std::pair<Foot, IncomingSegment>
template <typename At>
std::vector<SourceValues> collect(const SourceArrays& arrays, NearestSource& nearest,
  std::size_t count, const DistanceField& computed, const Job& job, const At& at)
{
  std::vector<SourceValues> values(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    job.reachItem(i, count);
    const auto& [foot, segment] = at(i);
    if (arrays.choice.areFeetNeeded())
    {
      values[i] = valuesOf(arrays, foot, nearest);
    }
    if (arrays.choice.gradients)
    {
      values[i].gradient = gradientOf(computed.mesh(), segment);
    }
  }
  return values;
}

}

std::vector<const char*> namesOf(const SourceArrayChoice& choice)
{
  std::vector<const char*> names;
  for (const ArrayKind& kind : Kinds)
  {
    if (choice.*kind.isAskedFor)
    {
      names.push_back(kind.name);
    }
  }
  return names;
}

std::vector<SourceValues> SourceArrays::atVertices(
  const DistanceField& computed, NearestSource& nearest, const Job& job) const
{
  const auto at = [&](std::size_t i)
  {
    const auto vertex = static_cast<Id>(i);
    return std::pair(nearest.atVertex(vertex),
      this->choice.gradients ? incomingSegmentTo(computed, SurfacePoint::atVertex(vertex))
                             : IncomingSegment());
  };
  std::vector<SourceValues> values =
    collect(*this, nearest, this->surface.partition.numberOfOwnVertices(), computed, job, at);
  this->surface.completeValues({}, values);
  return values;
}

std::vector<SourceValues> SourceArrays::atNewPoints(const RefinedMesh& refined,
  const std::vector<SourceValues>& atVertices, const DistanceField& computed,
  const DistanceField& exact, NearestSource& nearest, const Job& job) const
{
  const std::vector<RefinedPoint>& points = refined.points;
  const std::size_t count = refined.numberOfPointsWithPlaces();
  const auto at = [&](std::size_t i)
  {
    const bool isReached = points[i].distance < Infinity && points[i].hasPlace();
    const bool isOther = this->choice.gradients && isReached && &computed != &exact;
    const IncomingSegment piece =
      isReached ? incomingSegmentTo(exact, points[i].place) : IncomingSegment();
    return std::pair(this->choice.areFeetNeeded() ? nearest.of(piece) : Foot(),
      isOther ? incomingSegmentTo(computed, points[i].place) : piece);
  };
  std::vector<SourceValues> values = collect(*this, nearest, count, computed, job, at);
  for (Id i = 0; i < this->surface.cutPoints.size(); ++i)
  {
    if (!points[i].hasPlace())
    {
      values[i] = atVertices[this->surface.vertexOf(this->surface.numberOfPoints + i)];
    }
  }
  Exchange& exchange = this->surface.exchange();
  const SeamPoints seams = findSeamPoints(points, count, computed, exact);
  const std::vector<SourceValues> ofOthers =
    BorrowedValues(seams.there, exchange)
      .copies(SourceValues(), exchange, [&](Id i) { return values[i]; });
  for (std::size_t i = 0; i < seams.here.size(); ++i)
  {
    values[seams.here[i]] = ofOthers[i];
  }
  BorrowedValues(refined.copied, exchange).append({}, values, exchange);
  return values;
}

void SourceArrays::write(const SurfaceBlock& block, const std::vector<SourceValues>& atVertices,
  const std::vector<SourceValues>& atNewPoints, const double* distances, double unreached,
  vtkPolyData* output) const
{
  // The points of the input, which have the values of their vertices, come before the new ones.
  const auto pointAt = [&](vtkIdType i)
  {
    OutputPoint point;
    output->GetPoint(i, point.position.data());
    point.distance = distances[i];
    point.unreached = unreached;
    point.tile = this->textureTile;
    point.textureAtSource = this->textureAtSource;
    const auto number = static_cast<Id>(i);
    const bool isNew = number >= block.numberOfPoints;
    point.values = isNew ? atNewPoints[number - block.numberOfPoints]
                         : atVertices[this->surface.vertexOf(block.firstPoint + number)];
    point.sourceId = point.values.source == NoId ? -1 : this->sources.ids[point.values.source];
    return point;
  };
  addArrays(this->choice, pointAt, output);
}

std::vector<std::vector<double>> SourceArrays::arcLengthsOfCurves(
  const NearestSource& nearest) const
{
  std::vector<std::vector<double>> lengths;
  for (Id curve = 0; this->choice.arcLengths && curve < this->sources.curves.size(); ++curve)
  {
    lengths.push_back(nearest.arcLengthsOf(curve));
    for (double& length : lengths.back())
    {
      length = this->surface.scale.toUser(length);
    }
  }
  return lengths;
}

SourceFrames framesBySource(const CurvesOnPatch& onPatch, const Sources& sources)
{
  SourceFrames result;
  std::vector<SourceFrame>& frames = result.frames;
  if (sources.areNamed) // ids may be large
  {
    result.ids = sources.ids;
    frames.resize(sources.ids.size());
  }
  // The first curve of a source comes last.
  for (Id curve = static_cast<Id>(sources.curves.size()); curve-- > 0;)
  {
    const Id source = sources.curves[curve].source;
    const auto row = sources.areNamed ? source : static_cast<std::size_t>(sources.ids[source]);
    frames.resize(std::max(frames.size(), row + 1));
    frames[row] = onPatch.frameOf(curve);
  }
  return result;
}

void addSourceFrames(const SourceFrames& all, vtkDataObject* output)
{
  const std::vector<SourceFrame>& frames = all.frames;
  const auto array = makeArray("SourceFrame", VTK_DOUBLE, 9, static_cast<vtkIdType>(frames.size()));
  for (std::size_t source = 0; source < frames.size(); ++source)
  {
    const std::array<Vec3, 3> axes = { frames[source].x, frames[source].y, frames[source].normal };
    for (std::size_t k = 0; k < 9; ++k)
    {
      array->SetComponent(static_cast<vtkIdType>(source), static_cast<int>(k), axes[k / 3][k % 3]);
    }
  }
  output->GetFieldData()->AddArray(array);
  if (!all.ids.empty())
  {
    const auto ids =
      makeArray("SourceFrameId", VTK_ID_TYPE, 1, static_cast<vtkIdType>(all.ids.size()));
    for (std::size_t i = 0; i < all.ids.size(); ++i)
    {
      ids->SetComponent(static_cast<vtkIdType>(i), 0, static_cast<double>(all.ids[i]));
    }
    output->GetFieldData()->AddArray(ids);
  }
}

void requireSides(const PolyDataSurface& surface, const std::string& property)
{
  const MeshPartition& part = surface.partition;
  const TriangleMesh& mesh = surface.mesh();
  Id halfedge = TriangleMesh::halfedgeOf(part.firstOwnFace(), 0);
  const Id end = TriangleMesh::halfedgeOf(part.endOfOwnFaces(), 0);
  while (halfedge < end && (mesh.isBoundary(halfedge) || mesh.acrossOriented(halfedge) != NoId))
  {
    ++halfedge;
  }
  if (halfedge == end)
  {
    return;
  }
  const Id face = TriangleMesh::faceOf(halfedge);
  const std::string where = part.isDistributed()
    ? ", which faces of this one (input port 0) on rank " + std::to_string(part.exchange().rank())
    : ": " + surface.nameOfCell(surface.triangleOf(face)) + " and a neighbor";
  throw MeshError(property +
    " needs a surface whose faces have one orientation and whose edges have at most two faces" +
    where +
    " do not fit. Orient the surface upstream (Generate Surface Normals with Consistency), split "
    "it, or switch " +
    property + " off.");
}

bool isOnRight(const Foot& foot, const Sources& sources)
{
  return foot.isKnown() && foot.isRight && sources.curves[foot.curve].points.size() > 1 &&
    sources.curves[foot.curve].source < sources.firstBoundary;
}

}
