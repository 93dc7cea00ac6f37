// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_RemoteVertices_h
#define geodesic_RemoteVertices_h

#include "Exchange.h"
#include "PolyData/ranks/BorrowedValues.h"
#include "PolyData/ranks/RankSeams.h"

#include <vector>

namespace geodesic
{

/// The vertices of a rank's points that none of its own faces has: corners of duplicates of other
/// ranks' faces, and points that no face uses here. Their values come from the lowest rank that has
/// a face there.
class RemoteVertices
{
public:
  /// All ranks make theirs together.
  ///
  /// \param labels of all vertices of this rank.
  /// \param ownNumbers what each is in values at vertices; NoId for those to be borrowed.
  RemoteVertices(const RankLabels& labels, const std::vector<Id>& ownNumbers, Exchange& exchange);

  /// How many this rank borrows.
  Id count() const { return this->count_; }
  /// How many of them belong to no face of any rank, all ranks together; each is counted once.
  Id numberWithoutFace() const { return this->numberWithoutFace_; }

  /// Appends the values of borrowed vertices, in the order of the constructor's, to those of a
  /// rank's own. All ranks call this together.
  ///
  /// \param none the value where no rank has a face.
  template <typename Value>
  void append(const Value& none, std::vector<Value>& values, Exchange& exchange) const
  {
    this->values_.append(none, values, exchange);
  }

private:
  Id count_ = 0;
  Id numberWithoutFace_ = 0;
  BorrowedValues values_;
};

}

#endif
