// SPDX-License-Identifier: BSD-3-Clause
#include "front/Districts.h"

#include "mesh/Box.h"

#include <algorithm>
#include <cmath>

namespace geodesic
{

namespace
{

/// Boxes of a grid around the mesh, in Morton order: a curve that visits all boxes of one octant
/// before the next (Morton 1966).
class BoxesInOrder
{
public:
  BoxesInOrder(const TriangleMesh& mesh, const Job& job)
  {
    const Box all = boxOfItems(job, mesh.numberOfVertices(),
      [&mesh](Box& box, std::size_t vertex) { box.add(mesh.point(static_cast<Id>(vertex))); });
    // A finer grid than the vertices need would take more memory than they do.
    constexpr std::size_t mostBoxesAVertex = 4;
    while (this->levels_ > 1 && this->count() > mostBoxesAVertex * mesh.numberOfVertices())
    {
      --this->levels_;
    }
    this->least_ = all.low;
    const Vec3 extent = all.high - all.low;
    const double largest = std::max({ extent[0], extent[1], extent[2] });
    this->boxesPerLength_ = largest > 0.0 ? this->side() / largest : 0.0;
  }

  std::size_t count() const { return std::size_t(1) << 3 * this->levels_; }

  std::size_t of(const Vec3& point) const
  {
    const auto bits = [&](std::size_t axis)
    { return this->spread((point[axis] - this->least_[axis]) * this->boxesPerLength_); };
    return bits(0) << 2 | bits(1) << 1 | bits(2);
  }

private:
  double side() const { return static_cast<double>(1U << this->levels_); }

  // Spreads the bits of the box's number along an axis to every third coordinate.
  std::size_t spread(double coordinate) const
  {
    auto bits = static_cast<std::size_t>(std::clamp(coordinate, 0.0, this->side() - 1.0));
    bits = (bits | bits << 8) & 0x300fU;
    bits = (bits | bits << 4) & 0x30c3U;
    return (bits | bits << 2) & 0x9249U;
  }

  unsigned levels_ = 6;
  Vec3 least_ = {};
  double boxesPerLength_ = 0.0;
};

// Proportional to the width of a front, that is, to the root of the number of vertices: every
// district adds some work to each batch, and windows that cross between districts are work too.
Id numberOfBlocks(Id vertices)
{
  constexpr double rootsEach = 8.0;
  const double count = std::sqrt(static_cast<double>(vertices)) / rootsEach;
  return std::clamp<Id>(static_cast<Id>(count), 1, Districts::Most);
}

// The block of each vertex: of boxes that follow one another, with as many vertices as the others.
std::vector<std::uint8_t> blocksOf(const TriangleMesh& mesh, Id count, const Job& job)
{
  const BoxesInOrder boxes(mesh, job);
  std::vector<std::uint32_t> boxOf(mesh.numberOfVertices());
  job.loop(boxOf.size(),
    [&](std::size_t vertex)
    { boxOf[vertex] = static_cast<std::uint32_t>(boxes.of(mesh.point(static_cast<Id>(vertex)))); });
  std::vector<std::uint32_t> numberIn(boxes.count(), 0);
  for (const std::uint32_t box : boxOf)
  {
    ++numberIn[box];
  }
  std::vector<std::uint8_t> ofBox(boxes.count());
  std::uint64_t before = 0;
  for (std::size_t box = 0; box < boxes.count(); ++box)
  {
    const std::uint64_t middle = 2 * before + numberIn[box];
    ofBox[box] = static_cast<std::uint8_t>(
      std::min<std::uint64_t>(middle * count / (2 * mesh.numberOfVertices()), count - 1));
    before += numberIn[box];
  }
  std::vector<std::uint8_t> blocks(mesh.numberOfVertices());
  std::transform(
    boxOf.begin(), boxOf.end(), blocks.begin(), [&ofBox](std::uint32_t box) { return ofBox[box]; });
  return blocks;
}

} // anonymous namespace

Districts::Districts(const TriangleMesh& mesh, const Job& job)
{
  const Id blocks = numberOfBlocks(mesh.numberOfVertices());
  if (blocks > 1)
  {
    this->blocks_ = blocksOf(mesh, blocks, job);
  }
  this->most_ = job.isParallel() ? blocks : 1;
  this->join(false);
}

void Districts::sort(std::vector<Id>& vertices) const
{
  if (this->blocks_.empty() || vertices.size() < 2)
  {
    std::sort(vertices.begin(), vertices.end());
    return;
  }
  std::vector<std::uint64_t> inBlocks(vertices.size());
  std::transform(vertices.begin(), vertices.end(), inBlocks.begin(),
    [this](Id vertex) { return std::uint64_t(this->blocks_[vertex]) << 32 | vertex; });
  std::sort(inBlocks.begin(), inBlocks.end());
  std::transform(inBlocks.begin(), inBlocks.end(), vertices.begin(),
    [](std::uint64_t inBlock) { return static_cast<Id>(inBlock); });
}

}
