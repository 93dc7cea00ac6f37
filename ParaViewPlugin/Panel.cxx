// SPDX-License-Identifier: BSD-3-Clause
#include "Panel.h"

#include <QEvent>
#include <QList>
#include <QMap>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <QVariant>

namespace
{

const QMap<QString, QString>& purposes()
{
  static const QMap<QString, QString> words{
    { "GenerateSourceIds", "nearest part of the source" },
    { "GenerateClosestPoints", "nearest point of the source" },
    { "GenerateGradients", "direction away from the source" },
    { "GenerateSignedDistance", "side of the curve" },
    { "GenerateSourceArcLength", "place along the curve" },
    { "GenerateSourceAngle", "direction at the source" },
    { "GenerateTextureCoordinates", "for pictures on the surface" },
    { "GenerateFaceIds", "cells along the path" },
  };
  return words;
}

/// Results are nothing to write into, and are seen whole.
constexpr const char* NoBox =
  "QLineEdit { border: none; background: palette(window); min-width: 7em }";

/// As ParaView makes it, a list of data sets is as wide as the longest name, and the panel with it.
constexpr int NarrowList = 80;
constexpr const char* WholeNames = "QAbstractItemView { min-width: 24em }";

bool isInput(const QString& property)
{
  return property == "Source" || property == "Targets";
}

bool isResult(const QString& property)
{
  static const QStringList results{ "FarthestPoint", "InterpolationErrorBound", "LargestDistance",
    "LongestLength", "NumberOfPaths", "RelativeErrorBound", "SeamPointsJoined", "ShortestLength",
    "SourceLength", "SourceSnapDistance", "WindowsPropagatedPerEdge" };
  return results.contains(property);
}

}

void improvePanel(QObject* watched, const QEvent& event)
{
  static QPointer<QObject> painted;
  if (event.type() == QEvent::Paint && watched->inherits("pqDoubleLineEdit"))
  {
    painted = watched;
  }
  else if (event.type() == QEvent::Paint && watched->inherits("QLineEdit") && !watched->parent() &&
    painted && isResult(painted->parent()->objectName()))
  {
    // ParaView paints numbers with few digits by another widget, which has no parent.
    watched->setProperty("styleSheet", NoBox);
  }
  else if (event.type() == QEvent::Polish && watched->objectName() == "CheckBox" &&
    watched->parent())
  {
    const QString purpose = purposes().value(watched->parent()->objectName());
    if (!purpose.isEmpty())
    {
      watched->setProperty("text", watched->property("text").toString() + "\n" + purpose);
    }
  }
  else if (event.type() == QEvent::Polish && watched->inherits("QComboBox") && watched->parent() &&
    isInput(watched->parent()->objectName()))
  {
    watched->setProperty("minimumWidth", NarrowList);
    watched->setProperty("styleSheet", WholeNames);
  }
  else if (event.type() == QEvent::EnabledChange && watched->inherits("pqPropertyWidget") &&
    isResult(watched->objectName()) && !watched->property("enabled").toBool())
  {
    for (QObject* number : watched->findChildren<QObject*>())
    {
      if (number->inherits("QLineEdit"))
      {
        number->setProperty("readOnly", true);
      }
    }
    watched->setProperty("enabled", true);
    watched->setProperty("styleSheet", NoBox);
  }
}
