// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_PassedLists_h
#define geodesic_PassedLists_h

#include "front/Retention.h"
#include "refinement/LinearBand.h"

#include <vector>

namespace geodesic
{

/// A passed list, and whether it is in the band around the line between the distances at its ends.
struct MeasuredList
{
  PassedList list;
  ListInBand inBand;
};

/// The lists that have passed through each face and are still kept, in the order of passing. Memory
/// of freed lists is reused.
class PassedLists
{
public:
  explicit PassedLists(Id numberOfFaces)
    : first_(numberOfFaces, NoId)
  {
  }

  void add(const MeasuredList& measured);

  /// Frees the lists of a face.
  void free(Id face, const FrontState& front);

  /// Calls visit(measured list) until it returns false. Returns whether it never did.
  template <typename Visit>
  bool forEach(Id face, Visit&& visit) const
  {
    for (Id n = this->first_[face]; n != NoId; n = this->nodes_[n].next)
    {
      if (!visit(this->nodes_[n].measured))
      {
        return false;
      }
    }
    return true;
  }

private:
  struct Node
  {
    MeasuredList measured;
    Id next;
  };

  std::vector<Node> nodes_;
  std::vector<Id> freeNodes_;
  std::vector<Id> first_;
};

}

#endif
