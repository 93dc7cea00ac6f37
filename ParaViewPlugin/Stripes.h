// SPDX-License-Identifier: BSD-3-Clause
#ifndef Stripes_h
#define Stripes_h

class vtkSMProxy;

/// Color maps of stripes: each stripe covers the same round distance, 1, 2 or 5 times a power of
/// ten. Every second stripe is darker. Distances run from near to far colors; signed distances are
/// red on the left of the source, blue on its right, and both sides have the same range.
namespace stripes
{

/// Adds both color maps to ParaView's list of presets, unless the list has them.
void addPresets();

/// Whether a color map (a proxy of the group lookup_tables) consists of stripes, whatever their
/// width.
bool areIn(vtkSMProxy* table);

/// Fills a color map with stripes for distances up to that of the larger end of its range.
void fill(vtkSMProxy* table, bool isSigned);

/// Where ParaView has rescaled stripes to the range of data, they become round again.
void makeRound(vtkSMProxy* table);

/// A color map gets gray for what is not reached, if there is such a thing; else there is no gray
/// box at its scalar bars.
void setUnreached(vtkSMProxy* table, bool isUnreached);

/// Gives the scalar bar (or all scalar bars) of a color map ticks where stripes meet, and the
/// word for gray.
void setTicks(vtkSMProxy* bar, vtkSMProxy* table);
void setTicks(vtkSMProxy* table);

/// The scalar bars of a color map get the ticks of ParaView again.
void resetTicks(vtkSMProxy* table);

/// The ids of sources have one color each, with the id beside it in the scalar bar, unless there
/// are too many to be told apart, or the user has chosen other colors. If nothing is unreached
/// there is no word for that.
void showIds(vtkSMProxy* table, bool isUnreached);

/// The smallest number 1, 2 or 5 times a power of ten that fits into a length at most that often;
/// the length itself where it is not positive and finite.
double roundStep(double length, int atMost);

}

#endif
