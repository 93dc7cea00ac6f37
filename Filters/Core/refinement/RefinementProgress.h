// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RefinementProgress_h
#define geodesic_RefinementProgress_h

#include "PacedProgress.h"

#include <algorithm>

namespace geodesic
{

/// Reports to a callback how far a refinement is; the fraction never decreases.
class RefinementProgress
{
public:
  explicit RefinementProgress(const ProgressCallback& callback)
    : callback_(callback)
    , paced_(paced(callback))
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
  void tell(double fraction)
  {
    if (!this->callback_)
    {
      return;
    }
    this->reported_ = std::max(this->reported_, fraction);
    if (!this->callback_(std::min(this->reported_, 1.0)))
    {
      throw Aborted();
    }
  }

  /// Called between the pieces of a step, which may take long if faces have very many windows.
  ///
  /// \throws Aborted
  void look() const
  {
    if (this->paced_ && !this->paced_(std::min(this->reported_, 1.0)))
    {
      throw Aborted();
    }
  }

private:
  const ProgressCallback& callback_;
  ProgressCallback paced_;
  double reported_ = 0.0;
  unsigned steps_ = 0;
};

}

#endif
