// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lines_h
#define Lines_h

#include <vector>

class vtkSMPVRepresentationProxy;
class vtkSMProxy;
class vtkSMSourceProxy;

/// What a user sees first of the outputs that are lines on a surface, and of a contour's distances.
namespace lines
{

/// Whether a filter is of this plugin.
bool isGeodesicFilter(vtkSMSourceProxy* filter);

/// Whether a filter gives distances at the points of a surface.
bool isField(vtkSMSourceProxy* filter);

/// Whether two filters have the same input of a name.
bool haveSame(const char* input, vtkSMProxy* a, vtkSMProxy* b);

/// Whether an output of a filter of this plugin is lines on a surface.
bool areOutput(vtkSMSourceProxy* filter, unsigned int port);

/// Shows lines and points in one color that neither stripes nor ParaView's white surfaces have, and
/// contours in another one than sources, as tubes and balls, which stand out of the surface that
/// they lie on.
void show(vtkSMPVRepresentationProxy* representation);

/// Rounds the default distance of a contour to 1, 2 or 5 times a power of ten.
void roundDefaultDistance(vtkSMSourceProxy* filter);

/// A filter without a Source gets the only other data set of the pipeline that consists of curves
/// and points. What the filters of this plugin have made does not count, nor data on another
/// machine.
void chooseOnlySource(vtkSMSourceProxy* filter);

/// The largest distance that a field has found; 0 before it is executed, and for other filters.
double largestDistance(vtkSMSourceProxy* filter);

/// Whether an execution has left points of faces without a distance, which NaN or infinity stands
/// for. Points that no face uses do not count: nothing of them is seen.
bool hasUnreached(vtkSMSourceProxy* filter);

/// The two points of a curve that is there before it is drawn, above the surface, go to the
/// surface's nearest points.
void putDefaultCurveOnSurface(vtkSMSourceProxy* filter);

/// Fills in those numbers on the panel that the client finds in the output.
void setResults(vtkSMSourceProxy* filter);

/// ParaView makes series of a contour's distances up to the largest distance that any of the
/// filters has found on the same surface, from the same source if possible. If there is none: to
/// the longest side of the surface's bounding box.
void setRangeOfDistances(vtkSMSourceProxy* contour, const std::vector<vtkSMSourceProxy*>& filters);

}

#endif
