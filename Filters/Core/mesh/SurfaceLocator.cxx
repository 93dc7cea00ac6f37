// SPDX-License-Identifier: BSD-3-Clause
#include "mesh/SurfaceLocator.h"

#include "Tolerance.h"
#include "mesh/SurfaceLocatorOnRanks.h"
#include "mesh/SurfaceSnap.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace geodesic
{

namespace
{

constexpr Id FacesInLeaf = 8;

/// Each part of a node has at least this fraction of its faces, so that the tree stays shallow.
constexpr std::ptrdiff_t LeastPart = 8;

/// Ranks exchange the candidates of so many points at a time, which bounds the size of messages.
constexpr std::size_t PointsAtATime = 4096;

/// Points searched between two reports.
constexpr std::size_t PointsPerReport = 256;

/// Searching the first point builds most of the tree, which takes this share of the job.
constexpr double FirstPoint = 0.5;

void addFace(const TriangleMesh& mesh, Id face, Box& box)
{
  for (const Id corner : mesh.triangle(face))
  {
    box.add(mesh.point(corner));
  }
}

/// The unit normal of a face; zero if it has none, being without area.
Vec3 normalOf(const TriangleMesh& mesh, Id face)
{
  const auto& [i, j, k] = mesh.triangle(face);
  const std::array<Vec3, 3> corners = { mesh.point(i), mesh.point(j), mesh.point(k) };
  if (isWithoutArea(shapeOf(corners), corners))
  {
    return {};
  }
  const Vec3 normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  return (1.0 / norm(normal)) * normal;
}

/// Whether a face may be of the wall opposite to a point's closest faces. The faces' orientations
/// do not matter.
bool isOpposite(
  const TriangleMesh& mesh, Id face, const Vec3& toClosest, const std::vector<ClosestFace>& closest)
{
  const Vec3 normal = normalOf(mesh, face);
  const double distance = norm(toClosest);
  return std::all_of(closest.begin(), closest.end(),
    [&](const ClosestFace& near)
    {
      return std::abs(dot(normal, near.normal)) >= tolerance::AboutParallel &&
        dot(toClosest, near.toPlace) <= -tolerance::AboutParallel * distance * norm(near.toPlace);
    });
}

/// How far the wall opposite to a point's closest faces may be; negative if there is none.
double limitOfOpposite(const std::vector<ClosestFace>& closest)
{
  double limit = Infinity;
  for (const ClosestFace& face : closest)
  {
    limit = std::min(limit, face.isBeside ? tolerance::AboutAsNear * norm(face.toPlace) : -1.0);
  }
  return closest.empty() ? -1.0 : limit;
}

/// Whether a face has all vertices of the part of another face that contains its closest point.
bool hasPart(const GlobalTriangle& corners, const FaceCandidate& other)
{
  bool hasAll = true;
  for (std::size_t k = 0; k < 3; ++k)
  {
    hasAll = hasAll &&
      (!other.isPart[k] ||
        std::find(corners.begin(), corners.end(), other.corners[k]) != corners.end());
  }
  return hasAll;
}

/// Whether a face is farther than another although rounding may make their distances equal: its
/// closest point is also a point of the other face, which has a closer one.
bool isFartherThan(const FaceCandidate& face, const FaceCandidate& other)
{
  return hasPart(other.corners, face) && !hasPart(face.corners, other) &&
    norm(other.toClosest - face.toClosest) > face.precision;
}

/// The faces whose distances cannot be distinguished from the least, in their order. Around the
/// centre of a sphere there are many.
std::vector<const FaceCandidate*> closestOf(const std::vector<FaceCandidate>& faces, double least)
{
  std::vector<const FaceCandidate*> closest;
  std::vector<std::pair<GlobalId, const FaceCandidate*>> atVertices;
  for (const FaceCandidate& face : faces)
  {
    if (face.distance <= least + face.measuring)
    {
      closest.push_back(&face);
    }
    for (const GlobalId vertex : face.corners)
    {
      atVertices.emplace_back(vertex, &face);
    }
  }
  std::sort(atVertices.begin(), atVertices.end());
  const auto isFarther = [&](const FaceCandidate* face)
  {
    const GlobalId vertex = face->corners[face->isPart[0] ? 0 : face->isPart[1] ? 1 : 2];
    auto at = std::lower_bound(atVertices.begin(), atVertices.end(), vertex,
      [](const auto& entry, GlobalId wanted) { return entry.first < wanted; });
    while (at != atVertices.end() && at->first == vertex && !isFartherThan(*face, *at->second))
    {
      ++at;
    }
    return at != atVertices.end() && at->first == vertex;
  };
  const auto last = std::remove_if(closest.begin(), closest.end(), isFarther);
  if (last != closest.begin()) // else each loses to another, by rounding
  {
    closest.erase(last, closest.end());
  }
  return closest;
}

/// Chooses, among the closest candidates of a point, the faces that the point may be put onto, in
/// their order, given the precision of coordinates as in snapToFace (at most SnapFraction of a
/// face's longest edge).
/// A face that is almost as close as the closest may put the point far from the closest place. So
/// these are the faces whose distances cannot be distinguished from the least by measuring, and
/// those that put the point within the precision of the closest place.
std::vector<FaceCandidate> chosen(const std::vector<FaceCandidate>& closest)
{
  if (closest.empty())
  {
    return {}; // a surface without faces
  }
  const auto isCloser = [](const FaceCandidate& a, const FaceCandidate& b)
  { return a.distance != b.distance ? a.distance < b.distance : a.face < b.face; };
  const double least = std::min_element(closest.begin(), closest.end(), isCloser)->distance;
  const std::vector<const FaceCandidate*> equal = closestOf(closest, least);
  const FaceCandidate& best = **std::min_element(equal.begin(), equal.end(),
    [&](const FaceCandidate* a, const FaceCandidate* b) { return isCloser(*a, *b); });
  std::vector<FaceCandidate> result;
  std::copy_if(closest.begin(), closest.end(), std::back_inserter(result),
    [&](const FaceCandidate& face)
    {
      return norm(face.toPlace - best.toClosest) <= face.precision ||
        std::binary_search(equal.begin(), equal.end(), &face);
    });
  // A face without area conducts along its line only: faces beside it come first.
  const auto flat = std::stable_partition(
    result.begin(), result.end(), [](const FaceCandidate& face) { return face.normal != Vec3{}; });
  result.erase(flat == result.begin() ? result.end() : flat, result.end());
  return result;
}

/// The faces of a point, in the order of ClosestFace.
///
/// \param candidates of all ranks.
std::vector<ClosestFace> facesOf(
  const std::vector<FaceCandidate>& candidates, double least, double coordinatePrecision)
{
  std::vector<ClosestFace> faces;
  for (const FaceCandidate& face : chosen(candidates))
  {
    const double precision = face.rounding / tolerance::Rounding * coordinatePrecision;
    faces.push_back({ face.face, face.distance <= least + face.rounding, face.distance > precision,
      face.toPlace, face.normal });
  }
  std::sort(faces.begin(), faces.end());
  return faces;
}

/// Sets what chosen() needs to know of a candidate.
void complete(
  const TriangleMesh& mesh, const Vec3& point, double coordinatePrecision, FaceCandidate& candidate)
{
  const Id face = candidate.face.id;
  const SnappedPoint closest = snapToFace(mesh, face, point, 0.0);
  const std::array<double, 3> weights = barycentric(mesh, closest.place, face);
  candidate.measuring = tolerance::SnapRoundings * tolerance::Rounding *
    (candidate.distance + mesh.shape(face).longest());
  candidate.toClosest = closest.offset;
  candidate.toPlace = snapToFace(mesh, face, point, coordinatePrecision).offset;
  candidate.normal = normalOf(mesh, face);
  const auto& [a, b, c] = mesh.triangle(face);
  candidate.corners = { GlobalId{ a }, GlobalId{ b }, GlobalId{ c } }; // until it is sent
  for (std::size_t k = 0; k < 3; ++k)
  {
    candidate.isPart[k] = weights[k] != 0.0;
  }
}

} // anonymous namespace

/// A tree of boxes around a mesh's faces that grows where points are searched: a few points cost
/// about as much as a scan of all faces, many points no more than the complete tree.
class SurfaceLocator::FaceTree
{
public:
  /// \param mesh must outlive the tree.
  explicit FaceTree(const TriangleMesh& mesh)
    : mesh_(mesh)
    , faces_(mesh.numberOfFaces())
  {
    std::iota(this->faces_.begin(), this->faces_.end(), Id(0));
    this->nodes_.push_back(this->makeNode(0, mesh.numberOfFaces()));
  }

  /// The faces that may be among the closest, unordered.
  ///
  /// \param limit the distance beyond which none is wanted.
  /// \param oppositeTo the point's closest faces if only those opposite to them are wanted, or
  /// null.
  std::vector<FaceCandidate> candidates(const Vec3& point, double limit,
    const std::vector<ClosestFace>* oppositeTo, double coordinatePrecision, const Job& job)
  {
    Search search{ point, oppositeTo, coordinatePrecision, job, limit, {}, 0.0 };
    this->search(search, 0);
    std::vector<FaceCandidate>& found = search.found;
    const auto isOver = [&](const FaceCandidate& f) { return !f.isClosest(search.distance); };
    found.erase(std::remove_if(found.begin(), found.end(), isOver), found.end());
    for (FaceCandidate& candidate : found)
    {
      complete(this->mesh_, point, coordinatePrecision, candidate);
    }
    return std::move(found);
  }

private:
  struct Node
  {
    Box box;
    /// A range of faces_.
    Id first;
    Id last;
    /// The first of its two parts, which are adjacent; NoId before the node is divided.
    Id parts = NoId;
  };
  struct Search
  {
    const Vec3& point;
    const std::vector<ClosestFace>* oppositeTo;
    const double coordinatePrecision;
    const Job& job;
    double distance;
    std::vector<FaceCandidate> found;
    /// The fraction of the faces that the search has excluded while the tree grows.
    double done;
  };

  Node makeNode(Id first, Id last) const
  {
    Node node{ {}, first, last };
    for (Id i = first; i < last; ++i)
    {
      addFace(this->mesh_, this->faces_[i], node.box);
    }
    return node;
  }

  // Divides the faces of a node into two parts: at the middle of its box if that leaves a fair
  // share on both sides, else into halves.
  Id findMiddle(const Node& node)
  {
    const Vec3 size = node.box.high - node.box.low;
    const auto axis =
      static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
    // Three times the centre: only the order of the faces matters.
    const auto centre = [this, axis](Id face)
    {
      const auto& [a, b, c] = this->mesh_.triangle(face);
      return this->mesh_.point(a)[axis] + this->mesh_.point(b)[axis] + this->mesh_.point(c)[axis];
    };
    const auto first = this->faces_.begin() + node.first;
    const auto last = this->faces_.begin() + node.last;
    const double middle = 1.5 * (node.box.low[axis] + node.box.high[axis]);
    auto cut = std::partition(first, last, [&](Id face) { return centre(face) < middle; });
    if (std::min(cut - first, last - cut) < (last - first) / LeastPart)
    {
      cut = first + (last - first) / 2;
      std::nth_element(first, cut, last, [&](Id a, Id b) { return centre(a) < centre(b); });
    }
    return static_cast<Id>(cut - this->faces_.begin());
  }

  void split(Id node, Search& search)
  {
    const Node whole = this->nodes_[node];
    const double size = static_cast<double>(whole.last - whole.first);
    search.done = std::max(search.done, 1.0 - size / static_cast<double>(this->faces_.size()));
    search.job.reach(search.done);
    const Id middle = this->findMiddle(whole);
    this->nodes_.push_back(this->makeNode(whole.first, middle));
    this->nodes_.push_back(this->makeNode(middle, whole.last));
    this->nodes_[node].parts = static_cast<Id>(this->nodes_.size() - 2);
  }

  void search(Search& search, Id number)
  {
    const Node node = this->nodes_[number];
    if (node.box.distanceTo(search.point) >
      search.distance + precisionFor(node.box, search.point, search.coordinatePrecision))
    {
      return;
    }
    if (node.last - node.first <= FacesInLeaf)
    {
      for (Id i = node.first; i < node.last; ++i)
      {
        this->tryFace(search, this->faces_[i]);
      }
      return;
    }
    if (node.parts == NoId)
    {
      this->split(number, search);
    }
    const Id parts = this->nodes_[number].parts;
    const bool secondFirst = this->nodes_[parts + 1].box.distanceTo(search.point) <
      this->nodes_[parts].box.distanceTo(search.point);
    this->search(search, secondFirst ? parts + 1 : parts);
    this->search(search, secondFirst ? parts : parts + 1);
  }

  void tryFace(Search& search, Id face) const
  {
    Box box;
    addFace(this->mesh_, face, box);
    const double byCoordinates = precisionFor(box, search.point, search.coordinatePrecision);
    if (box.distanceTo(search.point) > search.distance + byCoordinates)
    {
      return; // measuring takes several times as long
    }
    const Vec3 toClosest = snapToFace(this->mesh_, face, search.point, 0.0).offset;
    if (search.oppositeTo && !isOpposite(this->mesh_, face, toClosest, *search.oppositeTo))
    {
      return;
    }
    const double distance = norm(toClosest);
    // Far from the origin roundings may be as large as faces; then the closest face counts.
    const double precision =
      std::min(byCoordinates, tolerance::SnapFraction * this->mesh_.shape(face).longest());
    if (distance <= search.distance + precision)
    {
      const double rounding = byCoordinates / search.coordinatePrecision * tolerance::Rounding;
      search.distance = std::min(search.distance, distance);
      search.found.push_back({ { 0, face }, distance, precision, rounding });
    }
  }

  const TriangleMesh& mesh_;
  std::vector<Id> faces_;
  std::vector<Node> nodes_;
};

SurfaceLocator::SurfaceLocator(const MeshPartition& surface)
  : surface_(surface)
{
}

SurfaceLocator::~SurfaceLocator() = default;

void SurfaceLocator::plantTree()
{
  const TriangleMesh& mesh = this->surface_.mesh();
  this->tree_ = std::make_unique<FaceTree>(mesh);
  for (Id face = this->surface_.firstOwnFace(); face < this->surface_.endOfOwnFaces(); ++face)
  {
    addFace(mesh, face, this->box_);
  }
}

ClosestFaces SurfaceLocator::closest(const std::vector<Vec3>& points,
  const std::vector<std::uint8_t>& isWanted, double coordinatePrecision, const Job& job)
{
  return this->find(points, isWanted, nullptr, coordinatePrecision, job);
}

ClosestFaces SurfaceLocator::opposite(const std::vector<Vec3>& points,
  const std::vector<std::uint8_t>& isWanted, const ClosestFaces& closest,
  double coordinatePrecision, const Job& job)
{
  return this->find(points, isWanted, &closest, coordinatePrecision, job);
}

ClosestFaces SurfaceLocator::find(const std::vector<Vec3>& points,
  const std::vector<std::uint8_t>& isWanted, const ClosestFaces* oppositeTo,
  double coordinatePrecision, const Job& job)
{
  if (!this->tree_ && std::find(isWanted.begin(), isWanted.end(), 1) != isWanted.end())
  {
    this->plantTree();
  }
  const Job growing = job.part(0.0, FirstPoint);
  const Job searching = job.part(FirstPoint, 1.0);
  std::size_t searched = 0;
  ClosestFaces result;
  while (result.size() < points.size())
  {
    const std::size_t first = result.size();
    const std::size_t last = std::min(first + PointsAtATime, points.size());
    std::vector<double> limits(last - first, Infinity);
    for (std::size_t i = first; i < last && oppositeTo; ++i)
    {
      limits[i - first] = isWanted[i] ? limitOfOpposite((*oppositeTo)[i]) : -1.0;
    }
    const auto search = [&](std::size_t i) -> std::vector<FaceCandidate>
    {
      if (!isWanted[first + i] || limits[i] < 0.0)
      {
        return {};
      }
      if (searched > 0 && searched % PointsPerReport == 0)
      {
        searching.reach(static_cast<double>(searched) / static_cast<double>(points.size()));
      }
      ++searched;
      return this->tree_->candidates(points[first + i], limits[i],
        oppositeTo ? &(*oppositeTo)[first + i] : nullptr, coordinatePrecision, growing);
    };
    const FoundOnRanks found = searchOnRanks(this->surface_, this->box_,
      { points.data() + first, points.data() + last }, limits, coordinatePrecision, search);
    for (std::size_t i = 0; i < found.least.size(); ++i)
    {
      result.push_back(facesOf(found.candidates[i], found.least[i], coordinatePrecision));
    }
  }
  return result;
}

}
