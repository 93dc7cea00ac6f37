// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_NotePassedFaces_h
#define geodesic_NotePassedFaces_h

#include "front/Retention.h"

#include <algorithm>
#include <vector>

namespace geodesic
{

/// Notes which faces windows have gone through. A task writes only the face of its halfedge, and
/// always the same: but two tasks may write one face, so each district has its own list.
class NotePassedFaces : public Retention
{
public:
  bool needsInside() const override { return false; }
  void setNumberOfDistricts(std::size_t count) override { this->passed_.resize(count); }
  void pass(std::size_t district, const PassedList& list, Id, WindowPool& pool) override
  {
    this->passed_[district].push_back(TriangleMesh::faceOf(list.halfedge));
    pool.free(list.windows);
  }

  /// Calls visit(Id face) for each, several times maybe.
  template <typename Visit>
  void forEachFace(const Visit& visit) const
  {
    for (const std::vector<Id>& faces : this->passed_)
    {
      std::for_each(faces.begin(), faces.end(), visit);
    }
  }

private:
  std::vector<std::vector<Id>> passed_;
};

}

#endif
