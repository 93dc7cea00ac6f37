// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceCheck_h
#define geodesic_FaceCheck_h

#include "field/FaceDistance.h"
#include "field/SegmentEnvelope.h"
#include "refinement/RefinedFaces.h"
#include "refinement/TriangleError.h"

#include <cstdint>
#include <unordered_map>

namespace geodesic
{

/// Compares the triangles of a face under refinement with the distance. One object serves one face
/// after another and reuses its memory.
class FaceCheck
{
public:
  struct Result
  {
    bool hasPassed;
    double bound;
    /// A difference that does occur.
    double sample;
    /// The limit for differences within the face.
    double limit;
  };

  /// \param faces must outlive this.
  FaceCheck(const RefinedFaces& faces, double tolerance)
    : faces_(faces)
    , tolerance_(tolerance)
    , error_(faces.field)
    , distance_(faces.field)
  {
  }

  void enter(const FaceTriangles& face);
  const FaceDistance& distance() const { return this->distance_; }
  /// The deviation along a side between two points of the face.
  Deviation deviationOf(Id a, Id b);
  /// \param isTight whether the bound has to be close to a difference that does occur, also over
  ///        the tolerance.
  Result of(const Triangle& corners, bool isTight);

private:
  const RefinedFaces& faces_;
  double tolerance_;
  TriangleError error_;
  SegmentEnvelope envelope_;
  FaceDistance distance_;
  const FaceTriangles* face_ = nullptr;
  /// The deviations along sides inside the face, from the lower point to the higher one.
  std::unordered_map<std::uint64_t, Deviation> inside_;
};

}

#endif
