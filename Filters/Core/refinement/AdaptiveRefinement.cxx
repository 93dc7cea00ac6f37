// SPDX-License-Identifier: BSD-3-Clause
#include "refinement/AdaptiveRefinement.h"

#include "Errors.h"
#include "field/FaceEnvelope.h"
#include "refinement/InterpolationError.h"
#include "refinement/RedGreenMesh.h"
#include "Tolerance.h"

#include <algorithm>
#include <queue>

namespace geodesic
{

namespace
{

/// Of the progress, for the first look at all faces, and for the output.
constexpr double ShareOfFirstPass = 0.3;
constexpr double ShareOfOutput = 0.1;

double angleBetween(Vec2 a, Vec2 b)
{
  return std::atan2(std::abs(cross(a, b)), dot(a, b));
}

double leastAngle(Vec2 a, Vec2 b, Vec2 c)
{
  return std::min(
    { angleBetween(b - a, c - a), angleBetween(c - b, a - b), angleBetween(a - c, b - c) });
}

double sizeOf(const LinearPiece& piece)
{
  const std::array<Vec2, 3>& c = piece.corners;
  return std::max({ norm(c[1] - c[0]), norm(c[2] - c[1]), norm(c[0] - c[2]) });
}

class Refiner
{
public:
  Refiner(const DistanceField& field, const RefinementOptions& options);
  RefinedMesh run();

private:
  /// A leaf over the tolerance.
  struct Violation
  {
    double error;
    Id triangle;
    Id splitEdges;
    double limit;
    bool operator<(const Violation& other) const
    {
      return this->error != other.error ? this->error < other.error
                                        : this->triangle > other.triangle;
    }
  };
  /// What is known about a triangle.
  struct Check
  {
    /// Certified against the distance of all faces.
    double bound = 0.0;
    /// A difference that occurs.
    double sample = 0.0;
    /// Whether it may stay.
    bool passed = true;
    /// What the differences within its face were held against.
    double limit = Infinity;
  };
  /// A triangle of the output, or one that would be.
  struct Piece
  {
    Id face;
    Triangle corners;
    std::array<Deviation, 3> deviations;
  };

  std::vector<std::uint8_t> findFrozen() const;
  bool isFrozen(Id face) const;
  void assessFaces();
  void assess(Id triangle);
  void refineWorst();
  void refine(const Violation& violation);
  void certifyRest();

  double distanceAt(Id point) const;
  double ownDistance(Id point, Vec2 place) const;
  Vec2 planePlace(Id point) const;
  Deviation deviationOf(Id edge);
  Deviation deviationIn(Id face, Id a, Id b);
  Check check(const Piece& piece, bool tight);
  Check checkLeaf(Id triangle, bool tight);
  Check closeBest(Id triangle);
  std::vector<Piece> piecesOf(Id triangle, const RedGreenMesh::Closing& closing);
  Check checkClosing(Id triangle, const RedGreenMesh::Closing& closing, bool tight);

  RedGreenMesh::Placement placeSplit(Id edge);
  double splitWeight(Id edge);
  bool shapesAllow(Id edge, double weight);
  bool mayClose(Id triangle);
  double angleOf(Id face, const RedGreenMesh::Closing& closing);
  double wantedAngle(Id face, double deviation);
  double largestAround(Id triangle);
  double angleWith(Id triangle, Id edge, double weight);
  double distanceOnEdge(Id edge, double weight);

  double fractionDone(double worst) const;
  void report(double fraction);
  void putOut(RefinedMesh& result);

  const DistanceField& field_;
  const TriangleMesh& mesh_;
  const RefinementOptions& options_;
  bool exact_;
  double tolerance_;
  FaceEnvelope envelope_;
  InterpolationError error_;
  RedGreenMesh triangles_;
  RedGreenMesh::Place place_;
  RedGreenMesh::MayClose mayClose_;
  std::priority_queue<Violation> violations_;
  double bound_ = 0.0;
  bool stopped_ = false;
  double worstAtFirst_ = 0.0;
  double reported_ = 0.0;
  Id sinceReport_ = 0;
};

Refiner::Refiner(const DistanceField& field, const RefinementOptions& options)
  : field_(field)
  , mesh_(field.mesh())
  , options_(options)
  , exact_(field.relativeErrorBound() == 0.0)
  , tolerance_(options.tolerance)
  , envelope_(field)
  , error_(field)
  , triangles_(field.mesh(), this->findFrozen())
  , place_([this](Id edge) { return this->placeSplit(edge); })
  , mayClose_([this](Id triangle) { return this->mayClose(triangle); })
{
}

bool Refiner::isFrozen(Id face) const
{
  for (const Id vertex : this->mesh_.triangle(face))
  {
    if (!(this->field_.vertexDistances()[vertex] < Infinity))
    {
      return true;
    }
  }
  return !this->field_.knowsInside(face);
}

std::vector<std::uint8_t> Refiner::findFrozen() const
{
  std::vector<std::uint8_t> frozen(this->mesh_.numberOfFaces());
  for (Id face = 0; face < this->mesh_.numberOfFaces(); ++face)
  {
    frozen[face] = this->isFrozen(face) ? 1 : 0;
  }
  return frozen;
}

RefinedMesh Refiner::run()
{
  this->bound_ = this->field_.droppedErrorBound();
  this->assessFaces();
  this->refineWorst();
  this->certifyRest();
  RefinedMesh result;
  result.errorBound = this->bound_;
  result.stoppedAtMaximum = this->stopped_;
  this->putOut(result);
  return result;
}

void Refiner::assessFaces()
{
  for (Id face = 0; face < this->mesh_.numberOfFaces(); ++face)
  {
    this->report(ShareOfFirstPass * face / this->mesh_.numberOfFaces());
    if (this->triangles_.isFrozen(face))
    {
      continue;
    }
    double largest = 0.0;
    for (const Id vertex : this->mesh_.triangle(face))
    {
      largest = std::max(largest, this->field_.vertexDistances()[vertex]);
    }
    const double rounding = tolerance::FaceRounding * largest;
    const double quick = this->error_.ofFace(face, this->tolerance_ - rounding, this->bound_);
    if (quick < Infinity)
    {
      this->bound_ = std::max(this->bound_, quick + rounding);
    }
    else
    {
      this->assess(face);
    }
  }
}

double Refiner::distanceAt(Id point) const
{
  const Id inputPoints = this->triangles_.numberOfInputPoints();
  return point < inputPoints ? this->field_.vertexDistances()[point]
                             : this->triangles_.points()[point - inputPoints].distance;
}

Vec2 Refiner::planePlace(Id point) const
{
  return this->envelope_.inPlane(
    barycentric(this->mesh_, this->triangles_.place(point), this->envelope_.face()));
}

// The distance as the face at hand has it: in an approximate field another face at the point may
// have a smaller one.
double Refiner::ownDistance(Id point, Vec2 place) const
{
  return this->exact_ ? this->distanceAt(point) : this->envelope_.distance(place);
}

Deviation Refiner::deviationIn(Id face, Id a, Id b)
{
  this->envelope_.enter(face);
  const Vec2 p = this->planePlace(a);
  const Vec2 q = this->planePlace(b);
  return largestDeviation(
    this->envelope_.along(p, q), norm(q - p), this->ownDistance(a, p), this->ownDistance(b, q));
}

Deviation Refiner::deviationOf(Id id)
{
  RedGreenMesh::Edge& edge = this->triangles_.edgeData(id);
  if (edge.measured)
  {
    return edge.deviation;
  }
  edge.measured = true;
  if (edge.halfedge == NoId)
  {
    edge.deviation = this->deviationIn(edge.face, edge.ends[0], edge.ends[1]);
    return edge.deviation;
  }
  // One face sees the whole exact distance along its edge.
  bool found = false;
  Id halfedge = edge.halfedge;
  do
  {
    const Id face = TriangleMesh::faceOf(halfedge);
    if (!this->triangles_.isFrozen(face) && !(found && this->exact_))
    {
      const Deviation d = this->deviationIn(face, edge.ends[0], edge.ends[1]);
      if (!found || d.above > edge.deviation.above)
      {
        edge.deviation.above = d.above;
        edge.deviation.aboveAt = d.aboveAt;
      }
      if (!found || d.below > edge.deviation.below)
      {
        edge.deviation.below = d.below;
        edge.deviation.belowAt = d.belowAt;
      }
      found = true;
    }
    halfedge = this->mesh_.nextSibling(halfedge);
  } while (halfedge != edge.halfedge);
  return edge.deviation;
}

std::vector<Refiner::Piece> Refiner::piecesOf(Id triangle, const RedGreenMesh::Closing& closing)
{
  const Id face = this->triangles_.faceOf(triangle);
  const auto deviationBetween = [&](Id i, Id j)
  {
    if (j == (i + 1) % closing.size)
    {
      const Id edge = closing.edges[i];
      return this->deviationOf(
        edge == NoId ? this->triangles_.edge(triangle, closing.along[i]) : edge);
    }
    // the same either way, to the last digit
    const auto [a, b] = std::minmax(closing.points[i], closing.points[j]);
    return this->deviationIn(face, a, b);
  };
  std::vector<Piece> pieces;
  for (Id i = 0; i < closing.count; ++i)
  {
    const std::array<Id, 3>& t = closing.triangles[i];
    Piece piece{ face, {}, {} };
    for (std::size_t k = 0; k < 3; ++k)
    {
      piece.corners[k] = closing.points[t[k]];
      piece.deviations[k] = deviationBetween(t[k], t[(k + 1) % 3]);
    }
    pieces.push_back(piece);
  }
  return pieces;
}

// In an approximate field the faces around a point differ by what merging has changed, and no
// refinement can undo that: what is left of the tolerance, but half of it at least, is for the
// triangle. Whatever the rounding, refinement ends: the distance changes by no more than the way,
// so that there is nothing left to refine in a triangle as small as that.
Refiner::Check Refiner::check(const Piece& piece, bool tight)
{
  this->envelope_.enter(piece.face);
  LinearPiece linear;
  double largest = 0.0;
  double difference = 0.0;
  Deviation onEdges;
  for (std::size_t k = 0; k < 3; ++k)
  {
    const double distance = this->distanceAt(piece.corners[k]);
    linear.corners[k] = this->planePlace(piece.corners[k]);
    linear.values[k] = this->ownDistance(piece.corners[k], linear.corners[k]);
    largest = std::max(largest, distance);
    difference = std::max(difference, std::abs(linear.values[k] - distance));
    onEdges.above = std::max(onEdges.above, piece.deviations[k].above);
    onEdges.below = std::max(onEdges.below, piece.deviations[k].below);
  }
  const double rounding = tolerance::FaceRounding * largest;
  Check result;
  result.limit = std::max(this->tolerance_ - difference - rounding, 0.5 * this->tolerance_);
  const bool small = sizeOf(linear) <= result.limit;
  if (onEdges.largest() > result.limit && !small && !tight)
  {
    result.sample = onEdges.largest();
    result.passed = false;
    return result;
  }
  const InterpolationError::Inside inside =
    this->error_.ofTriangle(this->envelope_, linear, onEdges, result.limit, tight || small);
  const double own = std::max(inside.bound, onEdges.largest());
  result.bound = own + rounding + difference;
  result.sample = inside.sample;
  result.passed = small || own <= result.limit;
  return result;
}

Refiner::Check Refiner::checkClosing(Id triangle, const RedGreenMesh::Closing& closing, bool tight)
{
  Check worst;
  for (const Piece& piece : this->piecesOf(triangle, closing))
  {
    const Check one = this->check(piece, tight);
    worst.bound = std::max(worst.bound, one.bound);
    worst.sample = std::max(worst.sample, one.sample);
    worst.limit = std::min(worst.limit, one.limit);
    worst.passed = worst.passed && one.passed;
  }
  return worst;
}

Refiner::Check Refiner::checkLeaf(Id triangle, bool tight)
{
  return this->checkClosing(
    triangle, this->triangles_.closing(triangle, this->triangles_.wayOf(triangle)), tight);
}

// Flips the inner edges of a leaf: of the ways that pass, the one of the best shapes, and where
// none does that of the smallest error. Ways of bad shapes are taken where there is no other.
Refiner::Check Refiner::closeBest(Id triangle)
{
  const Id face = this->triangles_.faceOf(triangle);
  const double wanted = this->wantedAngle(face, this->largestAround(triangle));
  const Id ways = RedGreenMesh::waysToClose(this->triangles_.splitEdges(triangle));
  std::array<std::pair<double, Id>, 4> order;
  for (Id way = 0; way < ways; ++way)
  {
    order[way] = { -this->angleOf(face, this->triangles_.closing(triangle, way)), way };
  }
  std::sort(order.begin(), order.begin() + ways);
  Check best;
  for (Id i = 0; i < ways && (i == 0 || -order[i].first >= wanted); ++i)
  {
    const Id way = order[i].second;
    const Check check =
      this->checkClosing(triangle, this->triangles_.closing(triangle, way), false);
    if (i == 0 || check.passed || check.sample < best.sample)
    {
      this->triangles_.setWay(triangle, way);
      best = check;
    }
    if (best.passed)
    {
      break;
    }
  }
  return best;
}

void Refiner::assess(Id triangle)
{
  const Check check = this->closeBest(triangle);
  if (check.passed)
  {
    this->bound_ = std::max(this->bound_, check.bound);
    return;
  }
  const double error = std::max(check.sample, check.limit);
  this->violations_.push({ error, triangle, this->triangles_.splitEdges(triangle), check.limit });
}

void Refiner::refineWorst()
{
  constexpr std::uint64_t numberable = NoId / 5; // ids are 3 * part + k, and parts have parts
  const std::uint64_t limit = this->options_.maximumFaces > 0
    ? std::min(this->options_.maximumFaces, numberable)
    : numberable;
  this->worstAtFirst_ = this->violations_.empty() ? 0.0 : this->violations_.top().error;
  while (!this->violations_.empty())
  {
    const Violation worst = this->violations_.top();
    if (!this->triangles_.isLeaf(worst.triangle) ||
      this->triangles_.splitEdges(worst.triangle) != worst.splitEdges)
    {
      this->violations_.pop(); // split or assessed again since
      continue;
    }
    this->triangles_.begin();
    this->refine(worst);
    const std::vector<Id> changed = this->triangles_.close(this->place_, this->mayClose_);
    if (this->triangles_.numberOfTriangles() > limit)
    {
      this->triangles_.rollBack();
      this->stopped_ = true;
      return;
    }
    this->violations_.pop();
    for (const Id triangle : changed)
    {
      this->assess(triangle);
    }
    this->report(this->fractionDone(worst.error));
  }
}

// The errors fall from the worst at first to the tolerance, by about the same factor with each
// level.
double Refiner::fractionDone(double worst) const
{
  const double open = std::log(worst / this->tolerance_);
  const double openAtFirst = std::log(this->worstAtFirst_ / this->tolerance_);
  const double done = openAtFirst > 0.0 ? 1.0 - std::clamp(open / openAtFirst, 0.0, 1.0) : 0.0;
  return ShareOfFirstPass + (1.0 - ShareOfFirstPass - ShareOfOutput) * done;
}

// Splits the edges that are over the limit; where there are none, it is the inside, and one split
// into four gets the new edges there.
void Refiner::refine(const Violation& violation)
{
  const Id triangle = violation.triangle;
  bool isOver = false;
  for (Id k = 0; k < 3; ++k)
  {
    const Id edge = this->triangles_.edge(triangle, k);
    if (this->triangles_.edgeData(edge).split == NoId &&
      this->deviationOf(edge).largest() > violation.limit)
    {
      this->triangles_.split(edge, this->place_);
      isOver = true;
    }
  }
  if (!isOver)
  {
    this->triangles_.splitRed(triangle, this->place_);
  }
}

void Refiner::certifyRest()
{
  while (!this->violations_.empty())
  {
    const Violation rest = this->violations_.top();
    this->violations_.pop();
    if (this->triangles_.isLeaf(rest.triangle) &&
      this->triangles_.splitEdges(rest.triangle) == rest.splitEdges)
    {
      this->bound_ = std::max(this->bound_, this->checkLeaf(rest.triangle, true).bound);
    }
  }
}

RedGreenMesh::Placement Refiner::placeSplit(Id edge)
{
  const double weight = this->splitWeight(edge);
  return { weight, this->distanceOnEdge(edge, weight) };
}

double Refiner::splitWeight(Id id)
{
  constexpr double middle = 0.5;
  const Deviation deviation = this->deviationOf(id);
  if (!(deviation.largest() > this->tolerance_))
  {
    return middle;
  }
  const double aimed = splitPosition(deviation.at());
  for (const double weight : { aimed, 0.5 * (aimed + middle) })
  {
    if (this->shapesAllow(id, weight))
    {
      return weight;
    }
  }
  return middle;
}

bool Refiner::shapesAllow(Id edge, double weight)
{
  bool allowed = true;
  this->triangles_.forEachLeafAt(edge,
    [&](Id triangle)
    {
      if (allowed)
      {
        const double wanted =
          this->wantedAngle(this->triangles_.faceOf(triangle), this->deviationOf(edge).largest());
        allowed = this->angleWith(triangle, edge, weight) >= wanted;
      }
    });
  return allowed;
}

// Of the parts when an edge of such a deviation is split. Goes to the face, too.
double Refiner::wantedAngle(Id face, double deviation)
{
  this->envelope_.enter(face);
  const Triangle& corners = this->mesh_.triangle(face);
  const double least = leastAngle(
    this->planePlace(corners[0]), this->planePlace(corners[1]), this->planePlace(corners[2]));
  const double wanted = deviation > tolerance::WorthThinParts * this->tolerance_
    ? tolerance::LeastAngleOfThinParts
    : tolerance::LeastAngle;
  return std::min(wanted, tolerance::LeastAngleFraction * least);
}

double Refiner::largestAround(Id triangle)
{
  double largest = 0.0;
  for (Id k = 0; k < 3; ++k)
  {
    largest = std::max(largest, this->deviationOf(this->triangles_.edge(triangle, k)).largest());
  }
  return largest;
}

bool Refiner::mayClose(Id triangle)
{
  const Id face = this->triangles_.faceOf(triangle);
  const double wanted = this->wantedAngle(face, this->largestAround(triangle));
  const Id ways = RedGreenMesh::waysToClose(this->triangles_.splitEdges(triangle));
  for (Id way = 0; way < ways; ++way)
  {
    if (this->angleOf(face, this->triangles_.closing(triangle, way)) >= wanted)
    {
      return true;
    }
  }
  return false;
}

double Refiner::angleOf(Id face, const RedGreenMesh::Closing& closing)
{
  this->envelope_.enter(face);
  std::array<Vec2, 6> p;
  for (std::size_t i = 0; i < closing.size; ++i)
  {
    p[i] = this->planePlace(closing.points[i]);
  }
  double least = Infinity;
  for (Id i = 0; i < closing.count; ++i)
  {
    const std::array<Id, 3>& t = closing.triangles[i];
    least = std::min(least, leastAngle(p[t[0]], p[t[1]], p[t[2]]));
  }
  return least;
}

// The smallest angle of a leaf's four parts when one edge is split at the weight, the others where
// they are or in the middle.
double Refiner::angleWith(Id triangle, Id split, double weight)
{
  const Triangle corners = this->triangles_.corners(triangle);
  std::array<Vec2, 3> c;
  std::array<Vec2, 3> m;
  for (Id k = 0; k < 3; ++k)
  {
    c[k] = this->planePlace(corners[k]);
  }
  for (Id k = 0; k < 3; ++k)
  {
    const Id id = this->triangles_.edge(triangle, k);
    const RedGreenMesh::Edge& edge = this->triangles_.edgeData(id);
    double t = id == split ? weight : 0.5;
    t = edge.ends[0] == corners[k] ? t : 1.0 - t;
    m[k] = edge.split != NoId ? this->planePlace(edge.split) : c[k] + t * (c[(k + 1) % 3] - c[k]);
  }
  return std::min({ leastAngle(c[0], m[0], m[2]), leastAngle(m[0], c[1], m[1]),
    leastAngle(m[2], m[1], c[2]), leastAngle(m[0], m[1], m[2]) });
}

double Refiner::distanceOnEdge(Id id, double weight)
{
  const RedGreenMesh::Edge& edge = this->triangles_.edgeData(id);
  double least = Infinity;
  const auto look = [&](Id face)
  {
    this->envelope_.enter(face);
    const Vec2 p = this->planePlace(edge.ends[0]);
    const Vec2 q = this->planePlace(edge.ends[1]);
    least = std::min(least, this->envelope_.distance(p + weight * (q - p)));
  };
  if (edge.halfedge == NoId)
  {
    look(edge.face);
    return least;
  }
  Id halfedge = edge.halfedge;
  do
  {
    if (!this->triangles_.isFrozen(TriangleMesh::faceOf(halfedge)))
    {
      look(TriangleMesh::faceOf(halfedge));
    }
    halfedge = this->mesh_.nextSibling(halfedge);
  } while (halfedge != edge.halfedge);
  return least;
}

void Refiner::report(double fraction)
{
  constexpr Id stepsPerReport = 256;
  if (!this->options_.progress || this->sinceReport_++ % stepsPerReport != 0)
  {
    return;
  }
  this->reported_ = std::max(this->reported_, fraction);
  if (!this->options_.progress(std::min(this->reported_, 1.0)))
  {
    throw Aborted();
  }
}

/// Numbers the points of the output: where several of the caller's points are one vertex, a split
/// edge has a point for each pair of them.
class PointNumbering
{
public:
  PointNumbering(const RedGreenMesh& triangles, const TriangleMesh& mesh,
    const RefinementOptions& options, RefinedMesh& result)
    : triangles_(triangles)
    , mesh_(mesh)
    , options_(options)
    , result_(result)
  {
  }

  /// Faces come one after another.
  Id numberOf(Id face, Id point)
  {
    const Id inputPoints = this->triangles_.numberOfInputPoints();
    if (point < inputPoints)
    {
      const Triangle& corners = this->mesh_.triangle(face);
      const std::size_t k = point == corners[0] ? 0 : point == corners[1] ? 1 : 2;
      return this->options_.cornerPoints[face][k];
    }
    if (face != this->face_)
    {
      this->face_ = face;
      this->inFace_ = {};
    }
    const auto known = this->inFace_.find(point);
    if (known != this->inFace_.end())
    {
      return known->second;
    }
    const Id number = this->numberOfSplit(face, this->triangles_.points()[point - inputPoints]);
    this->inFace_.emplace(point, number);
    return number;
  }

  void add(const std::array<Id, 2>& parents, const RedGreenMesh::Point& split)
  {
    this->result_.points.push_back(
      { parents, split.weight, split.place, position(this->mesh_, split.place), split.distance });
  }

private:
  Id numberOfSplit(Id face, const RedGreenMesh::Point& split)
  {
    const Id a = this->numberOf(face, split.parents[0]);
    const Id b = this->numberOf(face, split.parents[1]);
    const std::uint64_t key = (static_cast<std::uint64_t>(a) << 32) | b;
    const auto [found, isNew] = this->numbers_.emplace(
      key, this->result_.numberOfInputPoints + static_cast<Id>(this->result_.points.size()));
    if (isNew)
    {
      this->add({ a, b }, split);
    }
    return found->second;
  }

  const RedGreenMesh& triangles_;
  const TriangleMesh& mesh_;
  const RefinementOptions& options_;
  RefinedMesh& result_;
  std::unordered_map<std::uint64_t, Id> numbers_;
  /// The numbers found in the face at hand: a point's ancestors are many times as many.
  std::unordered_map<Id, Id> inFace_;
  Id face_ = NoId;
};

void Refiner::putOut(RefinedMesh& result)
{
  const bool renumber = !this->options_.cornerPoints.empty();
  result.numberOfInputPoints =
    renumber ? this->options_.numberOfPoints : this->mesh_.numberOfVertices();
  const auto count = static_cast<double>(this->triangles_.numberOfTriangles());
  result.triangles.reserve(this->triangles_.numberOfTriangles());
  result.faces.reserve(this->triangles_.numberOfTriangles());
  PointNumbering numbering(this->triangles_, this->mesh_, this->options_, result);
  if (!renumber)
  {
    result.points.reserve(this->triangles_.points().size());
    for (const RedGreenMesh::Point& point : this->triangles_.points())
    {
      numbering.add(point.parents, point);
    }
  }
  this->triangles_.forEachTriangle(
    [&](Id face, Triangle corners)
    {
      if (renumber)
      {
        for (Id& corner : corners)
        {
          corner = numbering.numberOf(face, corner);
        }
      }
      this->report(1.0 - ShareOfOutput * (1.0 - static_cast<double>(result.faces.size()) / count));
      result.faces.push_back(face);
      result.triangles.push_back(corners);
    });
}

void requireUsable(const DistanceField& field, const RefinementOptions& options)
{
  if (!(options.tolerance > 0.0) || !(options.tolerance < Infinity))
  {
    throw Error("The refinement tolerance is " + std::to_string(options.tolerance) +
      "; give a positive number.");
  }
  if (options.tolerance < field.droppedTolerance())
  {
    throw Error("The refinement tolerance is " + std::to_string(options.tolerance) +
      ", but windows were kept for " + std::to_string(field.droppedTolerance()) + " only.");
  }
  if (!options.cornerPoints.empty() && options.cornerPoints.size() != field.mesh().numberOfFaces())
  {
    throw Error("Refinement was given points for the corners of " +
      std::to_string(options.cornerPoints.size()) + " faces, but the mesh has " +
      std::to_string(field.mesh().numberOfFaces()) + ".");
  }
}

} // anonymous namespace

RefinedMesh refine(const DistanceField& field, const RefinementOptions& options)
{
  requireUsable(field, options);
  return Refiner(field, options).run();
}

}
