// SPDX-License-Identifier: BSD-3-Clause
#include "source/CurveChains.h"

#include "Chains.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace geodesic
{

namespace
{

/// The numbers of the places where curves begin and end. Points and closed curves join no others.
std::vector<Id> placesOfEnds(const TriangleMesh& mesh, const std::vector<SourceCurve>& curves)
{
  using Key = std::tuple<SurfacePoint::Kind, Id, double, double>;
  std::map<Key, Id> numbers;
  std::vector<Id> places;
  for (const SourceCurve& curve : curves)
  {
    for (const SurfacePoint& end : { curve.points.front(), curve.points.back() })
    {
      const bool isJoined = curve.points.size() > 1 && !curve.isClosed();
      places.push_back(!isJoined
          ? NoId
          : numbers.try_emplace(normalized(mesh, end).members(), static_cast<Id>(numbers.size()))
              .first->second);
    }
  }
  return places;
}

/// Appends a curve to a chain whose last point is the curve's first, or its last if reversed.
void append(SourceCurve curve, bool isReversed, SourceCurve& chain)
{
  if (isReversed)
  {
    std::reverse(curve.points.begin(), curve.points.end());
    std::reverse(curve.faces.begin(), curve.faces.end());
    std::reverse(curve.isCut.begin(), curve.isCut.end());
  }
  const std::ptrdiff_t shared = chain.points.empty() ? 0 : 1;
  chain.points.insert(chain.points.end(), curve.points.begin() + shared, curve.points.end());
  chain.faces.insert(chain.faces.end(), curve.faces.begin(), curve.faces.end());
  chain.isCut.insert(chain.isCut.end(), curve.isCut.begin() + shared, curve.isCut.end());
}

/// The parameters of a curve's points: lengths from its beginning. They strictly increase, even
/// across segments without length.
std::vector<double> parametersAlong(const TriangleMesh& mesh, const SourceCurve& curve)
{
  std::vector<double> parameters = { 0.0 };
  for (std::size_t i = 0; i + 1 < curve.points.size(); ++i)
  {
    const double parameter = parameters.back() + lengthOfSegment(mesh, curve, i);
    parameters.push_back(std::max(parameter, std::nextafter(parameters.back(), Infinity)));
  }
  return parameters;
}

} // anonymous namespace

CurveChains::CurveChains(const TriangleMesh& mesh, const std::vector<SourceCurve>& curves)
  : inChain_(curves.size())
{
  Id numberOfPoints = 0;
  for (const Chain& joined : followChains(placesOfEnds(mesh, curves)))
  {
    const Id number = static_cast<Id>(this->chains_.size());
    SourceCurve& chain = this->chains_.emplace_back();
    std::vector<Id>& order = this->order_.emplace_back();
    for (const Id end : joined.ends)
    {
      const bool isReversed = end % 2 != 0;
      const std::size_t begin = std::max<std::size_t>(chain.points.size(), 1) - 1;
      append(curves[end / 2], isReversed, chain);
      this->inChain_[end / 2] = { number, isReversed, begin, chain.points.size() - 1 };
      order.push_back(end / 2);
    }
    chain.source = curves[*std::min_element(order.begin(), order.end())].source;
    for (SurfacePoint& point : chain.points)
    {
      point = normalized(mesh, point);
    }
    this->firstPoints_.push_back(numberOfPoints);
    numberOfPoints += static_cast<Id>(chain.points.size());
    this->parameters_.push_back(parametersAlong(mesh, chain));
  }
}

Id CurveChains::curveAt(Id chain, double parameter) const
{
  const std::vector<Id>& order = this->order_[chain];
  const auto behind = std::upper_bound(order.begin(), order.end(), parameter,
    [this, chain](double p, Id curve)
    { return p < this->parameters_[chain][this->inChain_[curve].begin]; });
  return behind == order.begin() ? order.front() : *(behind - 1);
}

Id CurveChains::pointAt(Id chain, double parameter) const
{
  const std::vector<double>& parameters = this->parameters_[chain];
  const auto at = std::lower_bound(parameters.begin(), parameters.end(), parameter);
  const auto i = std::min(at, parameters.end() - 1) - parameters.begin();
  return this->numberOf({ chain, static_cast<std::size_t>(i) });
}

CurveChains::Point CurveChains::pointWith(Id number) const
{
  const auto next = std::upper_bound(this->firstPoints_.begin(), this->firstPoints_.end(), number);
  const auto chain = static_cast<Id>(next - this->firstPoints_.begin() - 1);
  return { chain, number - this->firstPoints_[chain] };
}

double CurveChains::arcLength(Id curve, double parameter) const
{
  const CurveInChain& curveInChain = this->inChain_[curve];
  const std::vector<double>& parameters = this->parameters_[curveInChain.chain];
  const double begin = parameters[curveInChain.begin];
  const double end = parameters[curveInChain.end];
  // A path that ends at an end of the curve may have a parameter beyond it by rounding.
  const double within = std::clamp(parameter, begin, end);
  return curveInChain.isReversed ? end - within : within - begin;
}

double CurveChains::angleFrom(Id curve, double angle) const
{
  const double turn = this->inChain_[curve].isReversed ? Pi : 0.0;
  return angle > 0.0 ? angle - turn : angle + turn;
}

}
