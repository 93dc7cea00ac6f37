// SPDX-License-Identifier: BSD-3-Clause
#include "contours/SolveForIsolines.h"

#include "Tolerance.h"
#include "field/DistanceRange.h"
#include "field/SolveDropping.h"

#include <algorithm>

namespace geodesic
{

namespace
{

/// Keeps the windows of faces whose range of distances may contain one of some values, and stops
/// the front beyond the largest value.
///
/// A list is kept or dropped when it has passed. If later paths shorten distances of the face so
/// that its range contains a value after all, the dropped windows are missing.
class IsolineRetention : public DroppingRetention
{
public:
  /// \param values ascending, must outlive this.
  /// \param pinned must outlive this.
  IsolineRetention(
    const MeshPartition& surface, const std::vector<double>& values, const PinnedFaces& pinned)
    : surface_(surface)
    , values_(values)
    , pinned_(pinned)
    , neededDistance_(values.back() * (1.0 + tolerance::BoundMargin))
    , hasSource_(surface.mesh().numberOfFaces(), 0)
  {
    this->kept_.faces.assign(surface.mesh().numberOfFaces(), 0);
    std::fill(this->kept_.faces.begin() + surface.firstOwnFace(),
      this->kept_.faces.begin() + surface.endOfOwnFaces(), std::uint8_t(1));
  }

  double neededDistance() const override { return this->neededDistance_; }
  void start(std::size_t districts, const std::vector<SourceInFace>& sources) override
  {
    this->passed_.resize(districts);
    for (const SourceInFace& source : sources)
    {
      this->hasSource_[source.face] = 1;
    }
  }
  void pass(std::size_t district, const PassedList& list, Id, WindowPool&) override
  {
    this->passed_[district].push_back(list);
  }
  void advance(const FrontState& front) override { this->takePassed(front); }
  void finish(const FrontState& front) override
  {
    this->takePassed(front);
    for (Id face = this->surface_.firstOwnFace(); face < this->surface_.endOfOwnFaces(); ++face)
    {
      if (!this->kept_.faces[face] &&
        this->mayHoldValue(face, front.distances, this->neededDistance_))
      {
        this->missing_.push_back(face);
      }
    }
    this->kept_.windows.index(this->surface_.mesh().numberOfHalfedges());
  }

private:
  bool mayHoldValue(Id face, const VertexNumbers& distances, double certain) const
  {
    const auto& [a, b, c] = this->surface_.mesh().triangle(face);
    return rangeInFace(this->surface_.mesh().shape(face),
      { distances(a), distances(b), distances(c) }, certain, this->hasSource_[face] != 0)
      .holdsOneOf(this->values_);
  }

  // Distances beyond the front may still fall, down to its key and, where windows wait for a far
  // vertex, below it: then a face is missing in the end. Beyond the needed distance they are never
  // final.
  void takePassed(const FrontState& front)
  {
    const double certain = std::min(front.key, this->neededDistance_);
    for (std::vector<PassedList>& lists : this->passed_)
    {
      for (const PassedList& list : lists)
      {
        const Id face = TriangleMesh::faceOf(list.halfedge);
        if (this->pinned_[face] || this->mayHoldValue(face, front.distances, certain))
        {
          this->kept_.windows.add(list.halfedge, list.windows.range());
        }
        else
        {
          this->kept_.faces[face] = 0;
        }
        front.free(list.windows);
      }
      lists.clear();
    }
  }

  const MeshPartition& surface_;
  const std::vector<double>& values_;
  const PinnedFaces& pinned_;
  double neededDistance_;
  std::vector<std::uint8_t> hasSource_;
  /// The lists that each district has handed over in this batch.
  std::vector<std::vector<PassedList>> passed_;
};

} // anonymous namespace

DistanceField solveForIsolines(const MeshPartition& surface, const SourceWindows& sources,
  const std::vector<double>& values, const FrontOptions& options)
{
  PinnedFaces pinned(surface.mesh().numberOfFaces(), 0);
  return solveDropping(surface, sources, options, pinned,
    [&](const PinnedFaces& now) { return IsolineRetention(surface, values, now); });
}

}
