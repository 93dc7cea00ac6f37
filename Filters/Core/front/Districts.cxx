// SPDX-License-Identifier: BSD-3-Clause
#include "front/Districts.h"

#include "mesh/Box.h"

#include <algorithm>
#include <cmath>

namespace geodesic
{

namespace
{

/// Boxes of a grid around the mesh, in the order of a curve that goes through all of one octant
/// before the next (Morton 1966).
class BoxesInOrder
{
public:
  BoxesInOrder(const TriangleMesh& mesh, const ParallelFor& parallelFor)
  {
    const Box all = boxOfItems(parallelFor, mesh.numberOfVertices(),
      [&mesh](Box& box, std::size_t vertex) { box.add(mesh.point(static_cast<Id>(vertex))); });
    this->least_ = all.low;
    const Vec3 extent = all.high - all.low;
    const double largest = std::max({ extent[0], extent[1], extent[2] });
    this->boxesPerLength_ = largest > 0.0 ? Side / largest : 0.0;
  }

  static constexpr std::size_t Count = std::size_t(1) << 18;

  std::size_t of(const Vec3& point) const
  {
    const auto bits = [&](std::size_t axis)
    { return spread((point[axis] - this->least_[axis]) * this->boxesPerLength_); };
    return bits(0) << 2 | bits(1) << 1 | bits(2);
  }

private:
  static constexpr double Side = 64.0;

  // The bits of the box's number along an axis, each three places from the next.
  static std::size_t spread(double place)
  {
    auto bits = static_cast<std::size_t>(std::clamp(place, 0.0, Side - 1.0));
    bits = (bits | bits << 8) & 0x300fU;
    bits = (bits | bits << 4) & 0x30c3U;
    return (bits | bits << 2) & 0x9249U;
  }

  Vec3 least_ = {};
  double boxesPerLength_ = 0.0;
};

// As the width of a front, which goes with the root of the vertices: some of what is left to do for
// all districts together is done for each of them, and windows that go from one to another are
// work.
Id numberOfDistricts(Id vertices)
{
  constexpr double rootsEach = 8.0;
  const double count = std::sqrt(static_cast<double>(vertices)) / rootsEach;
  return std::clamp<Id>(static_cast<Id>(count), 1, Districts::Most);
}

} // anonymous namespace

Districts::Districts(const TriangleMesh& mesh, const ParallelFor& parallelFor)
  : size_(numberOfDistricts(mesh.numberOfVertices()))
  , districts_(mesh.numberOfVertices(), 0)
{
  if (this->size_ == 1)
  {
    return;
  }
  const BoxesInOrder boxes(mesh, parallelFor);
  std::vector<std::uint32_t> boxOf(mesh.numberOfVertices());
  forRanges(parallelFor, boxOf.size(),
    [&](std::size_t begin, std::size_t end)
    {
      for (Id vertex = static_cast<Id>(begin); vertex < end; ++vertex)
      {
        boxOf[vertex] = static_cast<std::uint32_t>(boxes.of(mesh.point(vertex)));
      }
    });
  std::vector<std::uint32_t> numberIn(BoxesInOrder::Count, 0);
  for (const std::uint32_t box : boxOf)
  {
    ++numberIn[box];
  }
  std::vector<std::uint8_t> ofBox(BoxesInOrder::Count);
  std::uint64_t before = 0;
  for (std::size_t box = 0; box < BoxesInOrder::Count; ++box)
  {
    const std::uint64_t middle = 2 * before + numberIn[box];
    ofBox[box] = static_cast<std::uint8_t>(std::min<std::uint64_t>(
      middle * this->size_ / (2 * mesh.numberOfVertices()), this->size_ - 1));
    before += numberIn[box];
  }
  std::transform(boxOf.begin(), boxOf.end(), this->districts_.begin(),
    [&ofBox](std::uint32_t box) { return ofBox[box]; });
}

}
