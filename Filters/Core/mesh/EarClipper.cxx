// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/EarClipper.h"

#include "mesh/SideOfLine.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <tuple>
#include <utility>

namespace geodesic
{

namespace
{

/// Clips the ears of a polygon in the plane.
///
/// If each triangle has positive area, the triangles cover each place as often as the outline winds
/// around it, whatever the order of the ears: once inside, never outside. Therefore ears need to be
/// chosen only so that some remain.
class EarClipper
{
public:
  EarClipper(const std::vector<Vec3>& outline, const Vec3& normal, const std::vector<Vec2>& flat)
    : outline_(outline)
    , normal_(normal)
    , flat_(flat)
    , left_(static_cast<Id>(flat.size()))
    , corners_(flat.size())
  {
    const Id count = this->left_;
    for (Id i = 0; i < count; ++i)
    {
      this->corners_[i].previous = (i + count - 1) % count;
      this->corners_[i].next = (i + 1) % count;
    }
    this->findSharedPlaces();
    for (Id i = 0; i < count; ++i)
    {
      this->update(i);
      this->obstacles_.push_back(i);
    }
  }

  PolygonTriangles clip()
  {
    while (this->left_ > 2)
    {
      if (const Id ear = this->nextEar(); ear != NoId)
      {
        this->cut(ear);
      }
      else if (!this->cutAnyhow())
      {
        this->cutFan();
        this->result_.crossesItself = true;
      }
    }
    return std::move(this->result_);
  }

private:
  /// How strictly an ear is chosen: where outlines touch, its new edge may have to run along
  /// others.
  enum class Touching : unsigned char
  {
    Refused,
    Allowed
  };

  struct Corner
  {
    Id previous = NoId;
    Id next = NoId;
    /// 1 where the polygon is convex, -1 where it is concave, 0 where its edges lie on one line.
    int turn = 0;
    /// Whether another corner is at the same place.
    bool isShared = false;
    bool isCut = false;
    /// Counts changes; older entries of the queue are void.
    unsigned version = 0;
    /// Corners that were no ears because of this one.
    std::vector<Id> waiting;
  };

  /// Measure, order of insertion, corner, its version.
  using Candidate = std::tuple<double, std::size_t, Id, unsigned>;

  int side(Id a, Id b, Id c) const
  {
    return sideOfLine(this->flat_[a], this->flat_[b], this->flat_[c]);
  }
  bool isSamePlace(Id a, Id b) const
  {
    return this->flat_[a].x == this->flat_[b].x && this->flat_[a].y == this->flat_[b].y;
  }

  void findSharedPlaces()
  {
    std::vector<Id> byPlace(this->flat_.size());
    std::iota(byPlace.begin(), byPlace.end(), Id(0));
    std::sort(byPlace.begin(), byPlace.end(),
      [this](Id a, Id b)
      {
        const Vec2& p = this->flat_[a];
        const Vec2& q = this->flat_[b];
        return std::tie(p.x, p.y, a) < std::tie(q.x, q.y, b);
      });
    for (std::size_t i = 1; i < byPlace.size(); ++i)
    {
      if (this->isSamePlace(byPlace[i - 1], byPlace[i]))
      {
        this->corners_[byPlace[i - 1]].isShared = true;
        this->corners_[byPlace[i]].isShared = true;
      }
    }
  }

  /// After a corner got another neighbor.
  void update(Id i)
  {
    Corner& corner = this->corners_[i];
    corner.turn = this->side(corner.previous, i, corner.next);
    this->offer(i);
  }

  void offer(Id i)
  {
    Corner& corner = this->corners_[i];
    ++corner.version;
    if (corner.turn > 0)
    {
      this->queue_.emplace(this->measure(i), this->offered_++, i, corner.version);
    }
  }

  /// The squared perimeter over the area of the triangle that would be cut.
  double measure(Id i) const
  {
    const Vec3& before = this->outline_[this->corners_[i].previous];
    const Vec3& here = this->outline_[i];
    const Vec3& after = this->outline_[this->corners_[i].next];
    const Vec3 in = here - before;
    const Vec3 out = after - here;
    const double area = dot(cross(in, out), this->normal_);
    const double perimeter = norm(in) + norm(out) + norm(before - after);
    return area > 0.0 ? perimeter * perimeter / area : Infinity;
  }

  /// \returns NoId if there is no ear that touches nothing.
  Id nextEar()
  {
    while (!this->queue_.empty())
    {
      const auto [measure, order, i, version] = this->queue_.top();
      this->queue_.pop();
      if (this->corners_[i].isCut || this->corners_[i].version != version)
      {
        continue;
      }
      const Id obstacle = this->findObstacle(i, Touching::Refused);
      if (obstacle == NoId)
      {
        return i;
      }
      this->corners_[obstacle].waiting.push_back(i);
    }
    return NoId;
  }

  /// Finds a corner in the way of an ear's new edge, which goes from its next corner to its
  /// previous one.
  Id findObstacle(Id ear, Touching touching)
  {
    const Id a = this->corners_[ear].previous;
    const Id c = this->corners_[ear].next;
    if (this->left_ == 3)
    {
      return NoId;
    }
    // Does the new edge begin and end inside the polygon?
    const int least = touching == Touching::Refused ? 1 : 0;
    const Id before = this->corners_[a].previous;
    const Id after = this->corners_[c].next;
    if (this->corners_[a].turn > 0 && this->side(before, a, c) < least)
    {
      return before;
    }
    if (this->corners_[c].turn > 0 && this->side(a, c, after) < least)
    {
      return after;
    }
    const auto [lowX, highX] =
      std::minmax({ this->flat_[a].x, this->flat_[ear].x, this->flat_[c].x });
    const auto [lowY, highY] =
      std::minmax({ this->flat_[a].y, this->flat_[ear].y, this->flat_[c].y });
    this->forgetOldObstacles();
    for (const Id p : this->obstacles_)
    {
      const Vec2& place = this->flat_[p];
      if (place.x >= lowX && place.x <= highX && place.y >= lowY && place.y <= highY &&
        this->canBeObstacle(p) && p != a && p != ear && p != c &&
        this->isObstacle(p, a, ear, c, touching))
      {
        return p;
      }
    }
    return NoId;
  }

  /// If corners lie in a triangle, one of them is not convex.
  bool canBeObstacle(Id p) const
  {
    const Corner& corner = this->corners_[p];
    return !corner.isCut && (corner.turn <= 0 || corner.isShared);
  }
  void forgetOldObstacles()
  {
    if (this->obstacles_.size() > 2 * std::size_t(this->left_) || this->cutsSinceForgotten_ > 64)
    {
      const auto isOld = [this](Id p) { return !this->canBeObstacle(p); };
      this->obstacles_.erase(
        std::remove_if(this->obstacles_.begin(), this->obstacles_.end(), isOld),
        this->obstacles_.end());
      this->cutsSinceForgotten_ = 0;
    }
  }

  /// Whether corner p or an edge of it lies in the triangle a b c, whose side from c to a is new.
  bool isObstacle(Id p, Id a, Id b, Id c, Touching touching) const
  {
    const int ofAB = this->side(a, b, p);
    const int ofBC = this->side(b, c, p);
    const int ofCA = this->side(c, a, p);
    if (ofAB < 0 || ofBC < 0 || ofCA < 0)
    {
      return false;
    }
    if (ofAB > 0 && ofBC > 0 && (ofCA > 0 || touching == Touching::Refused))
    {
      return true;
    }
    // On the rim: do its edges go into the triangle, or along the new side?
    const int least = touching == Touching::Refused ? 0 : 1;
    const auto goesIn = [&](Id q)
    {
      return (ofAB > 0 || this->side(a, b, q) > 0) && (ofBC > 0 || this->side(b, c, q) > 0) &&
        (ofCA > 0 || this->side(c, a, q) >= least);
    };
    return goesIn(this->corners_[p].previous) || goesIn(this->corners_[p].next);
  }

  /// Cuts an ear whose new edge touches others, or one without area.
  bool cutAnyhow()
  {
    const Id first = this->anyCorner();
    Id i = first;
    // The tips of edges that stick out come first: beside them other ears could lie outside.
    do
    {
      const Corner& corner = this->corners_[i];
      if (corner.turn == 0 && this->isSamePlace(corner.previous, corner.next))
      {
        const Id again = corner.next; // the place where the edge began
        this->cut(i);
        if (this->left_ > 2)
        {
          this->cut(again);
        }
        return true;
      }
      i = corner.next;
    } while (i != first);
    do
    {
      if (this->corners_[i].turn > 0 && this->findObstacle(i, Touching::Allowed) == NoId)
      {
        const Id ends[] = { this->corners_[i].previous, this->corners_[i].next };
        this->cut(i);
        // Where the new edge goes back along the one before or after it, there is no area left.
        for (const Id end : ends)
        {
          if (this->left_ > 2 && this->corners_[end].turn == 0 && this->turnsBack(end))
          {
            this->cut(end);
          }
        }
        return true;
      }
      i = this->corners_[i].next;
    } while (i != first);
    do
    {
      if (this->corners_[i].turn == 0)
      {
        this->cut(i);
        return true;
      }
      i = this->corners_[i].next;
    } while (i != first);
    return false;
  }

  /// \param i whose edges lie on one line.
  bool turnsBack(Id i) const
  {
    const Vec2& here = this->flat_[i];
    const Vec2& before = this->flat_[this->corners_[i].previous];
    const Vec2& after = this->flat_[this->corners_[i].next];
    const auto isBeyond = [](double x, double p, double q)
    { return (p >= x && q >= x) || (p <= x && q <= x); };
    return isBeyond(here.x, before.x, after.x) && isBeyond(here.y, before.y, after.y);
  }

  Id anyCorner() const
  {
    Id i = 0;
    while (this->corners_[i].isCut)
    {
      ++i;
    }
    return i;
  }

  void cut(Id i)
  {
    Corner& corner = this->corners_[i];
    const Id before = corner.previous;
    const Id after = corner.next;
    this->result_.triangles.push_back({ i, after, before });
    corner.isCut = true;
    --this->left_;
    ++this->cutsSinceForgotten_;
    this->corners_[before].next = after;
    this->corners_[after].previous = before;
    if (this->left_ < 3)
    {
      return;
    }
    this->update(before);
    this->update(after);
    for (const Id changed : { i, before, after })
    {
      const std::vector<Id> waiting = std::exchange(this->corners_[changed].waiting, {});
      for (const Id other : waiting)
      {
        if (!this->corners_[other].isCut)
        {
          this->offer(other);
        }
      }
    }
  }

  void cutFan()
  {
    const Id first = this->anyCorner();
    while (this->left_ > 2)
    {
      const Id second = this->corners_[first].next;
      const Id third = this->corners_[second].next;
      this->result_.triangles.push_back({ first, second, third });
      this->corners_[first].next = third;
      --this->left_;
    }
  }

  const std::vector<Vec3>& outline_;
  const Vec3 normal_;
  const std::vector<Vec2>& flat_;
  /// How many corners are not cut yet.
  Id left_;
  std::vector<Corner> corners_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
  std::size_t offered_ = 0;
  std::vector<Id> obstacles_;
  std::size_t cutsSinceForgotten_ = 0;
  PolygonTriangles result_;
};

} // anonymous namespace

PolygonTriangles clipEars(
  const std::vector<Vec3>& outline, const Vec3& normal, const std::vector<Vec2>& flat)
{
  return EarClipper(outline, normal, flat).clip();
}

}
