// SPDX-License-Identifier: BSD-3-Clause
#ifndef PolylineLabel_h
#define PolylineLabel_h

/// ParaView 5.11 has one widget for splines and polylines, and calls what it shows a spline. From
/// when the plugin is loaded into ParaView's window, the widget of polylines says polyline.
void labelPolylines();

#endif
