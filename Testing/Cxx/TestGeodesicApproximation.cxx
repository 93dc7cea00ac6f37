// SPDX-License-Identifier: BSD-3-Clause
// An approximate distance is below the exact one by no more than the filter says, which is no more
// than was asked for; what refinement may miss comes on top of that.
#include "GeodesicTesting.h"

using namespace GeodesicTesting;

namespace
{

const std::vector<Point> Line = { { 0.1, 0.2, 0 }, { 0.7, 0.35, 0 }, { 0.65, 0.9, 0 } };

/// A sphere whose radius changes, of many saddles.
vtkSmartPointer<vtkPolyData> Bumpy()
{
  return ChangedSphere(60, 40,
    [](const Point& p)
    {
      const double scale = 1.0 + 0.2 * std::sin(14.0 * p[0]) * std::cos(11.0 * p[1] + 9.0 * p[2]);
      return ScaledBy(scale)(p);
    });
}

void CheckRelativeErrors(Check& check)
{
  auto surface = Bumpy();
  const auto filter =
    PlainField(surface, Polyline({ { 0.4, 0.1, 0.2 }, { 0.1, 0.4, 0.3 }, { -0.3, 0.3, 0.1 } }));
  Messages messages(filter);
  messages.Update();
  const std::vector<double> exact = NumbersOf(Distances(filter));
  const double windows = filter->GetWindowsPropagatedPerEdge();
  check.Equal(filter->GetRelativeErrorBound(), 0.0, "the bound of the exact field");
  check.That(windows > 3.0, "the exact field takes many windows");

  filter->SetRelativeError(0.1);
  messages.Update();
  check.That(
    NumbersOf(Distances(filter)) == exact, "the relative error changes nothing in exact mode");

  filter->SetAccuracyToApproximate();
  for (const double epsilon : { 0.0, 1e-4, 1e-3, 1e-2, 1e-1, 10.0 })
  {
    const std::string name = "relative error " + std::to_string(epsilon);
    filter->SetRelativeError(epsilon);
    messages.ExpectNoError(check, name);
    const std::vector<double> values = NumbersOf(Distances(filter));
    double measured = 0.0;
    double above = 0.0;
    for (std::size_t i = 0; i < exact.size(); ++i)
    {
      measured = exact[i] > 0.0 ? std::max(measured, (exact[i] - values[i]) / exact[i]) : measured;
      above = std::max(above, values[i] - exact[i]);
    }
    const double reported = filter->GetRelativeErrorBound();
    std::cout << name << ": measured " << measured << ", reported " << reported << ", windows "
              << filter->GetWindowsPropagatedPerEdge() << " instead of " << windows << "\n";
    check.That(above < 1e-9, name + ": never above the exact distance");
    check.That(measured <= reported + 1e-9, name + ": the measured error is below the bound");
    check.That(reported <= epsilon, name + ": the bound is what was asked for");
    check.Equal(filter->GetOutput()->GetFieldData()->GetArray("RelativeErrorBound")->GetTuple1(0),
      reported, name + ": the array of the bound");
    check.That(epsilon > 0.0 || values == exact, "a relative error of 0 is exact");
    check.That(epsilon < 1e-2 || filter->GetWindowsPropagatedPerEdge() < 0.9 * windows,
      name + ": fewer windows");
  }
}

void CheckBoundsAddUp(Check& check)
{
  const Distance truth = DistanceTo(Line);
  const auto filter = RefinedField(Square(8), Polyline(Line));
  filter->SetAccuracyToApproximate();
  filter->SetRelativeError(0.001);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  const double relative = filter->GetRelativeErrorBound();
  const double interpolation = filter->GetInterpolationErrorBound();
  check.That(output->GetNumberOfCells() > 128, "an approximate field is refined");
  check.That(relative > 0.0 && relative <= 0.001, "its relative bound");
  std::cout << "interpolation bound " << interpolation << "\n";
  check.That(interpolation <= 1e-3 * std::sqrt(2.0), "its interpolation bound");
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    const Point middle = CentreOf(output, cell);
    double value = 0.0;
    for (const vtkIdType id : IdsOf(output->GetPolys(), cell))
    {
      value += Distances(filter)->GetTuple1(id) / 3.0;
    }
    check.Near(value, truth(middle), relative * truth(middle) + interpolation + 1e-9,
      "both bounds together hold in the middle of triangles");
  }
}

/// A tolerance finer than what merging leaves of the field's continuity is met, or not met with a
/// warning.
void CheckCoarseFieldWithFineTolerance(Check& check)
{
  const auto filter = RefinedField(Square(8), Polyline(Line));
  filter->SetAccuracyToApproximate();
  filter->SetRelativeError(0.1);
  Messages messages(filter);
  messages.Update();
  const bool met = filter->GetInterpolationErrorBound() <= 1e-3 * std::sqrt(2.0);
  check.That(messages.Warning().empty() == met,
    "a tolerance that is not met is told: " + messages.Warning());
  check.That(met || Contains(messages.Warning(), "Lower RelativeError"), "and what to do");
}

const std::vector<Point> OnBumpy = { { 0.4, 0.1, 0.2 }, { 0.1, 0.4, 0.3 } };

/// Gradients are those of the computed field, whether or not other arrays need the exact one.
void CheckGradients(Check& check)
{
  const auto filter = RefinedField(Bumpy(), Polyline(OnBumpy));
  filter->SetAccuracyToApproximate();
  filter->SetRelativeError(0.1);
  filter->SetRefinementTolerance(0.005);
  filter->GenerateGradientsOn();
  const auto gradients = [&filter]
  {
    filter->Update();
    return NumbersOf(filter->GetOutput()->GetPointData()->GetArray("DistanceGradient"));
  };
  const std::vector<double> alone = gradients();
  check.That(alone.size() > 3 * static_cast<std::size_t>(Bumpy()->GetNumberOfPoints()),
    "there are new points");
  filter->GenerateSourceIdsOn();
  check.That(gradients() == alone, "gradients are those of the computed field");
}

/// All reached points have a source, also where the exact distance is over the limit.
void CheckLimit(Check& check)
{
  const auto filter = RefinedField(Bumpy(), Polyline(OnBumpy));
  filter->SetAccuracyToApproximate();
  filter->SetRelativeError(0.1);
  filter->GenerateSourceIdsOn();
  for (const bool isRefined : { false, true })
  {
    filter->SetRefineMesh(isRefined);
    for (int i = 1; i <= 20; ++i)
    {
      filter->SetMaximumDistance(0.05 * i);
      filter->Update();
      vtkDataArray* ids = filter->GetOutput()->GetPointData()->GetArray("SourceId");
      vtkIdType without = 0;
      for (vtkIdType point = 0; point < ids->GetNumberOfTuples(); ++point)
      {
        const bool isReached = std::isfinite(Distances(filter)->GetTuple1(point));
        without += isReached && ids->GetTuple1(point) < 0.0 ? 1 : 0;
      }
      check.Equal(without, 0.0,
        "limit " + std::to_string(filter->GetMaximumDistance()) +
          ": reached points without source");
    }
  }
}

}

int TestGeodesicApproximation(int, char*[])
{
  Check check;
  CheckRelativeErrors(check);
  CheckBoundsAddUp(check);
  CheckCoarseFieldWithFineTolerance(check);
  CheckGradients(check);
  CheckLimit(check);
  return check.Result();
}
