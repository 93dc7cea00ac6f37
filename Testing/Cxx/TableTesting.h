// SPDX-License-Identifier: BSD-3-Clause
#ifndef TableTesting_h
#define TableTesting_h

#include "GeodesicTesting.h"

#include "vtkCellData.h"
#include "vtkGeodesicDistanceMatrix.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkTable.h"

#include <functional>
#include <limits>

/// Tables of targets that are sets, by the array Label.
namespace GeodesicTesting
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

template <typename Array = vtkIntArray>
vtkSmartPointer<Array> Labels(const std::vector<int>& values)
{
  auto labels = vtkSmartPointer<Array>::New();
  labels->SetName("Label");
  for (const int value : values)
  {
    labels->InsertNextValue(value);
  }
  return labels;
}

inline void SetCellLabels(vtkPolyData* data, const std::vector<int>& values)
{
  data->GetCellData()->AddArray(Labels(values));
}

inline void SetPointLabels(vtkPolyData* data, const std::vector<int>& values)
{
  data->GetPointData()->AddArray(Labels(values));
}

/// Gives each cell a label by its middle.
template <typename Array = vtkIntArray>
vtkSmartPointer<vtkPolyData> Labelled(
  vtkSmartPointer<vtkPolyData> surface, const std::function<int(const Point&)>& labelAt)
{
  std::vector<int> values;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    values.push_back(labelAt(CentreOf(surface, cell)));
  }
  surface->GetCellData()->AddArray(Labels<Array>(values));
  return surface;
}

/// The polygons whose labels are not negative.
inline vtkSmartPointer<vtkPolyData> WithoutNegative(vtkPolyData* surface)
{
  auto* labels = surface->GetCellData()->GetArray("Label");
  vtkNew<vtkCellArray> polys;
  std::vector<int> kept;
  for (vtkIdType cell = 0; cell < surface->GetNumberOfCells(); ++cell)
  {
    if (labels->GetTuple1(cell) >= 0)
    {
      vtkNew<vtkIdList> ids;
      surface->GetCellPoints(cell, ids);
      polys->InsertNextCell(ids);
      kept.push_back(static_cast<int>(labels->GetTuple1(cell)));
    }
  }
  auto parts = vtkSmartPointer<vtkPolyData>::New();
  parts->SetPoints(surface->GetPoints());
  parts->SetPolys(polys);
  SetCellLabels(parts, kept);
  return parts;
}

using Rows = std::vector<std::vector<double>>;

/// The distances.
///
/// \param first the column from which they begin.
inline Rows RowsOf(vtkTable* table, vtkIdType first = 1)
{
  Rows rows(static_cast<std::size_t>(table->GetNumberOfRows()));
  for (std::size_t row = 0; row < rows.size(); ++row)
  {
    for (vtkIdType column = first; column < table->GetNumberOfColumns(); ++column)
    {
      rows[row].push_back(table->GetValue(static_cast<vtkIdType>(row), column).ToDouble());
    }
  }
  return rows;
}

inline Rows TableOf(
  Check& check, vtkGeodesicDistanceMatrix* matrix, const std::string& what, vtkIdType first = 1)
{
  Messages messages(matrix);
  messages.Update();
  check.That(messages.Error().empty(), what + ": " + messages.Error());
  return RowsOf(matrix->GetOutput(), first);
}

inline void CheckIds(
  Check& check, vtkTable* table, const std::vector<int>& expected, const std::string& what)
{
  std::vector<int> ids;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    ids.push_back(table->GetValueByName(row, "TargetId").ToInt());
  }
  check.That(ids == expected, what + ": TargetId");
}

inline void CheckError(Check& check, vtkGeodesicDistanceMatrix* matrix,
  const std::vector<std::string>& words, const std::string& what)
{
  Messages messages(matrix);
  messages.Update();
  for (const std::string& word : words)
  {
    check.That(Contains(messages.Error(), word),
      what + ": \"" + word + "\" in \"" + messages.Error() + "\"");
  }
  check.Equal(static_cast<double>(matrix->GetOutput()->GetNumberOfRows()), 0.0, what + ": empty");
}

}

#endif
