// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/AdaptiveRefinement.h"

#include "Errors.h"
#include "refinement/SurfaceRefiner.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace geodesic
{

namespace
{

/// Refines to the smallest tolerance for which there is room, found by trial: in the range between
/// one without room and one with room, the next is where triangles in inverse proportion to the
/// tolerance would just fill the room, or the middle of the range's logarithms. A run without room
/// stops early.
std::unique_ptr<SurfaceRefiner> refineWithinRoom(
  const DistanceField& field, const RefinementOptions& options)
{
  constexpr double EnoughOfRoom = 0.97;
  constexpr int MostRuns = 16;
  std::unique_ptr<SurfaceRefiner> best;
  double fits = Infinity;
  double tooSmall = options.tolerance;
  const std::uint64_t maximum = options.maximumFaces;
  const bool isRoom = maximum == 0 || maximum >= field.surface().numberOfGlobalFaces();
  double growth = 4.0; // 4, 16, 256 ... times the tolerance until there is room
  for (int run = 0; isRoom && run < MostRuns; ++run)
  {
    double next = growth * options.tolerance;
    if (best)
    {
      const double full = fits * best->shareOfRoom();
      next = full > tooSmall ? full : std::sqrt(fits * tooSmall);
    }
    auto refiner = std::make_unique<SurfaceRefiner>(field, options, next);
    if (!refiner->run())
    {
      tooSmall = next;
      growth *= growth;
      continue;
    }
    best = std::move(refiner);
    fits = next;
    if (best->shareOfRoom() >= EnoughOfRoom)
    {
      break;
    }
  }
  if (!best) // the surface as it is
  {
    best = std::make_unique<SurfaceRefiner>(field, options, Infinity);
    best->run();
  }
  return best;
}

void requireUsable(const DistanceField& field, const RefinementOptions& options)
{
  if (!(options.tolerance > 0.0) || !(options.tolerance < Infinity))
  {
    throw Error("The refinement tolerance is " + std::to_string(options.tolerance) +
      "; give a positive number.");
  }
  if (!field.hasWindows())
  {
    throw Error("A field is to be refined, but the solve kept no windows; solve for refinement.");
  }
  if (options.tolerance < field.droppedTolerance())
  {
    throw Error("The refinement tolerance is " + std::to_string(options.tolerance) +
      ", but windows were kept for " + std::to_string(field.droppedTolerance()) + " only.");
  }
  if (!options.cornerPoints.empty() && options.cornerPoints.size() != field.mesh().numberOfFaces())
  {
    throw Error("Refinement was given points for the corners of " +
      std::to_string(options.cornerPoints.size()) + " faces, but the mesh has " +
      std::to_string(field.mesh().numberOfFaces()) + ".");
  }
}

} // anonymous namespace

RefinedMesh refine(const DistanceField& field, const RefinementOptions& options)
{
  requireUsable(field, options);
  const Job output = options.job.part(SurfaceRefiner::JobOfRun, 1.0);
  auto refiner = std::make_unique<SurfaceRefiner>(field, options, options.tolerance);
  if (refiner->run())
  {
    return refiner->result(output);
  }
  refiner.reset();
  RefinedMesh result = refineWithinRoom(field, options)->result(output);
  result.stoppedAtMaximum = true;
  return result;
}

}
