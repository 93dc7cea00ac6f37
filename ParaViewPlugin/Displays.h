// SPDX-License-Identifier: BSD-3-Clause
#ifndef Displays_h
#define Displays_h

class vtkSMPVRepresentationProxy;
class vtkSMSourceProxy;

/// What ParaView's window does for what it shows of a filter, beside colors.
namespace displays
{

/// The length of a drawn curve, or of a single path, stands as words in the view that shows the
/// filter, as long as a representation of the line is visible.
void labelLength(vtkSMSourceProxy* filter, vtkSMPVRepresentationProxy* line);

/// A texture that is chosen for a field takes the place of the colors, and is repeated if the
/// field says so; when it is taken away, the distance is shown in colors again.
void makeRoomForTexture(vtkSMSourceProxy* field, vtkSMPVRepresentationProxy* surface);

}

#endif
