// SPDX-License-Identifier: BSD-3-Clause
#ifndef ProxyWatch_h
#define ProxyWatch_h

/// Watches the filters of this plugin on ParaView's client, from when they appear in the pipeline,
/// and the color maps, scalar bars and representations that show them.
///
/// - What a filter tells of its last execution (information properties) ParaView asks for when the
/// pipeline's
///   information is updated, which an execution does not do: here it is asked for after every
///   execution, so that the panel and Python have the numbers of the result that is there.
/// - What colors show ParaView chooses when an output is shown first. Where it was empty then, as
/// the first
///   execution had failed, that is made up for when there is a result.
/// - Distances are shown in stripes (Stripes.h); lines as tubes, and what a panel begins with is
/// chosen (Lines.h).
///
/// The plugin calls this when it is loaded. On a server it does nothing.
void watchGeodesicProxies();

#endif
