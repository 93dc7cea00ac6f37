// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FrontProgress_h
#define geodesic_FrontProgress_h

#include "Progress.h"
#include "Types.h"

#include <algorithm>

namespace geodesic
{

/// Reports how far the front is: by the number of vertices reached, or by the distance if there is
/// a limit. The fraction never decreases.
class FrontProgress
{
public:
  FrontProgress(const ProgressCallback& callback, Id numberOfVertices, double limit)
    : callback_(ascending(callback))
    , numberOfVertices_(std::max<Id>(numberOfVertices, 1))
    , limit_(limit)
  {
  }

  void settle(std::size_t vertices) { this->settled_ += vertices; }

  /// To be called after each batch; reports only some of them. Few vertices may have very many
  /// windows.
  ///
  /// \param windows number of windows handled since the front began.
  /// \throws Aborted
  void afterBatch(std::size_t vertices, std::uint64_t windows, double key)
  {
    constexpr std::size_t verticesPerReport = 256;
    constexpr std::uint64_t windowsPerReport = 1U << 17;
    this->sinceReport_ += vertices;
    if (this->sinceReport_ >= verticesPerReport ||
      windows - this->windowsAtReport_ >= windowsPerReport)
    {
      this->sinceReport_ = 0;
      this->windowsAtReport_ = windows;
      this->report(key);
    }
  }

  /// \throws Aborted
  void report(double key)
  {
    const double settled =
      static_cast<double>(this->settled_) / static_cast<double>(this->numberOfVertices_);
    reportProgress(this->callback_, std::min(1.0, std::max(settled, key / this->limit_)));
  }

private:
  ProgressCallback callback_;
  Id numberOfVertices_;
  double limit_;
  std::size_t settled_ = 0;
  std::size_t sinceReport_ = 0;
  std::uint64_t windowsAtReport_ = 0;
};

}

#endif
