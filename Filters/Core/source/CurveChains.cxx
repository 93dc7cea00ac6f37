// SPDX-License-Identifier: BSD-3-Clause
#include "source/CurveChains.h"

#include <algorithm>
#include <map>
#include <tuple>

namespace geodesic
{

namespace
{

/// One end of a curve: its first or its last point.
struct CurveEnd
{
  std::size_t curve;
  bool isLast;
  CurveEnd other() const { return { this->curve, !this->isLast }; }
};

constexpr std::size_t NoCurve = static_cast<std::size_t>(-1);

/// For each end of a curve, the end of another curve that continues it.
class EndPairs
{
public:
  EndPairs(const TriangleMesh& mesh, const std::vector<SourceCurve>& curves)
    : partners_(2 * curves.size(), { NoCurve, false })
  {
    using Key = std::tuple<SurfacePoint::Kind, Id, double, double>;
    std::map<Key, std::vector<CurveEnd>> meeting;
    for (std::size_t c = 0; c < curves.size(); ++c)
    {
      const SourceCurve& curve = curves[c];
      if (curve.points.size() < 2 || curve.isClosed())
      {
        continue;
      }
      for (const bool isLast : { false, true })
      {
        const SurfacePoint p =
          normalized(mesh, isLast ? curve.points.back() : curve.points.front());
        meeting[{ p.kind, p.id, p.u, p.v }].push_back({ c, isLast });
      }
    }
    for (const auto& [place, ends] : meeting)
    {
      if (ends.size() == 2)
      {
        this->at(ends[0]) = ends[1];
        this->at(ends[1]) = ends[0];
      }
    }
  }

  /// Its curve is NoCurve if none continues this end.
  CurveEnd partner(const CurveEnd& end) const
  {
    return this->partners_[2 * end.curve + end.isLast];
  }

private:
  CurveEnd& at(const CurveEnd& end) { return this->partners_[2 * end.curve + end.isLast]; }

  std::vector<CurveEnd> partners_;
};

/// The first end of the chain that contains a curve: back from curve to curve, or once around a
/// loop.
CurveEnd firstOfChain(const EndPairs& pairs, std::size_t curve)
{
  CurveEnd first = { curve, false };
  for (CurveEnd before = pairs.partner(first); before.curve != NoCurve && before.curve != curve;
       before = pairs.partner(first))
  {
    first = before.other();
  }
  return first;
}

} // anonymous namespace

CurveChains::CurveChains(const TriangleMesh& mesh, const std::vector<SourceCurve>& curves)
  : parts_(curves.size())
{
  const EndPairs pairs(mesh, curves);
  std::vector<std::uint8_t> isDone(curves.size(), 0);
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    if (isDone[c])
    {
      continue;
    }
    this->chains_.emplace_back().source = curves[c].source;
    const Id number = static_cast<Id>(this->chains_.size() - 1);
    std::vector<Id> order;
    for (CurveEnd end = firstOfChain(pairs, c); end.curve != NoCurve && !isDone[end.curve];
         end = pairs.partner(end.other()))
    {
      isDone[end.curve] = 1;
      order.push_back(static_cast<Id>(end.curve));
      const std::size_t begin = std::max<std::size_t>(this->chains_.back().points.size(), 1) - 1;
      this->append(curves[end.curve], end.isLast);
      this->parts_[end.curve] = { number, end.isLast, begin,
        this->chains_.back().points.size() - 1 };
    }
    for (SurfacePoint& point : this->chains_.back().points)
    {
      point = normalized(mesh, point);
    }
    const std::size_t points = this->places_.empty() ? 0 : this->places_.back().size();
    this->firstPoints_.push_back(
      (number == 0 ? 0 : this->firstPoints_.back()) + static_cast<Id>(points));
    this->places_.push_back(placesAlong(mesh, this->chains_.back()));
    std::vector<Link>& links = this->links_.emplace_back();
    for (const Id curve : order)
    {
      const Part& part = this->parts_[curve];
      links.push_back({ curve, part.isReversed, this->places_.back()[part.begin] });
    }
  }
}

// Appends to the current chain, whose last point is the curve's first.
void CurveChains::append(const SourceCurve& curve, bool isReversed)
{
  SourceCurve next = curve;
  if (isReversed)
  {
    std::reverse(next.points.begin(), next.points.end());
    std::reverse(next.faces.begin(), next.faces.end());
    std::reverse(next.isCut.begin(), next.isCut.end());
  }
  SourceCurve& chain = this->chains_.back();
  const std::ptrdiff_t shared = chain.points.empty() ? 0 : 1;
  chain.points.insert(chain.points.end(), next.points.begin() + shared, next.points.end());
  chain.faces.insert(chain.faces.end(), next.faces.begin(), next.faces.end());
  chain.isCut.insert(chain.isCut.end(), next.isCut.begin() + shared, next.isCut.end());
}

const CurveChains::Link& CurveChains::linkAt(Id chain, double place) const
{
  const std::vector<Link>& links = this->links_[chain];
  const auto behind = std::upper_bound(
    links.begin(), links.end(), place, [](double p, const Link& link) { return p < link.begin; });
  return behind == links.begin() ? links.front() : *(behind - 1);
}

Id CurveChains::pointAt(Id chain, double place) const
{
  const std::vector<double>& places = this->places_[chain];
  const auto at = std::lower_bound(places.begin(), places.end(), place);
  const std::ptrdiff_t i = std::min(at, places.end() - 1) - places.begin();
  return this->firstPoints_[chain] + static_cast<Id>(i);
}

CurveChains::Point CurveChains::pointWith(Id number) const
{
  const auto next = std::upper_bound(this->firstPoints_.begin(), this->firstPoints_.end(), number);
  const auto chain = static_cast<Id>(next - this->firstPoints_.begin() - 1);
  return { chain, number - this->firstPoints_[chain] };
}

double CurveChains::arcLength(Id curve, double place) const
{
  const Part& part = this->parts_[curve];
  const std::vector<double>& places = this->places_[part.chain];
  return part.isReversed ? places[part.end] - place : place - places[part.begin];
}

double CurveChains::angleFrom(Id curve, double angle) const
{
  constexpr double straightAngle = 3.14159265358979323846;
  const double turn = this->parts_[curve].isReversed ? straightAngle : 0.0;
  return angle > 0.0 ? angle - turn : angle + turn;
}

}
