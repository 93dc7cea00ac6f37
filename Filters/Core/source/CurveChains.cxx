// SPDX-License-Identifier: BSD-3-Clause
#include "source/CurveChains.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace geodesic
{

namespace
{

constexpr std::size_t NoEnd = static_cast<std::size_t>(-1);

/// The ends of curve c are 2 * c, at its first point, and 2 * c + 1, at its last one. For each end,
/// the end of another curve that continues it, or NoEnd.
std::vector<std::size_t> partnersOfEnds(
  const TriangleMesh& mesh, const std::vector<SourceCurve>& curves)
{
  using Key = std::tuple<SurfacePoint::Kind, Id, double, double>;
  std::map<Key, std::vector<std::size_t>> meeting;
  for (std::size_t end = 0; end < 2 * curves.size(); ++end)
  {
    const SourceCurve& curve = curves[end / 2];
    if (curve.points.size() > 1 && !curve.isClosed())
    {
      const SurfacePoint& p = end % 2 == 0 ? curve.points.front() : curve.points.back();
      meeting[normalized(mesh, p).members()].push_back(end);
    }
  }
  std::vector<std::size_t> partners(2 * curves.size(), NoEnd);
  for (const auto& [place, ends] : meeting)
  {
    if (ends.size() == 2)
    {
      partners[ends[0]] = ends[1];
      partners[ends[1]] = ends[0];
    }
  }
  return partners;
}

/// The first end of the chain that contains a curve: back from curve to curve, or once around a
/// loop.
std::size_t firstOfChain(const std::vector<std::size_t>& partners, std::size_t curve)
{
  std::size_t first = 2 * curve;
  for (std::size_t before = partners[first]; before != NoEnd && before / 2 != curve;
       before = partners[first])
  {
    first = before ^ 1U;
  }
  return first;
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
  const std::vector<std::size_t> partners = partnersOfEnds(mesh, curves);
  Id numberOfPoints = 0;
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    if (this->inChain_[c].chain != NoId)
    {
      continue;
    }
    const Id number = static_cast<Id>(this->chains_.size());
    SourceCurve& chain = this->chains_.emplace_back();
    chain.source = curves[c].source;
    std::vector<Id>& order = this->order_.emplace_back();
    for (std::size_t end = firstOfChain(partners, c);
         end != NoEnd && this->inChain_[end / 2].chain == NoId; end = partners[end ^ 1U])
    {
      const bool isReversed = end % 2 != 0;
      const std::size_t begin = std::max<std::size_t>(chain.points.size(), 1) - 1;
      append(curves[end / 2], isReversed, chain);
      this->inChain_[end / 2] = { number, isReversed, begin, chain.points.size() - 1 };
      order.push_back(static_cast<Id>(end / 2));
    }
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
  const std::ptrdiff_t i = std::min(at, parameters.end() - 1) - parameters.begin();
  return this->firstPoints_[chain] + static_cast<Id>(i);
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
