// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Notes_h
#define geodesic_Notes_h

#include <sstream>
#include <string>

namespace geodesic
{

class PolyDataSurface;
struct SourceCurves;

/// Collects what the user should know into one warning.
class Notes
{
public:
  /// "2 lines among the surface's cells dropped."; nothing where the count is 0.
  template <typename Count>
  void add(Count count, const char* one, const char* many, const char* what)
  {
    if (count > 0)
    {
      this->text_ << "\n  " << count << ' ' << (count == 1 ? one : many) << ' ' << what;
    }
  }
  void add(const std::string& sentence) { this->text_ << "\n  " << sentence; }
  std::string text() const { return this->text_.str(); }

private:
  std::ostringstream text_;
};

/// What was noticed when the surface was read.
void noteSurface(const PolyDataSurface& surface, Notes& notes);

/// What was noticed when the source was put onto the surface.
///
/// \param isShown whether output port 1 has the source as it lies there.
void noteSource(
  const PolyDataSurface& surface, const SourceCurves& sources, bool isShown, Notes& notes);

}

#endif
