// SPDX-License-Identifier: BSD-3-Clause
#include "PolylineLabel.h"

#include <QCoreApplication>
#include <QEvent>
#include <QObject>
#include <QVariant>

namespace
{

/// Sees each widget of the window before it is shown first.
class Labels : public QObject
{
public:
  using QObject::QObject;

  bool eventFilter(QObject* watched, QEvent* event) override
  {
    if (event->type() == QEvent::Polish && watched->objectName() == "show3DWidget" &&
      watched->parent() && watched->parent()->objectName() == "InteractivePolyLine")
    {
      watched->setProperty("text", "Show Polyline");
    }
    return QObject::eventFilter(watched, event);
  }
};

}

void labelPolylines()
{
  if (QCoreApplication* application = QCoreApplication::instance())
  {
    application->installEventFilter(new Labels(application));
  }
}
