// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Stages_h
#define geodesic_Stages_h

#include <algorithm>
#include <iterator>

namespace geodesic
{

/// The stages of an execution, in their order. No filter has all of them.
enum class Stage
{
  ReadSurface,
  LocateSource,
  JoinSource,
  ReadTargets,
  SolveForTargets,
  FindBorders,
  Solve,
  Refine,
  SolveExactly,
  FindSources,
  DrawLines,
  FindSides,
  Write
};

/// What an execution is doing in a stage, for messages; and how long that takes, compared with the
/// other stages.
struct StageRow
{
  Stage stage;
  const char* doing;
  double share;
};

constexpr StageRow Stages[] = {
  { Stage::ReadSurface, "reading the surface", 15.0 },
  { Stage::LocateSource, "putting the source onto the surface, after reading the surface", 5.0 },
  { Stage::JoinSource, "putting the source onto the surface, after reading the surface", 5.0 },
  { Stage::ReadTargets,
    "putting the targets onto the surface, after reading the surface and the source", 5.0 },
  { Stage::SolveForTargets, "computing the distances, after reading the surface and the source",
    70.0 },
  { Stage::FindBorders, "computing the distances, after reading the surface and the source", 5.0 },
  { Stage::Solve, "computing the distances, after reading the surface and the source", 30.0 },
  { Stage::Refine, "refining the surface, after computing the distances", 40.0 },
  { Stage::SolveExactly, "computing the distances, after reading the surface and the source",
    25.0 },
  { Stage::FindSources, "computing the distances, after reading the surface and the source", 5.0 },
  { Stage::DrawLines, "drawing the lines, after computing the distances", 20.0 },
  { Stage::FindSides, "drawing the lines, after computing the distances", 10.0 },
  { Stage::Write, "writing the outputs, after all was computed", 5.0 },
};

inline const StageRow& rowOf(Stage stage)
{
  return *std::find_if(std::begin(Stages), std::end(Stages),
    [stage](const StageRow& row) { return row.stage == stage; });
}

}

#endif
