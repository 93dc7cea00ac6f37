// SPDX-License-Identifier: BSD-3-Clause
#include "DrawnCurve.h"

#include "Browser.h"
#include "Panel.h"

#include <QCoreApplication>
#include <QEvent>
#include <QItemSelectionModel>
#include <QList>
#include <QObject>
#include <QPointer>
#include <QVariant>

// Of QtGui no more than this header: its package asks for the development files of OpenGL.
#include <QtGui/QKeyEvent>

namespace
{

bool isView(QObject* object)
{
  return object->inherits("QVTKOpenGLNativeWidget") || object->inherits("QVTKOpenGLStereoWidget");
}

/// ParaView's panel of a polyline: its table of points, and the buttons beside it.
class PolylinePanel
{
public:
  explicit PolylinePanel(QObject* widget)
    : Widget(widget)
    , Selection(widget->findChild<QObject*>("PointsTable")->findChild<QItemSelectionModel*>())
  {
  }

  /// Appends the point under the mouse, as the button Add and the key P do in two steps.
  void Append() const
  {
    this->SelectLast();
    this->Click("Add");
    this->SelectLast();
    const QList<QVariant> before = this->LastPoint();
    this->Pick();
    if (this->LastPoint() == before) // there is nothing under the mouse
    {
      this->RemoveLast();
    }
  }

  void RemoveLast() const
  {
    this->SelectLast();
    this->Click("Remove");
    this->SelectLast();
  }

private:
  void Click(const char* button) const
  {
    QMetaObject::invokeMethod(this->Widget->findChild<QObject*>(button), "click");
  }

  QModelIndex Last(int column = 0) const
  {
    const QAbstractItemModel* points = this->Selection->model();
    return points->index(points->rowCount() - 1, column);
  }

  QList<QVariant> LastPoint() const
  {
    return { this->Last(0).data(Qt::EditRole), this->Last(1).data(Qt::EditRole),
      this->Last(2).data(Qt::EditRole) };
  }

  void SelectLast() const
  {
    this->Selection->setCurrentIndex(
      this->Last(), QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  }

  /// The key P: the selected point goes to where the mouse is. Of all panels the keys of the one
  /// that is shown are enabled.
  void Pick() const
  {
    QObject* window = this->Widget;
    while (window->parent())
    {
      window = window->parent();
    }
    for (QObject* object : window->findChildren<QObject*>())
    {
      if (object->inherits("QShortcut") && object->property("enabled").toBool() &&
        object->property("key").toString() == "P")
      {
        QMetaObject::invokeMethod(object, "activated");
        return;
      }
    }
  }

  QObject* Widget;
  QItemSelectionModel* Selection;
};

/// Sees the events of all widgets of the window first.
class Events : public QObject
{
public:
  using QObject::QObject;

  bool eventFilter(QObject* watched, QEvent* event) override
  {
    improvePanel(watched, *event);
    if (event->type() == QEvent::Polish && watched->objectName() == "show3DWidget" &&
      watched->parent() && watched->parent()->objectName() == "InteractivePolyLine")
    {
      watched->setProperty("text", "Show Polyline");
      this->Panels.append(watched->parent());
    }
    else if (event->type() == QEvent::Polish && watched->inherits("pqProxyWidget"))
    {
      this->PipelineBrowser.WatchIn(watched);
    }
    else if (event->type() == QEvent::Enter && isView(watched) && this->ShownPanel())
    {
      // Keys count where the mouse is, not where something was clicked last.
      QMetaObject::invokeMethod(watched, "setFocus");
    }
    else if (event->type() == QEvent::KeyPress && isView(watched))
    {
      return this->ChangeCurve(static_cast<QKeyEvent*>(event)->key());
    }
    return QObject::eventFilter(watched, event);
  }

private:
  QObject* ShownPanel()
  {
    this->Panels.removeAll(nullptr);
    for (const QPointer<QObject>& panel : this->Panels)
    {
      if (panel->property("visible").toBool())
      {
        return panel;
      }
    }
    return nullptr;
  }

  /// Whether a key has done so.
  bool ChangeCurve(int key)
  {
    QObject* panel = key == Qt::Key_3 || key == Qt::Key_Backspace ? this->ShownPanel() : nullptr;
    if (panel && key == Qt::Key_3)
    {
      PolylinePanel(panel).Append();
    }
    else if (panel)
    {
      PolylinePanel(panel).RemoveLast();
    }
    return panel != nullptr;
  }

  QList<QPointer<QObject>> Panels;
  Browser PipelineBrowser;
};

}

void helpToDrawCurves()
{
  if (QCoreApplication* application = QCoreApplication::instance())
  {
    application->installEventFilter(new Events(application));
  }
}
