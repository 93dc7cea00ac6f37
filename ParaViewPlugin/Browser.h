// SPDX-License-Identifier: BSD-3-Clause
#ifndef Browser_h
#define Browser_h

#include <QPersistentModelIndex>
#include <QString>

class QItemSelectionModel;
class QModelIndex;
class QObject;

/// Keeps the pipeline browser of ParaView's window at the filter that was selected. ParaView takes
/// a filter that gets another second input out of the tree and puts it to the end: then something
/// else is selected, or nothing.
class Browser
{
public:
  /// Finds the browser in the window of a widget, once.
  void WatchIn(QObject* widget);

private:
  void Watch(QObject* browser, QItemSelectionModel* selection);

  /// Notes the name of a filter whose item goes while it, or an output of it, is selected.
  void NoteLoss(const QModelIndex& selected, const QModelIndex& parent, int first, int last);

  void SelectLost(QObject* browser, QItemSelectionModel* selection);

  QObject* Watched = nullptr; // only to be compared
  /// What was selected before, until the event that has changed this is over.
  QPersistentModelIndex Left;
  QString Lost;
};

#endif
