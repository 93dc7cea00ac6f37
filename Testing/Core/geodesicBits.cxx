// SPDX-License-Identifier: BSD-3-Clause
// Prints hashes of all bits that the engine computes, on a mesh of each kind and on those files of
// the folder GEODESIC_TEST_MESHES that the arguments name. Builds by any compiler print the same on
// any processor.
#include "EngineSupport.h"
#include "truth/MeshFiles.h"

#include "contours/Isolines.h"
#include "contours/SolveForIsolines.h"
#include "field/NearestSource.h"
#include "refinement/AdaptiveRefinement.h"
#include "refinement/SolveForRefinement.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <limits>

using namespace geodesictest;
using geodesic::DistanceField;
using geodesic::SourceCurve;
using geodesic::SurfacePoint;
using geodesic::TriangleMesh;

namespace
{

std::uint64_t bitsOf(double number)
{
  std::uint64_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  return bits;
}

/// FNV-1a (Fowler, Noll, Vo) of numbers.
class Hash
{
public:
  void add(std::uint64_t number)
  {
    for (int shift = 0; shift < 64; shift += 8)
    {
      this->value_ = (this->value_ ^ ((number >> shift) & 0xffU)) * 0x100000001b3U;
    }
  }
  void add(double number)
  {
    this->add(number != number ? 0 : bitsOf(number)); // the bits of NaN mean nothing
  }
  void add(geodesic::Id id) { this->add(static_cast<std::uint64_t>(id)); }
  template <typename Items>
  void add(const Items& items)
  {
    this->add(static_cast<std::uint64_t>(std::size(items)));
    for (const auto& item : items)
    {
      this->add(item);
    }
  }
  void print() const { std::printf(" %016llx", static_cast<unsigned long long>(this->value_)); }

private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

/// A mesh with sources and targets.
class Case
{
public:
  Case(const PlainMesh& plain, Random& random)
    : mesh_(engineMesh(plain))
    , curves_(engineCurves(mesh_, CurveMaker(plain, random).anySource()))
  {
    for (const MeshPoint& point : randomPoints(plain, 100, random))
    {
      this->targets_.push_back(enginePoint(this->mesh_, point));
    }
  }

  void printAll()
  {
    this->input().print();
    this->distances(0.0).print();
    this->distances(0.01).print();
    this->anglesAndGradients().print();
    this->paths().print();
    this->isolines().print();
    this->refined().print();
    std::printf("\n");
  }

private:
  Hash input() const
  {
    Hash hash;
    for (geodesic::Id face = 0; face < this->mesh_.numberOfFaces(); ++face)
    {
      hash.add(this->mesh_.triangle(face));
    }
    for (geodesic::Id vertex = 0; vertex < this->mesh_.numberOfVertices(); ++vertex)
    {
      hash.add(this->mesh_.point(vertex));
    }
    for (const SourceCurve& curve : this->curves_)
    {
      this->addPlaces(curve.points, hash);
    }
    this->addPlaces(this->targets_, hash);
    return hash;
  }

  Hash distances(double relativeError)
  {
    const DistanceField field = solveKeepingAll(this->mesh_, this->curves_, relativeError);
    Hash hash;
    hash.add(field.vertexDistances());
    hash.add(field.relativeErrorBound());
    for (const SurfacePoint& target : this->targets_)
    {
      hash.add(field.distance(target));
    }
    if (relativeError == 0.0) // what follows does not change with the approximation
    {
      this->largest_ = largestFinite(field.vertexDistances());
    }
    return hash;
  }

  Hash anglesAndGradients() const
  {
    geodesic::FrontOptions options;
    options.keepArrivals = true;
    options.keepAngles = true;
    const DistanceField field =
      geodesic::solve(this->mesh_, this->curves_, options, geodesic::KeepWindows::All);
    geodesic::NearestSource nearest(field, geodesic::ReplicatedPatch(this->mesh_), this->curves_);
    Hash hash;
    const auto add = [&](const geodesic::Foot& foot)
    {
      hash.add(foot.curve);
      if (foot.isKnown())
      {
        hash.add(nearest.arcLengthOf(foot));
        hash.add(nearest.angleOf(foot));
      }
    };
    for (geodesic::Id vertex = 0; vertex < this->mesh_.numberOfVertices(); ++vertex)
    {
      add(nearest.atVertex(vertex));
    }
    for (const SurfacePoint& target : this->targets_)
    {
      const geodesic::IncomingSegment piece = geodesic::incomingSegmentTo(field, target);
      add(nearest.of(piece));
      hash.add(geodesic::gradientOf(this->mesh_, piece));
    }
    return hash;
  }

  Hash paths() const
  {
    Hash hash;
    for (const FoundPath& path : findPaths(this->mesh_, this->curves_, this->targets_))
    {
      hash.add(path.places);
      hash.add(path.source);
    }
    return hash;
  }

  Hash isolines() const
  {
    geodesic::IsolineOptions options;
    options.values = { 0.2 * this->largest_, 0.5 * this->largest_, 0.8 * this->largest_ };
    options.chordTolerance = 1e-4 * this->largest_;
    const geodesic::Isolines drawn =
      geodesic::drawIsolines(solveForIsolines(this->mesh_, this->curves_, options.values), options);
    Hash hash;
    this->addPlaces(drawn.points, hash);
    for (const geodesic::Isoline& line : drawn.lines)
    {
      hash.add(line.points);
    }
    return hash;
  }

  Hash refined() const
  {
    geodesic::RefinementOptions options;
    options.tolerance = 1e-3 * this->largest_;
    const geodesic::RefinedMesh refined =
      geodesic::refine(solveForRefinement(this->mesh_, this->curves_, options.tolerance), options);
    Hash hash;
    hash.add(refined.triangles);
    hash.add(refined.errorBound);
    for (const geodesic::RefinedPoint& point : refined.points)
    {
      hash.add(point.position);
      hash.add(point.distance);
    }
    return hash;
  }

  void addPlaces(const std::vector<SurfacePoint>& points, Hash& hash) const
  {
    for (const SurfacePoint& point : points)
    {
      hash.add(geodesic::position(this->mesh_, point));
    }
  }

  TriangleMesh mesh_;
  std::vector<SourceCurve> curves_;
  std::vector<SurfacePoint> targets_;
  double largest_ = 0.0;
};

/// Rounds to 24 binary digits, and to zero what is as small as the rounding of the largest
/// coordinate: the library's sines, in some meshes, differ there. By bits, as GCC 12 forgets to
/// round where it vectorizes a loop that converts to float and back.
PlainMesh rounded(PlainMesh mesh)
{
  constexpr std::uint64_t unit = std::uint64_t{ 1 } << 29U;
  double largest = 0.0;
  for (const Vec3& point : mesh.points)
  {
    for (const double coordinate : point)
    {
      largest = std::max(largest, std::abs(coordinate));
    }
  }
  for (Vec3& point : mesh.points)
  {
    for (double& coordinate : point)
    {
      const bool isRounding =
        std::abs(coordinate) < largest * std::numeric_limits<double>::epsilon();
      const std::uint64_t bits = isRounding ? 0 : (bitsOf(coordinate) + unit / 2) & ~(unit - 1);
      std::memcpy(&coordinate, &bits, sizeof bits);
    }
  }
  return mesh;
}

} // anonymous namespace

int main(int argc, char* argv[])
{
  std::printf("mesh input exact approximate angles paths isolines refined\n");
  const auto print = [](const char* name, const PlainMesh& mesh, Random& random)
  {
    std::printf("%s", name);
    Case(mesh, random).printAll();
  };
  for (const MeshKind& kind : meshKinds())
  {
    Random random(2007);
    const PlainMesh mesh = rounded(kind.make(1000, random));
    print(kind.name, mesh, random);
  }
  for (int i = 1; i < argc; ++i)
  {
    Random random(2007);
    print(argv[i], rounded(readMesh(argv[i])), random);
  }
  return 0;
}
