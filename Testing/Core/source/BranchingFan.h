// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesictest_BranchingFan_h
#define geodesictest_BranchingFan_h

#include "truth/TestMeshes.h"

#include <cmath>

namespace geodesictest
{

/// Faces around vertex 0 in stages of two faces each, one sheet above and one below the plane,
/// which share the stage's two edges. So an edge between two stages has four faces, and there are
/// 2^stages ways from one end to the other. Both sheets have the same shape. Another face lies
/// behind each.
class BranchingFan
{
public:
  /// \param angle from the first edge to the last one, in the plane.
  /// \param sheets 2, or 1 for the sheet above only.
  BranchingFan(Index stages, double angle, Index sheets = 2)
    : stages_(stages)
    , angle_(angle)
    , height_(0.2 * angle / stages)
  {
    this->mesh.points.push_back({ 0.0, 0.0, 0.0 });
    for (Index i = 0; i <= stages; ++i)
    {
      this->mesh.points.push_back(this->around(i, 1.0, 0.0)); // vertex 1 + i
    }
    for (Index sheet = 0; sheet < sheets; ++sheet)
    {
      const double height = sheet == 0 ? this->height_ : -this->height_;
      for (Index i = 0; i < stages; ++i)
      {
        const Index middle = this->add(this->around(i + 0.5, 1.0, height));
        this->addFace(1 + i, middle, this->around(i + 0.25, 1.4, height));
        this->addFace(middle, 2 + i, this->around(i + 0.75, 1.4, height));
      }
    }
  }

  /// Faces at vertex 0 have even numbers, sheet by sheet from the first edge to the last.
  PlainMesh mesh;

  /// The angle at vertex 0 of each of the faces there.
  double faceAngle() const
  {
    const Vec3& p = this->mesh.points[1];
    const Vec3& q = this->mesh.points[this->stages_ + 2];
    const Vec3 normal = { p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2],
      p[0] * q[1] - p[1] * q[0] };
    return std::atan2(
      std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]),
      p[0] * q[0] + p[1] * q[1] + p[2] * q[2]);
  }

private:
  Vec3 around(double stage, double radius, double height) const
  {
    const double a = this->angle_ * stage / this->stages_;
    return { radius * std::cos(a), radius * std::sin(a), height };
  }
  Index add(const Vec3& point)
  {
    this->mesh.points.push_back(point);
    return static_cast<Index>(this->mesh.points.size() - 1);
  }
  void addFace(Index a, Index b, const Vec3& behind)
  {
    const Index outer = this->add(behind);
    this->mesh.triangles.push_back({ 0, a, b });
    this->mesh.triangles.push_back({ b, a, outer });
  }

  Index stages_;
  double angle_;
  double height_;
};

}

#endif
