// SPDX-License-Identifier: BSD-3-Clause
#include "Propagation.h"

#include "Errors.h"
#include "SourceWindows.h"
#include "Tolerance.h"
#include "WindowList.h"
#include "WindowMerge.h"

#include <algorithm>
#include <queue>

namespace geodesic
{

namespace
{

/// The side's face laid into the plane above the side.
UnfoldedFace unfold(const TriangleMesh& mesh, Id side)
{
  const FaceShape& shape = mesh.shape(TriangleMesh::faceOf(side));
  const std::size_t k = side % 3;
  const std::size_t next = (k + 1) % 3;
  UnfoldedFace face;
  face.length = shape.length[k];
  face.rightLength = shape.length[next];
  face.leftLength = shape.length[(k + 2) % 3];
  face.apex = { shape.cornerDot[k] / face.length, shape.area2 / face.length };
  face.apexFromEnd = shape.cornerDot[next] / face.length;
  // An edge without length carries no window; any axis will do.
  face.leftAxis = face.leftLength > 0.0 ? (1.0 / face.leftLength) * face.apex : Vec2{ 1.0, 0.0 };
  face.rightAxis = face.rightLength > 0.0
    ? (1.0 / face.rightLength) * Vec2{ face.apexFromEnd, -face.apex.y }
    : Vec2{ 1.0, 0.0 };
  return face;
}

/// Where the rays of a window pass the apex of the face they enter.
enum class Pass : std::uint8_t
{
  Left,
  Right,
  Both
};

/// The apex as seen through a list of windows.
struct ApexView
{
  static constexpr std::size_t None = static_cast<std::size_t>(-1);
  /// Least length of a path through the list to the apex, bent ones included, and the error of the
  /// window that gives it.
  double distance = Infinity;
  double error = 0.0;
  /// The window that holds the apex in its pencil at the least distance.
  std::size_t best = None;
};

/// Looks at the apex through every window; tells of each on which side of the apex its rays pass.
ApexView viewApex(const WindowRange& list, Vec2 apex, std::vector<Pass>& passes)
{
  passes.resize(list.size());
  ApexView view;
  const auto take = [&view](double distance, const Window& w)
  {
    if (distance < view.distance)
    {
      view.distance = distance;
      view.error = w.error;
    }
  };
  double straight = Infinity;
  Pass previous = Pass::Left; // as if a window before the first one passed on the left
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    const Window& w = list.first[i];
    const Pass pass = w.passesRightOf(w.begin, apex) ? Pass::Right
      : w.passesRightOf(w.end, apex)                 ? Pass::Both
                                                     : Pass::Left;
    passes[i] = pass;
    if (pass == Pass::Both)
    {
      const double distance = w.straightDistance(apex);
      take(distance, w);
      if (distance < straight)
      {
        straight = distance;
        view.best = i;
      }
    }
    // Between a window that passes on the left and one on the right, the apex is in a gap.
    if (pass == Pass::Right && previous == Pass::Left)
    {
      take(w.bentDistance(apex), w);
      if (i > 0)
      {
        take(list.first[i - 1].bentDistance(apex), list.first[i - 1]);
      }
    }
    if (pass == Pass::Left && i + 1 == list.size())
    {
      take(w.bentDistance(apex), w);
    }
    previous = pass;
  }
  return view;
}

/// The side of a face that windows leave through, with what is known at its corners.
struct Exit
{
  Id side;
  double length;
  /// Distances at the begin and the end of the leaving frame.
  double atBegin;
  double atEnd;
  /// The face's third corner in the leaving frame, its distance, and which end is far from it
  /// behind the pencil of every window that passes.
  Vec2 third;
  double atThird;
  bool beginIsFar;
};

/// Whether the window's distance at x is beyond a bound, told without a square root.
bool isBeaten(const Window& w, double x, double bound)
{
  const double reach = bound * (1.0 + tolerance::Tie) - w.sigma;
  const double dx = x - w.sourceX;
  return w.isLinear() ? w.sourceX * x > reach
                      : reach < 0.0 || dx * dx + w.sourceDepth * w.sourceDepth > reach * reach;
}

/// Whether a path through a corner beats the window everywhere (Xin & Wang 2009, "Improving Chen
/// and Han's algorithm on the discrete geodesic problem"). Distances along the edge change by no
/// more than the way, so a window that is longer at its end far from a corner is longer throughout.
bool isUseless(const Window& w, const Exit& exit)
{
  if (isBeaten(w, w.end, exit.atBegin + w.end) ||
    isBeaten(w, w.begin, exit.atEnd + (exit.length - w.begin)))
  {
    return true;
  }
  const double far = exit.beginIsFar ? w.begin : w.end;
  return isBeaten(w, far, exit.atThird + norm(Vec2{ far, 0.0 } - exit.third));
}

} // anonymous namespace

/// The front (paper, section 3.1, in the order of Qin et al. 2016): the queue holds vertices;
/// windows wait in sorted lists on sides, and a list goes through its face when the vertex opposite
/// is popped.
class Propagation
{
public:
  Propagation(const TriangleMesh& mesh, const SolveOptions& options);

  DistanceField run(const std::vector<SourceCurve>& sources);

private:
  struct Entry
  {
    double distance;
    Id vertex;
    // Vertices at equal distance come in the order of their ids.
    bool operator>(const Entry& other) const
    {
      return this->distance != other.distance ? this->distance > other.distance
                                              : this->vertex > other.vertex;
    }
  };

  void start(const std::vector<SourceCurve>& sources);
  void advance(double limit);
  void process(Id vertex);
  void relaxEdges(Id vertex);
  void emit(Id vertex);
  void enter(Id side);
  void merge(Id side);
  double errorAt(Id vertex) const;
  void passThrough(const WindowRange& list, const UnfoldedFace& face, std::size_t best,
    const Exit& left, const Exit& right);
  void passLeft(const Window& w, const UnfoldedFace& face, double end, const Exit& exit);
  void passRight(const Window& w, const UnfoldedFace& face, double begin, const Exit& exit);
  void leave(Id side, const std::vector<Window>& windows);
  void turn(const std::vector<Window>& windows, double length);
  void arrive(Id side, const WindowRange& windows);
  void mergeArriving(Id side, const WindowRange& windows);
  void improve(Id vertex, double distance, double error);
  void enqueue(Id vertex);
  void reportProgress(double front);

  void finishLimited();
  void flush(double bound);
  void markNeeded();
  double neededDistance() const;
  void dropIncomplete();
  void keep(Id side, const WindowRange& list);
  void sortKept();

  const TriangleMesh& Mesh;
  const SolveOptions& Options;
  DistanceField Field;

  std::vector<double>& Distance;
  /// How much longer the path behind a vertex's distance can be; empty in the exact solve.
  std::vector<double> VertexError;
  /// The distance with which a vertex was last processed, and the key it waits with in the queue.
  std::vector<double> Processed;
  std::vector<double> Queued;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> Queue;
  WaitingLists Waiting;
  /// Whether a vertex sends out windows when the front comes to it.
  std::vector<std::uint8_t> Emits;

  WindowListBuilder Left;
  WindowListBuilder Right;
  WindowListBuilder Merged;
  /// Scratch: windows turned to the orientation of another face, or being merged; where the windows
  /// of a list pass the apex.
  std::vector<Window> Turned;
  std::vector<Pass> Passes;

  std::vector<Window> Kept;
  std::vector<Id> KeptSides;
  /// With a limit: faces that have a point within it.
  std::vector<std::uint8_t> Needed;
  Id Settled = 0;
  Id SinceReport = 0;
};

Propagation::Propagation(const TriangleMesh& mesh, const SolveOptions& options)
  : Mesh(mesh)
  , Options(options)
  , Distance(Field.vertexDistances_)
  , Processed(mesh.numberOfVertices(), Infinity)
  , Queued(mesh.numberOfVertices(), Infinity)
  , Waiting(mesh.numberOfSides())
  , Emits(mesh.numberOfVertices(), 0)
{
  this->Field.mesh_ = &mesh;
  this->Distance.assign(mesh.numberOfVertices(), Infinity);
  if (options.relativeError > 0.0)
  {
    this->VertexError.assign(mesh.numberOfVertices(), 0.0);
  }
  if (options.maximumDistance < Infinity)
  {
    this->Needed.assign(mesh.numberOfFaces(), 0);
  }
}

DistanceField Propagation::run(const std::vector<SourceCurve>& sources)
{
  this->start(sources);
  this->advance(this->Options.maximumDistance);
  if (this->Options.maximumDistance < Infinity)
  {
    this->finishLimited();
  }
  if (this->Options.keepWindows == KeepWindows::All)
  {
    this->sortKept();
  }
  return std::move(this->Field);
}

void Propagation::start(const std::vector<SourceCurve>& sources)
{
  SourceWindows initial = makeSourceWindows(this->Mesh, sources);
  if (initial.inFaces.empty() && initial.vertices.empty())
  {
    throw SourceError("There is no source. Give at least one point on the surface.");
  }
  for (Id v = 0; v < this->Mesh.numberOfVertices(); ++v)
  {
    this->Emits[v] = this->Mesh.isPseudoSource(v) ? 1 : 0;
  }
  for (const Id vertex : initial.nearVertices)
  {
    this->Emits[vertex] = 1;
  }
  for (const Id vertex : initial.vertices)
  {
    this->Emits[vertex] = 0; // the curve's own wedges are there already
    this->improve(vertex, 0.0, 0.0);
  }
  for (const SourceInFace& source : initial.inFaces)
  {
    const Triangle& corners = this->Mesh.triangle(source.face);
    for (std::size_t k = 0; k < 3; ++k)
    {
      std::array<double, 3> corner{};
      corner[k] = 1.0;
      this->improve(corners[k], distanceToSource(this->Mesh, source, corner), 0.0);
    }
    if (!this->Needed.empty())
    {
      this->Needed[source.face] = 1;
    }
  }
  for (const LeavingWindow& leaving : initial.windows)
  {
    this->leave(leaving.side, { leaving.window });
  }
  this->Field.sourcesInFaces_ = std::move(initial.inFaces);
}

void Propagation::advance(double limit)
{
  while (!this->Queue.empty() && this->Queue.top().distance <= limit)
  {
    const Entry entry = this->Queue.top();
    this->Queue.pop();
    if (entry.distance == this->Queued[entry.vertex])
    {
      this->Queued[entry.vertex] = Infinity;
      this->process(entry.vertex);
      this->reportProgress(entry.distance);
    }
  }
}

void Propagation::process(Id vertex)
{
  const double distance = this->Distance[vertex];
  if (distance < this->Processed[vertex] * (1.0 - tolerance::Tie))
  {
    this->Settled += this->Processed[vertex] == Infinity ? 1 : 0;
    this->Processed[vertex] = distance;
    this->relaxEdges(vertex);
    if (this->Emits[vertex])
    {
      this->emit(vertex);
    }
  }
  for (const Id corner : this->Mesh.cornersAt(vertex))
  {
    const Id side = TriangleMesh::nextInFace(corner);
    if (this->Waiting.has(side))
    {
      this->enter(side);
    }
  }
}

// Distances along edges are upper bounds, which the filter can use from the first window on.
void Propagation::relaxEdges(Id vertex)
{
  const double distance = this->Distance[vertex];
  const double error = this->errorAt(vertex);
  for (const Id corner : this->Mesh.cornersAt(vertex))
  {
    const Id before = TriangleMesh::previousInFace(corner);
    this->improve(this->Mesh.destination(corner), distance + this->Mesh.length(corner), error);
    this->improve(this->Mesh.origin(before), distance + this->Mesh.length(before), error);
  }
}

void Propagation::emit(Id vertex)
{
  const double distance = this->Distance[vertex];
  for (const Id corner : this->Mesh.cornersAt(vertex))
  {
    const Id side = TriangleMesh::nextInFace(corner);
    const double length = this->Mesh.length(side);
    if (this->Mesh.isBoundary(side) || length == 0.0)
    {
      continue;
    }
    LeavingWindow leaving = vertexWindow(this->Mesh, corner, distance);
    leaving.window.error = this->errorAt(vertex);
    const Window& w = leaving.window;
    const bool useless =
      isBeaten(w, w.end, this->Distance[this->Mesh.destination(side)] + length) ||
      isBeaten(w, w.begin, this->Distance[this->Mesh.origin(side)] + length);
    if (!useless)
    {
      this->leave(side, { w });
    }
  }
}

void Propagation::enter(Id side)
{
  this->merge(side);
  const WindowRange list = this->Waiting.at(side);
  this->keep(side, list);
  const UnfoldedFace face = unfold(this->Mesh, side);
  const Id origin = this->Mesh.origin(side);
  const Id destination = this->Mesh.destination(side);
  const Id apex = this->Mesh.opposite(side);

  const ApexView view = viewApex(list, face.apex, this->Passes);
  const Window& first = *list.begin();
  const Window& last = *(list.end() - 1);
  this->improve(apex, view.distance, view.error);
  this->improve(origin, first.distance(first.begin) + first.begin, first.error);
  this->improve(destination, last.distance(last.end) + (face.length - last.end), last.error);

  const double atOrigin = this->Distance[origin];
  const double atDestination = this->Distance[destination];
  const double atApex = this->Distance[apex];
  const Vec2 fromOrigin = { face.length * face.leftAxis.x, -face.length * face.leftAxis.y };
  const Vec2 fromApex = { -dot(face.apex, face.rightAxis), cross(face.apex, face.rightAxis) };
  const Exit left = { TriangleMesh::previousInFace(side), face.leftLength, atOrigin, atApex,
    fromOrigin, atDestination, true };
  const Exit right = { TriangleMesh::nextInFace(side), face.rightLength, atApex, atDestination,
    fromApex, atOrigin, false };
  this->Left.reset(face.leftLength);
  this->Right.reset(face.rightLength);
  this->passThrough(list, face, view.best, left, right);
  this->Waiting.clear(side);
  this->leave(left.side, this->Left.windows());
  this->leave(right.side, this->Right.windows());
}

// Of the windows that hold the apex only the one that reaches it first goes to both sides: rays of
// the others that would cross its ray to the apex are beaten there (Qin et al. 2016).
void Propagation::passThrough(const WindowRange& list, const UnfoldedFace& face, std::size_t best,
  const Exit& left, const Exit& right)
{
  const bool toLeft = !this->Mesh.isBoundary(left.side);
  const bool toRight = !this->Mesh.isBoundary(right.side);
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    const Window& w = list.first[i];
    if (!(w.sourceDepth > 0.0) || w.depth >= this->Mesh.numberOfFaces())
    {
      continue; // rays along the edge, which its vertices stand for; or no shortest path
    }
    const Pass pass = this->Passes[i];
    if (toLeft && (pass == Pass::Left || (pass == Pass::Both && i <= best)))
    {
      this->passLeft(w, face, pass == Pass::Left ? face.meetLeft(w, w.end) : face.leftLength, left);
    }
    if (toRight && (pass == Pass::Right || (pass == Pass::Both && i >= best)))
    {
      this->passRight(w, face, pass == Pass::Right ? face.meetRight(w, w.begin) : 0.0, right);
    }
  }
}

void Propagation::passLeft(const Window& w, const UnfoldedFace& face, double end, const Exit& exit)
{
  const double begin = face.meetLeft(w, w.begin);
  if (end - begin > 0.0)
  {
    const Window child = face.throughLeft(w, begin, end);
    if (!isUseless(child, exit))
    {
      this->Left.append(child);
    }
  }
}

void Propagation::passRight(
  const Window& w, const UnfoldedFace& face, double begin, const Exit& exit)
{
  const double end = face.meetRight(w, w.end);
  if (end - begin > 0.0)
  {
    const Window child = face.throughRight(w, begin, end);
    if (!isUseless(child, exit))
    {
      this->Right.append(child);
    }
  }
}

// Hands windows, in the leaving frame of the side, to every other face around its edge.
void Propagation::leave(Id side, const std::vector<Window>& windows)
{
  if (windows.empty())
  {
    return;
  }
  for (Id s = this->Mesh.nextInRing(side); s != side; s = this->Mesh.nextInRing(s))
  {
    if (this->Mesh.origin(s) == this->Mesh.destination(side))
    {
      this->arrive(s, { windows.data(), windows.data() + windows.size() });
    }
    else
    {
      this->turn(windows, this->Mesh.length(side));
      this->arrive(s, { this->Turned.data(), this->Turned.data() + this->Turned.size() });
    }
  }
}

// Faces of opposite orientation run along their common edge in the same direction.
void Propagation::turn(const std::vector<Window>& windows, double length)
{
  this->Turned.clear();
  for (auto w = windows.rbegin(); w != windows.rend(); ++w)
  {
    this->Turned.push_back(reversed(*w, length));
  }
}

void Propagation::arrive(Id side, const WindowRange& windows)
{
  this->Field.windowsPropagated_ += windows.size();
  const UnfoldedFace face = unfold(this->Mesh, side);
  const Id apex = this->Mesh.opposite(side);
  const ApexView view = viewApex(windows, face.apex, this->Passes);
  this->improve(apex, view.distance, view.error);
  this->mergeArriving(side, windows);
  this->enqueue(apex);
}

void Propagation::mergeArriving(Id side, const WindowRange& windows)
{
  const WindowRange waiting = this->Waiting.at(side);
  if (waiting.size() == 0)
  {
    this->Waiting.assign(side, windows);
    return;
  }
  this->Merged.reset(this->Mesh.length(side));
  const Window* old = waiting.begin();
  for (const Window& w : windows)
  {
    for (; old != waiting.end() && old->begin <= w.begin; ++old)
    {
      this->Merged.append(*old);
    }
    this->Merged.append(w);
  }
  for (; old != waiting.end(); ++old)
  {
    this->Merged.append(*old);
  }
  this->Waiting.assign(side, this->Merged.range());
}

// A list is merged when it is complete and about to go on, so that each window is once a face.
void Propagation::merge(Id side)
{
  if (!(this->Options.relativeError > 0.0) || this->Waiting.at(side).size() < 2)
  {
    return;
  }
  const WindowRange list = this->Waiting.at(side);
  std::vector<Window>& merged = this->Turned;
  merged.assign(list.begin(), list.end());
  const double error =
    mergeNeighbours(merged, this->Mesh.length(side), this->Options.relativeError);
  this->Field.relativeErrorBound_ = std::max(this->Field.relativeErrorBound_, error);
  this->Waiting.assign(side, { merged.data(), merged.data() + merged.size() });
}

double Propagation::errorAt(Id vertex) const
{
  return this->VertexError.empty() ? 0.0 : this->VertexError[vertex];
}

void Propagation::improve(Id vertex, double distance, double error)
{
  distance = std::max(distance, 0.0); // a linear window's may be a rounding below at its source
  if (!(distance < this->Distance[vertex]))
  {
    return;
  }
  this->Distance[vertex] = distance;
  if (!this->VertexError.empty())
  {
    this->VertexError[vertex] = error;
  }
  if (distance < this->Processed[vertex] * (1.0 - tolerance::Tie))
  {
    this->enqueue(vertex);
  }
}

void Propagation::enqueue(Id vertex)
{
  const double distance = this->Distance[vertex];
  if (distance < this->Queued[vertex])
  {
    this->Queued[vertex] = distance;
    this->Queue.push({ distance, vertex });
  }
}

void Propagation::reportProgress(double front)
{
  constexpr Id verticesPerReport = 256;
  if (!this->Options.progress || ++this->SinceReport < verticesPerReport)
  {
    return;
  }
  this->SinceReport = 0;
  const double settled =
    static_cast<double>(this->Settled) / static_cast<double>(this->Mesh.numberOfVertices());
  const double fraction = std::max(settled, front / this->Options.maximumDistance);
  if (!this->Options.progress(std::min(fraction, 1.0)))
  {
    throw Aborted();
  }
}

// A face with a point within the limit has exact values when no waiting window and no pseudo-source
// is nearer than the farthest of them.
void Propagation::finishLimited()
{
  this->flush(this->Options.maximumDistance);
  this->markNeeded();
  this->flush(this->neededDistance());
  for (const Id side : this->Waiting.sides())
  {
    this->keep(side, this->Waiting.at(side));
  }
  this->dropIncomplete();
}

// Sends on every window and pseudo-source nearer than the bound, also those that would wait for a
// far vertex.
void Propagation::flush(double bound)
{
  for (bool again = true; again;)
  {
    again = false;
    this->advance(bound);
    for (const Id side : this->Waiting.sides())
    {
      const WindowRange list = this->Waiting.at(side);
      const bool within = std::any_of(
        list.begin(), list.end(), [&](const Window& w) { return w.minimum() <= bound; });
      if (within)
      {
        this->enter(side);
        again = true;
      }
    }
  }
}

void Propagation::markNeeded()
{
  for (Id f = 0; f < this->Mesh.numberOfFaces(); ++f)
  {
    for (const Id v : this->Mesh.triangle(f))
    {
      if (this->Distance[v] <= this->Options.maximumDistance)
      {
        this->Needed[f] = 1;
      }
    }
  }
}

double Propagation::neededDistance() const
{
  double bound = 0.0;
  const bool inside = this->Options.keepWindows == KeepWindows::All;
  for (Id f = 0; f < this->Mesh.numberOfFaces(); ++f)
  {
    if (this->Needed[f])
    {
      const Triangle& t = this->Mesh.triangle(f);
      const std::array<double, 3>& length = this->Mesh.shape(f).length;
      const auto [least, most] =
        std::minmax({ this->Distance[t[0]], this->Distance[t[1]], this->Distance[t[2]] });
      const double reach = least + *std::max_element(length.begin(), length.end());
      bound = std::max(bound, inside ? reach : most);
    }
  }
  return bound;
}

void Propagation::dropIncomplete()
{
  std::vector<std::uint8_t> complete(this->Mesh.numberOfVertices(), 0);
  for (Id f = 0; f < this->Mesh.numberOfFaces(); ++f)
  {
    for (const Id v : this->Mesh.triangle(f))
    {
      complete[v] |= this->Needed[f];
    }
  }
  for (Id v = 0; v < this->Mesh.numberOfVertices(); ++v)
  {
    this->Distance[v] = complete[v] ? this->Distance[v] : Infinity;
  }
  this->Field.faceComplete_ = std::move(this->Needed);
}

void Propagation::keep(Id side, const WindowRange& list)
{
  if (!this->Needed.empty() && !this->Needed[TriangleMesh::faceOf(side)])
  {
    const bool within = std::any_of(list.begin(), list.end(),
      [&](const Window& w) { return w.minimum() <= this->Options.maximumDistance; });
    if (within)
    {
      for (Id s = side;;)
      {
        this->Needed[TriangleMesh::faceOf(s)] = 1;
        s = this->Mesh.nextInRing(s);
        if (s == side)
        {
          break;
        }
      }
    }
  }
  if (this->Options.keepWindows == KeepWindows::All)
  {
    this->Kept.insert(this->Kept.end(), list.begin(), list.end());
    this->KeptSides.insert(this->KeptSides.end(), list.size(), side);
  }
}

// Windows were kept in the order in which their sides were entered.
void Propagation::sortKept()
{
  std::vector<std::uint64_t>& start = this->Field.windowStart_;
  start.assign(static_cast<std::size_t>(this->Mesh.numberOfSides()) + 1, 0);
  for (const Id side : this->KeptSides)
  {
    ++start[side + 1];
  }
  for (std::size_t s = 1; s < start.size(); ++s)
  {
    start[s] += start[s - 1];
  }
  std::vector<std::uint64_t> next(start.begin(), start.end() - 1);
  this->Field.windows_.resize(this->Kept.size());
  for (std::size_t i = 0; i < this->Kept.size(); ++i)
  {
    this->Field.windows_[next[this->KeptSides[i]]++] = this->Kept[i];
  }
}

DistanceField solve(
  const TriangleMesh& mesh, const std::vector<SourceCurve>& sources, const SolveOptions& options)
{
  if (!(options.relativeError >= 0.0) || !(options.relativeError < Infinity))
  {
    throw Error("The relative error is " + std::to_string(options.relativeError) +
      "; give a number of at least 0.");
  }
  return Propagation(mesh, options).run(sources);
}

}
