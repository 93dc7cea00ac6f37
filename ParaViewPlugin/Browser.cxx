// SPDX-License-Identifier: BSD-3-Clause
#include "Browser.h"

#include "Lines.h"

#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"

#include <QAbstractItemModel>
#include <QItemSelectionModel>
#include <QList>
#include <QObject>
#include <QTimer>

namespace
{

bool isGeodesicFilter(const QString& name)
{
  auto* proxies = vtkSMProxyManager::GetProxyManager()->GetActiveSessionProxyManager();
  auto* filter = vtkSMSourceProxy::SafeDownCast(
    proxies ? proxies->GetProxy("sources", name.toUtf8().constData()) : nullptr);
  return filter && lines::isGeodesicFilter(filter);
}

/// The item of a filter. One with several inputs stands below none of them: items of its name that
/// lie deeper are links to it.
QModelIndex itemOf(const QString& name, const QAbstractItemModel* pipeline)
{
  QList<QModelIndex> level{ QModelIndex() };
  while (!level.isEmpty())
  {
    QList<QModelIndex> below;
    for (const QModelIndex& parent : level)
    {
      for (int row = 0; row < pipeline->rowCount(parent); ++row)
      {
        below.append(pipeline->index(row, 0, parent));
        if (below.last().data().toString() == name)
        {
          return below.last();
        }
      }
    }
    level = below;
  }
  return {};
}

}

void Browser::WatchIn(QObject* widget)
{
  while (widget->parent())
  {
    widget = widget->parent();
  }
  for (QObject* browser : widget->findChildren<QObject*>())
  {
    if (browser->inherits("pqPipelineBrowserWidget") && browser != this->Watched)
    {
      this->Watched = browser;
      this->Watch(browser, browser->findChild<QItemSelectionModel*>());
    }
  }
}

void Browser::Watch(QObject* browser, QItemSelectionModel* selection)
{
  // Before rows go, Qt selects something else, unless what is selected is below them.
  QObject::connect(selection, &QItemSelectionModel::currentChanged, browser,
    [this, browser](const QModelIndex&, const QModelIndex& before)
    {
      this->Left = before;
      QTimer::singleShot(0, browser, [this]() { this->Left = QModelIndex(); });
    });
  QObject::connect(selection->model(), &QAbstractItemModel::rowsAboutToBeRemoved, browser,
    [this, selection](const QModelIndex& parent, int first, int last)
    {
      for (const QModelIndex& selected : { QModelIndex(this->Left), selection->currentIndex() })
      {
        this->NoteLoss(selected, parent, first, last);
      }
    });
  // Later, when the filter has come to where it stays.
  QObject::connect(
    selection->model(), &QAbstractItemModel::rowsInserted, browser,
    [this, browser, selection]() { this->SelectLost(browser, selection); }, Qt::QueuedConnection);
}

void Browser::NoteLoss(const QModelIndex& selected, const QModelIndex& parent, int first, int last)
{
  QModelIndex item = selected;
  while (item.isValid() && item.parent() != parent)
  {
    item = item.parent();
  }
  if (item.isValid() && item.row() >= first && item.row() <= last)
  {
    this->Lost = item.data().toString();
  }
}

void Browser::SelectLost(QObject* browser, QItemSelectionModel* selection)
{
  const QAbstractItemModel* pipeline = selection->model();
  const QModelIndex item =
    isGeodesicFilter(this->Lost) ? itemOf(this->Lost, pipeline) : QModelIndex();
  this->Lost.clear();
  if (!item.isValid())
  {
    return;
  }
  selection->setCurrentIndex(item, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  const QModelIndex lastOutput = pipeline->index(pipeline->rowCount(item) - 1, 0, item);
  for (const QModelIndex& seen : { lastOutput, item })
  {
    QMetaObject::invokeMethod(browser, "scrollTo", Q_ARG(QModelIndex, seen));
  }
}
