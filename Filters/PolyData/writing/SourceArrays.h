// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceArrays_h
#define geodesic_SourceArrays_h

#include "Job.h"
#include "PolyData/reading/PolyDataSurface.h"
#include "field/NearestSource.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace geodesic
{

struct RefinedMesh;
struct Sources;

/// Which arrays beside the distance are asked for.
struct SourceArrayChoice
{
  bool sourceIds = false;
  bool closestPoints = false;
  bool gradients = false;
  bool signedDistances = false;
  bool arcLengths = false;
  bool angles = false;
  bool textureCoordinates = false;

  bool areSidesNeeded() const { return this->signedDistances || this->textureCoordinates; }
  bool areArcLengthsNeeded() const { return this->arcLengths || this->textureCoordinates; }
  bool areAnglesNeeded() const { return this->angles || this->textureCoordinates; }
  bool areFeetNeeded() const
  {
    return this->sourceIds || this->closestPoints || this->areSidesNeeded() ||
      this->areArcLengthsNeeded() || this->areAnglesNeeded();
  }
  bool isAny() const { return this->areFeetNeeded() || this->gradients; }
};

/// The names of the arrays that are asked for.
std::vector<const char*> namesOf(const SourceArrayChoice& choice);

/// Where a shortest path ends on its source: on the left of a curve, where loops of the boundary
/// have all their paths, on its right, or at a point, which has no sides.
enum class SourceSide : std::uint8_t
{
  Left,
  Right,
  Point
};

/// What the arrays hold at a point: where its shortest path ends on the source, and how. Of that
/// what the choice of arrays needs.
struct SourceValues
{
  /// In the user's scale.
  Vec3 closestPoint{};
  /// In the user's scale.
  double arcLength = 0.0;
  double angle = 0.0;
  /// SourceCurve::source; NoId where the point was not reached: then nothing above is told.
  Id source = NoId;
  SourceSide side = SourceSide::Left;
  Vec3 gradient{};
};

/// Computes the arrays that tell more of a field than its distance.
struct SourceArrays
{
  const PolyDataSurface& surface;
  const Sources& sources;
  /// The length of a tile of texture coordinates, in the user's scale.
  double textureTile;
  /// The texture coordinate on the source, across a curve or around a point.
  double textureAtSource;
  SourceArrayChoice choice;

  /// Values for every vertex that points have: PolyDataSurface::vertexOf(). All ranks call this
  /// together.
  ///
  /// \param computed the field that gradients are of, with arrivals.
  std::vector<SourceValues> atVertices(
    const DistanceField& computed, NearestSource& nearest, const Job& job) const;
  /// Values for the points that refinement has added. A point on a seam has the values of the rank
  /// that knows them best. All ranks call this together.
  ///
  /// \param atVertices from atVertices(), for points that cut the surface where this rank has no
  ///        face.
  /// \param exact the field that feet are of, with arrivals; the computed one or another.
  std::vector<SourceValues> atNewPoints(const RefinedMesh& refined,
    const std::vector<SourceValues>& atVertices, const DistanceField& computed,
    const DistanceField& exact, NearestSource& nearest, const Job& job) const;

  /// Adds the arrays of one block to its points: those of the input, then those that were added.
  ///
  /// \param distances of the same points; infinite where a point is not reached.
  /// \param unreached what stands there in the arrays of lengths and angles.
  void write(const SurfaceBlock& block, const std::vector<SourceValues>& atVertices,
    const std::vector<SourceValues>& atNewPoints, const double* distances, double unreached,
    vtkPolyData* output) const;

  /// For writeCurves(): the arc lengths of each curve's points, in the user's scale. Empty unless
  /// arc lengths are asked for.
  std::vector<std::vector<double>> arcLengthsOfCurves(const NearestSource& nearest) const;
};

/// The frames that angles are measured in; of a source that is cut in several curves, that of the
/// first.
struct SourceFrames
{
  std::vector<SourceFrame> frames;
  /// The ids of their sources; empty where frame k is that of source k.
  std::vector<vtkIdType> ids;
};

/// \param onPatch the curves of the sources on their patch.
SourceFrames framesBySource(const CurvesOnPatch& onPatch, const Sources& sources);

/// Adds the field data array SourceFrame, with the three vectors of a frame in each tuple, and, if
/// frames have ids, SourceFrameId.
void addSourceFrames(const SourceFrames& frames, vtkDataObject* output);

/// \param property what needs sides, for the message.
/// \throws MeshError where a face and a neighbor do not tell left from right: across an edge of
///         three and more faces, or one whose faces run along it in one direction.
void requireSides(const PolyDataSurface& surface, const std::string& property);

/// Whether the distance from a foot has the sign of a curve's right-hand side: points and loops of
/// the boundary have none.
bool isOnRight(const Foot& foot, const Sources& sources);

}

#endif
