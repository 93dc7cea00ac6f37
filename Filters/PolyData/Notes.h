// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Notes_h
#define geodesic_Notes_h

#include "vtkAlgorithmOutput.h"
#include "vtkWeakPointer.h"

#include <string>
#include <tuple>
#include <vector>

class vtkAlgorithm;

namespace geodesic
{

class TriangleMesh;
struct PolyDataBlock;
struct PolyDataSurface;
struct SourceCurves;
struct SourceCells;
struct Targets;

/// The input, by its port, that a note is about.
enum class NoteOn
{
  Surface = 0,
  Source = 1,
  Targets = 2
};

/// A source or targets that are farther from the surface than this fraction of the diagonal of its
/// bounding box, were hardly meant for it: a note says so. What comes from sections, resampled
/// curves and clicks on the surface is much closer.
constexpr double FarFraction = 0.01;

/// Note::cause of a source, or of targets, far from the surface.
inline const char* const FarNote = "far";

/// What the user should know of an execution whose result is right: that something was left out,
/// is not as asked for, or looks like a mistake. What every data set may have and what has no
/// effect (polygons, strips, unused points, faces that repeat another or lie on a line, points that
/// repeat the one before) is no note.
struct Notes
{
  struct Note
  {
    NoteOn input;
    /// The same from one execution to the next as long as the reason is, whatever the numbers in
    /// the text.
    std::string cause;
    std::string text;
  };
  std::vector<Note> all;

  /// "2 lines among the surface's cells dropped."; nothing where the count is 0.
  template <typename Count>
  void add(NoteOn input, Count count, const char* one, const char* many, const char* what)
  {
    if (count > 0)
    {
      this->add(input, what, std::to_string(count) + ' ' + (count == 1 ? one : many) + ' ' + what);
    }
  }
  void add(NoteOn input, const std::string& cause, const std::string& text)
  {
    this->all.push_back({ input, cause, text });
  }
  bool has(NoteOn input, const std::string& cause) const;
};

/// Remembers which notes the user has been given, so that none is said again at every time step or
/// Apply. A note is said again if the execution before had no note of this cause, or if something
/// else has been connected to the note's input port.
class GivenNotes
{
public:
  /// What of the notes of an execution has to be said, a line each; empty where nothing has. They
  /// are given then.
  std::string take(const Notes& notes, vtkAlgorithm* filter);

private:
  /// A note's input and cause, and what was connected there; it may be gone by now.
  using Given = std::tuple<NoteOn, std::string, vtkWeakPointer<vtkAlgorithmOutput>>;
  std::vector<Given> given_;
};

/// What was noticed when the surface was read.
void noteSurface(const PolyDataSurface& surface, Notes& notes);

/// What was noticed when the source was put onto the surface.
///
/// \param mesh on which the source was located.
/// \param source before, and onSurface after that.
/// \param beyond a source that is farther away than this fraction of the surface's diagonal is far.
void noteSource(const PolyDataSurface& surface, const TriangleMesh& mesh, const SourceCells& source,
  const SourceCurves& onSurface, double beyond, Notes& notes);

/// What makes signs of distances ambiguous: curves, as put onto the surface, that run over
/// themselves or each other in opposite directions.
void noteSides(
  const TriangleMesh& mesh, const SourceCells& source, const SourceCurves& onSurface, Notes& notes);

/// What was noticed when targets were put onto the surface. All ranks call this together and note
/// the same.
///
/// \param blocks whose points they are.
/// \param input the one with these blocks.
void noteTargets(const PolyDataSurface& surface, const std::vector<PolyDataBlock>& blocks,
  const Targets& targets, NoteOn input, Notes& notes);
/// The same of sets of targets, which are on the surface in one process.
void noteTargetSets(const PolyDataSurface& surface, const TriangleMesh& mesh,
  const SourceCells& targets, NoteOn input, Notes& notes);

}

#endif
