// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_SurfaceCache_h
#define geodesic_SurfaceCache_h

#include "PolyData/PolyDataBlocks.h"
#include "PolyData/PolyDataSurface.h"
#include "PolyData/SurfaceLocator.h"
#include "Progress.h"

#include "vtkType.h"

#include <memory>
#include <vector>

class vtkDataObject;

namespace geodesic
{

/// The surface of the last execution, with its locator, for the next one to use again.
class SurfaceCache
{
public:
  /// Reads the surface, unless the one that is kept is the same.
  ///
  /// \param input the data object that the blocks are of.
  /// \throws what readSurface() throws; nothing is kept then.
  void update(vtkDataObject* input, const std::vector<PolyDataBlock>& blocks,
    bool mergeCoincidentPoints, const ProgressCallback& progress);

  /// What update() has read. Valid until the next update() or release().
  const PolyDataSurface& surface() const { return *this->surface_; }
  SurfaceLocator& locator() const { return *this->locator_; }

  /// Whether the user has yet to be told of what was noticed when the surface was read.
  bool isNoteDue() const { return this->isNoteDue_; }
  void setNoteGiven() { this->isNoteDue_ = false; }

  /// Gives its memory back.
  void release();

private:
  std::unique_ptr<PolyDataSurface> surface_;
  std::unique_ptr<SurfaceLocator> locator_;
  bool isNoteDue_ = false;
  /// What the surface was made from. Never dereferenced: the time of modification, which no two
  /// objects share, tells whether it is still the same.
  const vtkDataObject* input_ = nullptr;
  vtkMTimeType time_ = 0;
  bool isMerged_ = false;
};

}

#endif
