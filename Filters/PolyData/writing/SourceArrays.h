// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SourceArrays_h
#define geodesic_SourceArrays_h

#include "PolyData/reading/PolyDataSurface.h"
#include "Progress.h"
#include "field/NearestSource.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace geodesic
{

struct RefinedMesh;
struct RefinedPoint;
struct SeamPoints;

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

/// Adds the arrays that are asked for, without values.
void addEmptyArrays(const SourceArrayChoice& choice, vtkPolyData* output);

/// Where a shortest path ends on its source: on the left of a curve, where loops of the boundary
/// have all their paths, on its right, or at a point, which has no sides.
enum class SourceSide : std::uint8_t
{
  Left,
  Right,
  Point
};

/// What the arrays are computed from, for some points: one entry per point, in those members that
/// the choice of arrays needs.
struct SourceValues
{
  /// SourceCurve::source; NoId where the point was not reached.
  std::vector<Id> sources;
  /// In the user's scale; not told where the point was not reached.
  std::vector<Vec3> closestPoints;
  std::vector<Vec3> gradients;
  std::vector<SourceSide> sides;
  /// In the user's scale.
  std::vector<double> arcLengths;
  std::vector<double> angles;
};

/// Computes the arrays that tell more of a field than its distance.
class SourceArrays
{
public:
  /// \param curves of the source.
  /// \param firstBoundarySource SourceCurve::source from which on curves are loops of the boundary,
  ///        whose distances have no sign.
  SourceArrays(const PolyDataSurface& surface, const std::vector<SourceCurve>& curves,
    Id firstBoundarySource, const SourceArrayChoice& choice)
    : surface_(surface)
    , curves_(curves)
    , firstBoundarySource_(firstBoundarySource)
    , choice_(choice)
  {
  }

  /// Of every vertex of this rank's own faces. All ranks call this together.
  ///
  /// \param computed the field that gradients are of, with arrivals.
  SourceValues atVertices(const DistanceField& computed, const NearestSource& nearest,
    const ProgressCallback& progress) const;
  /// Adds values for the other vertices that points have: PolyDataSurface::completeValues(). All
  /// ranks call this together.
  void completeValues(SourceValues& atVertices) const;
  /// Of points that refinement has added. All ranks call this together.
  ///
  /// \param count of the first points: those whose places on the mesh are known.
  /// \param exact the field that feet are of, with arrivals; the computed one or another.
  SourceValues atPoints(const std::vector<RefinedPoint>& points, std::size_t count,
    const DistanceField& computed, const DistanceField& exact, NearestSource& nearest,
    const ProgressCallback& progress) const;
  /// Gives points on seams the values of the rank that knows them best. All ranks call this
  /// together.
  void replaceAtSeams(const SeamPoints& seams, SourceValues& atNewPoints) const;
  /// Appends to the values at the new points of refinement those at copies of such points. All
  /// ranks call this together.
  ///
  /// \param copied what addUnmeshedTriangles() returns.
  void appendCopies(const std::vector<RankAddress>& copied, SourceValues& atNewPoints) const;
  /// The values at the new points of each block: see partsByBlock().
  ///
  /// \param refined the mesh whose points they are at.
  std::vector<SourceValues> valuesByBlock(
    SourceValues atNewPoints, const RefinedMesh& refined) const;

  /// Adds the arrays of one block to its points: those of the input, then those that were added.
  ///
  /// \param distances of the same points; infinite where a point is not reached.
  /// \param unreached what stands there in the arrays of lengths and angles.
  void write(const SurfaceBlock& block, const SourceValues& atVertices,
    const SourceValues& atNewPoints, const double* distances, double unreached,
    vtkPolyData* output) const;

  /// framesBySource(). Empty unless angles are asked for.
  std::vector<SourceFrame> frames(const NearestSource& nearest) const;
  /// For writeCurves(): the arc lengths of each curve's points, in the user's scale. Empty unless
  /// arc lengths are asked for.
  std::vector<std::vector<double>> arcLengthsOfCurves(const NearestSource& nearest) const;

private:
  template <typename Visit>
  void forEachKind(const Visit& visit) const;
  template <typename Add>
  SourceValues collect(std::size_t count, const DistanceField& computed,
    const ProgressCallback& progress, const Add& add) const;
  void reserve(std::size_t count, SourceValues& values) const;
  void add(const Foot& foot, const NearestSource& nearest, SourceValues& values) const;
  SourceSide sideOf(const Foot& foot) const;

  const PolyDataSurface& surface_;
  const std::vector<SourceCurve>& curves_;
  Id firstBoundarySource_;
  SourceArrayChoice choice_;
};

/// The frames that angles are measured in, by SourceCurve::source; of a source that is cut in
/// several curves, that of the first.
///
/// \param frameOf the frame of a curve, by its number.
template <typename FrameOf>
std::vector<SourceFrame> framesBySource(
  const std::vector<SourceCurve>& curves, const FrameOf& frameOf)
{
  std::vector<SourceFrame> frames;
  for (Id curve = static_cast<Id>(curves.size()); curve-- > 0;) // the first of a source comes last
  {
    const std::size_t source = curves[curve].source;
    frames.resize(std::max(frames.size(), source + 1));
    frames[source] = frameOf(curve);
  }
  return frames;
}

/// Adds the field data array SourceFrame, with the three vectors of a frame in each tuple.
void addSourceFrames(const std::vector<SourceFrame>& frames, vtkDataObject* output);

/// A face whose neighbours do not tell left from right with it: across an edge of three and more
/// faces, or one whose faces run along it in one direction. NoId where there is none of the faces
/// from the first to before the end.
Id findFaceWithoutSides(const TriangleMesh& mesh, Id first, Id end);

/// \param inputs the blocks that the surface was read from.
/// \param property what needs sides, for the message.
/// \throws MeshError where findFaceWithoutSides() finds one.
void requireSides(const PolyDataSurface& surface, const std::vector<PolyDataBlock>& inputs,
  const std::string& property);

/// Whether the distance from a foot has the sign of a curve's right-hand side: points and loops of
/// the boundary have none.
bool isOnRight(const Foot& foot, const std::vector<SourceCurve>& curves, Id firstBoundarySource);

}

#endif
