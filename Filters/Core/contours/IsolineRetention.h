// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_IsolineRetention_h
#define geodesic_IsolineRetention_h

#include "front/Retention.h"
#include "mesh/MeshPartition.h"

#include <vector>

namespace geodesic
{

/// Keeps the windows of faces whose range of distances may contain one of some values, and stops
/// the front beyond the largest value.
///
/// A list is kept or dropped when it has passed, by the distances known at that time. If later
/// paths shorten distances of the face so that its range contains a value after all, the dropped
/// windows are missing: then the face must be pinned and the solve repeated.
class IsolineRetention : public Retention
{
public:
  /// \param values ascending, must outlive this.
  /// \param pinned for each face, not 0 if its windows must not be dropped; must outlive this.
  IsolineRetention(const MeshPartition& surface, const std::vector<double>& values,
    const std::vector<std::uint8_t>& pinned);

  bool needsInside() const override { return true; }
  double reach() const override { return this->reach_; }
  void setNumberOfDistricts(std::size_t count) override { this->passed_.resize(count); }
  void start(const std::vector<SourceInFace>& sources) override;
  void pass(std::size_t district, const PassedList& list, Id batch, WindowPool& pool) override;
  void advance(const FrontState& front) override;
  void finish(const FrontState& front) override;

  KeptWindows release() { return std::move(this->kept_); }
  /// Faces whose windows were dropped although a value may be in them.
  const std::vector<Id>& droppedTooEarly() const { return this->droppedTooEarly_; }

private:
  /// Properties of a face.
  enum Mark : std::uint8_t
  {
    HasSource = 1,
    Dropped = 2
  };

  bool mayHoldValue(Id face, const VertexNumbers& distances, double certain) const;
  void takePassed(const FrontState& front);

  const TriangleMesh& mesh_;
  Id firstFace_;
  Id endOfFaces_;
  const std::vector<double>& values_;
  const std::vector<std::uint8_t>& pinned_;
  double reach_;
  std::vector<std::uint8_t> marks_;
  /// The lists that each district has handed over in this batch.
  std::vector<std::vector<PassedList>> passed_;
  Id batch_ = 0;
  std::vector<Id> droppedTooEarly_;
  KeptWindows kept_;
};

}

#endif
