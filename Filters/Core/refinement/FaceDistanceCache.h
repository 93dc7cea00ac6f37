// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_FaceDistanceCache_h
#define geodesic_FaceDistanceCache_h

#include "field/FaceDistance.h"

#include <optional>

namespace geodesic
{

/// Makes the distances of faces and keeps the last one: refinement asks for one face many times in
/// turn, and making it costs as much as some segments.
class FaceDistanceCache
{
public:
  /// \param field with windows kept; must outlive the cache.
  explicit FaceDistanceCache(const DistanceField& field)
    : field_(field)
  {
  }

  /// Valid until another face is asked for.
  const FaceDistance& of(Id face)
  {
    if (!this->last_)
    {
      this->last_.emplace(this->field_, face);
    }
    else if (this->last_->face() != face)
    {
      this->last_.emplace(this->field_, face, this->last_->releaseMemory());
    }
    return *this->last_;
  }

private:
  const DistanceField& field_;
  std::optional<FaceDistance> last_;
};

}

#endif
