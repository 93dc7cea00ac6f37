// SPDX-License-Identifier: BSD-3-Clause
#ifndef DrawnCurve_h
#define DrawnCurve_h

/// What ParaView's window lacks for drawing a polyline, from when the plugin is loaded into it:
///
/// - Over the view, the key 3 appends the point under the mouse, Backspace removes the last point.
/// - The keys of the panel count as soon as the mouse is over the view, without a click.
/// - ParaView 5.11 has one widget for splines and polylines, and calls what it shows a spline: the
///   one of polylines says polyline.
void helpToDrawCurves();

#endif
