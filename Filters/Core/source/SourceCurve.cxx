// SPDX-License-Identifier: BSD-3-Clause
#include "source/SourceCurve.h"

namespace geodesic
{

bool SourceCurve::isClosed() const
{
  if (this->points.size() < 2)
  {
    return false;
  }
  const SurfacePoint& first = this->points.front();
  const SurfacePoint& last = this->points.back();
  return first.kind == last.kind && first.id == last.id && first.u == last.u && first.v == last.v;
}

}
