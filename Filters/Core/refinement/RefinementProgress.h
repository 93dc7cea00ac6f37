// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinementProgress_h
#define geodesic_RefinementProgress_h

#include "Progress.h"

#include <algorithm>

namespace geodesic
{

/// Reports to a callback how far a refinement is; the fraction never decreases.
class RefinementProgress
{
public:
  explicit RefinementProgress(const ProgressCallback& callback)
    : callback_(ascending(callback))
    , paced_(paced(this->callback_))
  {
  }
  RefinementProgress(const RefinementProgress&) = delete;
  RefinementProgress& operator=(const RefinementProgress&) = delete;

  /// Called once per step with the estimated fraction done.
  ///
  /// \throws Aborted
  void at(double fraction)
  {
    constexpr unsigned stepsPerReport = 256;
    if (this->steps_++ % stepsPerReport == 0)
    {
      this->tell(fraction);
    }
  }

  /// Called at the end of a longer step.
  ///
  /// \throws Aborted
  void tell(double fraction) { reportProgress(this->callback_, std::min(fraction, 1.0)); }

  /// Called between the pieces of a step, which may take long if faces have very many windows.
  ///
  /// \throws Aborted
  void look() const { reportProgress(this->paced_, 0.0); }

private:
  ProgressCallback callback_;
  ProgressCallback paced_;
  unsigned steps_ = 0;
};

}

#endif
