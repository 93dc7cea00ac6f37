// SPDX-License-Identifier: BSD-3-Clause
#ifndef geodesic_Types_h
#define geodesic_Types_h

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace geodesic
{

/// Id of a vertex, a face or a halfedge. 32 bits hold the halfedges of 1.4 billion faces;
/// TriangleMesh refuses more with MeshTooLarge. Counts of windows are 64-bit.
using Id = std::uint32_t;

/// The number of a vertex in the whole surface, which several ranks may share
/// (MeshPartition::globalId()). Does not convert to the number in a mesh by itself.
enum class GlobalId : Id
{
};

constexpr Id NoId = std::numeric_limits<Id>::max();
/// The number of vertices that a surface may have: RayOrigin has 31 bits for their ids.
constexpr Id MaximumVertices = 0x7fffffffU;
constexpr double Infinity = std::numeric_limits<double>::infinity();

constexpr double Pi = 3.14159265358979323846;
constexpr double RightAngle = 0.5 * Pi;
constexpr double FullAngle = 2.0 * Pi;

/// A range of an array.
template <typename Item>
struct ArrayRange
{
  const Item* first = nullptr;
  const Item* last = nullptr;
  const Item* begin() const { return this->first; }
  const Item* end() const { return this->last; }
  std::size_t size() const { return static_cast<std::size_t>(this->last - this->first); }
};
using IdRange = ArrayRange<Id>;

/// Leaves the elements that resize() adds as they are in memory.
template <typename Value>
struct UninitializedAllocator : std::allocator<Value>
{
  template <typename Other>
  struct rebind
  {
    using other = UninitializedAllocator<Other>;
  };

  template <typename Element>
  void construct(Element* where) noexcept
  {
    ::new (static_cast<void*>(where)) Element;
  }
  template <typename Element, typename... Arguments>
  void construct(Element* where, Arguments&&... arguments)
  {
    ::new (static_cast<void*>(where)) Element{ std::forward<Arguments>(arguments)... };
  }
};

/// A vector for elements that tasks are about to write. resize() does not write them first: one
/// thread would do so alone, whereas each thread gets the memory that it writes first near itself.
template <typename Value>
using UninitializedVector = std::vector<Value, UninitializedAllocator<Value>>;

using Vec3 = std::array<double, 3>;
using Triangle = std::array<Id, 3>;
using GlobalTriangle = std::array<GlobalId, 3>;

/// Whether no vertex is named twice.
inline bool hasThreeVertices(const Triangle& t)
{
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
}

inline Vec3 operator+(const Vec3& a, const Vec3& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}
inline Vec3 operator-(const Vec3& a, const Vec3& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}
inline Vec3 operator*(double s, const Vec3& a)
{
  return { s * a[0], s * a[1], s * a[2] };
}
inline double dot(const Vec3& a, const Vec3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vec3 cross(const Vec3& a, const Vec3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}
inline double norm(const Vec3& a)
{
  return std::sqrt(dot(a, a));
}

/// The largest absolute value.
inline double largestCoordinate(const Vec3& a)
{
  return std::max({ std::abs(a[0]), std::abs(a[1]), std::abs(a[2]) });
}

inline bool isFinite(const Vec3& a)
{
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

/// A point or vector in the plane of an unfolded face.
struct Vec2
{
  double x = 0.0;
  double y = 0.0;
};
inline Vec2 operator+(Vec2 a, Vec2 b)
{
  return { a.x + b.x, a.y + b.y };
}
inline Vec2 operator-(Vec2 a, Vec2 b)
{
  return { a.x - b.x, a.y - b.y };
}
inline Vec2 operator*(double s, Vec2 a)
{
  return { s * a.x, s * a.y };
}
inline double dot(Vec2 a, Vec2 b)
{
  return a.x * b.x + a.y * b.y;
}
inline double cross(Vec2 a, Vec2 b)
{
  return a.x * b.y - a.y * b.x;
}
inline double norm(Vec2 a)
{
  return std::sqrt(dot(a, a));
}

/// Asks the processor to fetch memory that will be read soon; does nothing if the compiler has no
/// means.
inline void prefetch(const void* address)
{
#if defined(__GNUC__) || defined(__clang__)
  __builtin_prefetch(address);
  __builtin_prefetch(static_cast<const char*>(address) + 64);
#else
  (void)address;
#endif
}

}

#endif
