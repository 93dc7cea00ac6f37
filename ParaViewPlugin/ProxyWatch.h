// SPDX-License-Identifier: BSD-3-Clause
#ifndef ProxyWatch_h
#define ProxyWatch_h

/// Watches the filters of this plugin on ParaView's client, from when they appear in the pipeline,
/// and the color maps, scalar bars and representations that show them.
///
/// - The numbers of the last execution (information properties) are asked for after each execution,
///   so that the panel and Python have those of the result that is there. ParaView itself asks when
///   the pipeline's information is updated, which an execution does not do.
/// - ParaView chooses colors when an output is shown first. If the output was empty then, because
///   the first execution had failed, the colors are chosen when there is a result.
/// - Distances are shown in stripes (Stripes.h), lines as tubes, and the first values of a panel
///   are chosen (Lines.h).
///
/// ParaView's XML has no words for this, from 5.11 to 6.1 (Proxy Hints in its documentation).
/// RepresentationType chooses a surface or a wireframe, but neither colors nor widths nor tubes,
/// and none chooses the color map of an array: that comes from the user's settings, and ParaView
/// rescales it, so that stripes would not stay round. An InitializationHelper sees a new filter
/// once, and no execution, representation or color map; its class needs a library with ParaView's
/// wrapping. pqProxy is not there in pvpython.
///
/// The plugin calls this when it is loaded. On a server it does nothing.
void watchGeodesicProxies();

#endif
