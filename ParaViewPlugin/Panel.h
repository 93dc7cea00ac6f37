// SPDX-License-Identifier: BSD-3-Clause
#ifndef Panel_h
#define Panel_h

class QEvent;
class QObject;

/// What ParaView's panel of properties lacks, given the events of all its widgets. Labels are the
/// names of properties in Python: what a property is for stands below its label. Results, which
/// nobody edits, are black as other numbers and can be copied.
void improvePanel(QObject* watched, const QEvent& event);

#endif
