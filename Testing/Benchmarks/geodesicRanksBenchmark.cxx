// SPDX-License-Identifier: BSD-3-Clause
// Measures the front on a surface that ranks have in pieces, and prints a JSON object a run: in one
// process, with what the ranks tell each other counted, or under mpirun, with the time and memory
// that they take.
#include "BenchmarkMesh.h"
#include "BenchmarkMeter.h"
#include "MemoryRanks.h"
#include "RankPieces.h"

#include "front/Front.h"
#include "mesh/ReplicatedPatch.h"
#include "source/BoundaryCurves.h"
#include "source/SourceWindows.h"

#include "vtkDijkstraGraphGeodesicPath.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#ifdef GEODESIC_HAS_MPI
#include "PolyData/ranks/RankExchange.h"

#include "vtkMPIController.h"
#endif

#include <algorithm>
#include <chrono>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

namespace
{

using namespace geodesic;

const char* const Usage =
  R"(Measures the front on a surface in pieces and prints a JSON object a run.

  --mesh FILE               the surface: obj, ply, stl or vtp
  --subdivide LEVELS        refine it by Loop subdivision first
  --noise FRACTION          and move its vertices at random, by a fraction of the mean edge length
  --source vertex:ID        measure from a vertex (the default: vertex:0)
           boundary         from the boundary
           path:ID,ID       from the polyline along mesh edges between two vertices
  --pieces N                cut it into so many pieces along a space-filling curve, a rank each
  --write PREFIX            and write them, in place of measuring in this process
  --read PREFIX             under mpirun: read this rank's piece, and measure
  --relative-error E        the largest relative error; 0, exact, is the default
  --repeat R                so many runs
)";

struct Options
{
  std::map<std::string, std::string> values = { { "--source", "vertex:0" }, { "--pieces", "1" },
    { "--subdivide", "0" }, { "--noise", "0" }, { "--relative-error", "0" }, { "--repeat", "1" },
    { "--mesh", "" }, { "--write", "" }, { "--read", "" } };

  const std::string& operator[](const std::string& name) const { return this->values.at(name); }
  double number(const std::string& name) const
  {
    std::istringstream stream((*this)[name]);
    double value = 0.0;
    if (!(stream >> value) || !stream.eof() || !(value >= 0.0))
    {
      throw std::runtime_error(name + " takes a number, not " + (*this)[name]);
    }
    return value;
  }
  int count(const std::string& name) const { return static_cast<int>(this->number(name)); }
};

Options parse(const std::vector<std::string>& arguments)
{
  Options options;
  for (std::size_t i = 0; i < arguments.size(); i += 2)
  {
    const auto known = options.values.find(arguments[i]);
    if (known == options.values.end() || i + 1 == arguments.size())
    {
      throw std::runtime_error(arguments[i] + " is no option, or has no value; see --help");
    }
    known->second = arguments[i + 1];
  }
  return options;
}

RankSource makeSource(const std::string& text, vtkPolyData* mesh)
{
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  std::istringstream value(colon == std::string::npos ? "" : text.substr(colon + 1));
  RankSource source;
  source.isBoundary = kind == "boundary";
  std::uint64_t from = 0;
  std::uint64_t to = 0;
  char comma = ' ';
  if (kind == "vertex" && value >> from)
  {
    source.points = { from };
  }
  else if (kind == "path" && value >> from >> comma >> to)
  {
    vtkNew<vtkDijkstraGraphGeodesicPath> path;
    path->SetInputData(mesh);
    path->SetStartVertex(static_cast<vtkIdType>(from));
    path->SetEndVertex(static_cast<vtkIdType>(to));
    path->StopWhenEndReachedOn();
    path->Update();
    vtkIdList* ids = path->GetIdList();
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      source.points.push_back(static_cast<std::uint64_t>(ids->GetId(i)));
    }
  }
  else if (!source.isBoundary)
  {
    throw std::runtime_error("--source takes vertex:ID, boundary or path:ID,ID, not " + text);
  }
  return source;
}

/// Which of the source's points each of the piece's is.
std::unordered_map<std::uint64_t, std::size_t> placesIn(const RankSource& source)
{
  std::unordered_map<std::uint64_t, std::size_t> places;
  for (std::size_t i = 0; i < source.points.size(); ++i)
  {
    places[source.points[i]] = i;
  }
  return places;
}

/// The faces that are owned here and touch the source.
std::vector<Id> facesAt(const MeshPartition& part, const RankPiece& piece, const RankSource& source)
{
  const auto places = placesIn(source);
  const TriangleMesh& mesh = part.mesh();
  std::vector<Id> faces;
  for (Id face = part.firstOwnFace(); face < part.endOfOwnFaces(); ++face)
  {
    bool touches = false;
    for (Id k = 0; k < 3; ++k)
    {
      const Id vertex = mesh.triangle(face)[k];
      touches = touches || (source.isBoundary && mesh.isBoundary(3 * face + k)) ||
        places.count(piece.keys[vertex]) > 0;
    }
    if (touches)
    {
      faces.push_back(face);
    }
  }
  return faces;
}

/// The boundary of the whole surface on a patch that has its faces, the same on all ranks.
std::vector<SourceCurve> boundaryOn(const MeshPartition& part, const ReplicatedPatch& patch)
{
  std::vector<RankAddress> own; // halfedges
  for (Id face = part.firstOwnFace(); face < part.endOfOwnFaces(); ++face)
  {
    for (const Id halfedge : TriangleMesh::halfedgesOf(face))
    {
      if (part.mesh().isBoundary(halfedge))
      {
        own.push_back({ part.exchange().rank(), halfedge });
      }
    }
  }
  std::vector<Id> ends;
  std::vector<Id> faces;
  for (const RankAddress& found : valuesOfRanks(part.exchange(), own))
  {
    const Id face = patch.faceAt({ found.rank, TriangleMesh::faceOf(found.id) });
    const Id halfedge = TriangleMesh::inCopy(found.id, face);
    ends.insert(ends.end(), { patch.mesh().origin(halfedge), patch.mesh().destination(halfedge) });
    faces.push_back(face);
  }
  return curvesAlong(ends, faces);
}

/// The source on a patch, the same on all ranks.
std::vector<SourceCurve> curvesOn(const MeshPartition& part, const ReplicatedPatch& patch,
  const RankPiece& piece, const RankSource& source)
{
  const TriangleMesh& mesh = patch.mesh();
  if (source.isBoundary)
  {
    return boundaryOn(part, patch);
  }
  const auto places = placesIn(source);
  Message message;
  for (Id vertex = 0; vertex < part.numberOfOwnVertices(); ++vertex)
  {
    const auto place = places.find(piece.keys[vertex]);
    if (place != places.end())
    {
      put(message, place->second);
      put(message, part.globalId(vertex));
    }
  }
  std::unordered_map<geodesic::GlobalId, std::size_t> placeOfNumber;
  readEach(part.exchange().tellAll(message),
    [&](int, MessageReader& reader)
    {
      const auto place = reader.get<std::size_t>();
      placeOfNumber[reader.get<geodesic::GlobalId>()] = place;
    });
  SourceCurve curve;
  curve.points.resize(source.points.size());
  for (Id vertex = 0; vertex < mesh.numberOfVertices(); ++vertex)
  {
    const auto place = placeOfNumber.find(patch.globalId(vertex));
    if (place != placeOfNumber.end())
    {
      curve.points[place->second] = SurfacePoint::atVertex(vertex);
    }
  }
  for (std::size_t i = 1; i < curve.points.size(); ++i)
  {
    curve.faces.push_back(commonFace(mesh, curve.points[i - 1], curve.points[i]));
  }
  curve.isCut.assign(curve.points.size(), 0);
  return { curve };
}

/// What a run took on one rank.
struct RankRun
{
  double buildSeconds = 0.0;
  double solveSeconds = 0.0;
  Id faces = 0;
  Id haloFaces = 0;
  Id globalFaces = 0;
  std::uint64_t windows = 0;
  double maximumDistance = 0.0;
};

/// \param beforeFront called when the front begins.
template <typename BeforeFront>
RankRun measureRank(Exchange& exchange, const RankPiece& piece, const RankSource& source,
  double relativeError, const BeforeFront& beforeFront)
{
  RankRun run;
  Stopwatch watch;
  const MeshPartition part(piece.points, piece.triangles, piece.keys, exchange);
  const ReplicatedPatch patch(part, facesAt(part, piece, source));
  const SourceWindows windows =
    makeSourceWindows(part, patch, curvesOn(part, patch, piece, source));
  run.buildSeconds = watch.lap();
  beforeFront();
  FrontOptions options;
  options.relativeError = relativeError;
  KeepNone none;
  const FrontResult result = propagate(part, windows, options, none);
  run.solveSeconds = watch.lap();
  run.faces = part.endOfOwnFaces() - part.firstOwnFace();
  run.haloFaces = part.mesh().numberOfFaces() - run.faces;
  run.globalFaces = part.numberOfGlobalFaces();
  run.windows = result.windowsPropagated;
  for (Id vertex = 0; vertex < part.numberOfOwnVertices(); ++vertex)
  {
    const double distance = result.vertexDistances[vertex];
    run.maximumDistance =
      distance < Infinity ? std::max(run.maximumDistance, distance) : run.maximumDistance;
  }
  run.maximumDistance = exchange.largestOf(run.maximumDistance);
  return run;
}

/// All ranks in this process, a thread each.
void measureInMemory(
  const std::vector<RankPiece>& pieces, const RankSource& source, double relativeError)
{
  geodesictest::MemoryRanks ranks(static_cast<int>(pieces.size()));
  std::vector<RankRun> runs(pieces.size());
  geodesictest::ExchangeCounts before;
  ranks.run(
    [&](Exchange& exchange)
    {
      const auto rank = static_cast<std::size_t>(exchange.rank());
      runs[rank] = measureRank(exchange, pieces[rank], source, relativeError,
        [&]
        {
          exchange.isTrueAnywhere(false);
          if (rank == 0)
          {
            before = ranks.counts();
          }
        });
    });
  const geodesictest::ExchangeCounts& after = ranks.counts();
  RankRun most;
  for (const RankRun& run : runs)
  {
    most.faces = std::max(most.faces, run.faces);
    most.haloFaces = std::max(most.haloFaces, run.haloFaces);
  }
  std::cout << "{\"ranks\": " << pieces.size() << ", \"faces\": " << runs[0].globalFaces
            << ", \"largest_part\": " << most.faces << ", \"largest_halo\": " << most.haloFaces
            << ", \"relative_error\": " << relativeError
            << ", \"windows_propagated\": " << runs[0].windows
            << ", \"max_distance\": " << runs[0].maximumDistance
            << ", \"steps\": " << after.steps - before.steps
            << ", \"messages\": " << after.messages - before.messages
            << ", \"bytes\": " << after.bytes - before.bytes
            << ", \"busiest_bytes\": " << after.busiestBytes - before.busiestBytes
            << ", \"work_s\": " << after.work - before.work
            << ", \"busiest_s\": " << after.busiest - before.busiest << "}" << std::endl;
}

void measureMesh(const Options& options)
{
  vtkSmartPointer<vtkPolyData> mesh = plainTriangles(readMesh(options["--mesh"]));
  mesh = options.count("--subdivide") > 0 ? subdivide(mesh, options.count("--subdivide")) : mesh;
  mesh = options.number("--noise") > 0.0 ? addNoise(mesh, options.number("--noise")) : mesh;
  const RankSource source = makeSource(options["--source"], mesh);
  const std::vector<RankPiece> pieces = cutIntoPieces(mesh, std::max(1, options.count("--pieces")));
  for (std::size_t i = 0; i < pieces.size() && !options["--write"].empty(); ++i)
  {
    writePiece(options["--write"], static_cast<int>(i), pieces[i], source);
  }
  for (int i = 0; i < options.count("--repeat") && options["--write"].empty(); ++i)
  {
    measureInMemory(pieces, source, options.number("--relative-error"));
  }
}

#ifdef GEODESIC_HAS_MPI
/// What the ranks tell rank 0 of a run.
struct RunOfRank
{
  RankRun run;
  std::uint64_t loaded;
  std::uint64_t peak;
  vtkTypeInt64 steps;
  vtkTypeInt64 bytes;
  double secondsInSteps;
};

void printRuns(const std::vector<RunOfRank>& runs, double relativeError)
{
  std::uint64_t largest = 0;
  double most = 0.0;
  double least = Infinity;
  vtkTypeInt64 bytes = 0;
  double solve = 0.0;
  double build = 0.0;
  for (const RunOfRank& own : runs)
  {
    largest = std::max(largest, own.peak > own.loaded ? own.peak - own.loaded : 0);
    most = std::max(most, own.secondsInSteps);
    least = std::min(least, own.secondsInSteps);
    bytes += own.bytes;
    solve = std::max(solve, own.run.solveSeconds);
    build = std::max(build, own.run.buildSeconds);
  }
  std::cout << "{\"ranks\": " << runs.size() << ", \"faces\": " << runs[0].run.globalFaces
            << ", \"relative_error\": " << relativeError << ", \"build_s\": " << build
            << ", \"solve_s\": " << solve << ", \"most_in_steps_s\": " << most
            << ", \"least_in_steps_s\": " << least << ", \"steps\": " << runs[0].steps
            << ", \"bytes\": " << bytes << ", \"largest_bytes\": " << largest
            << ", \"bytes_per_face\": "
            << static_cast<double>(largest) / static_cast<double>(runs[0].run.globalFaces)
            << ", \"windows_propagated\": " << runs[0].run.windows
            << ", \"max_distance\": " << runs[0].run.maximumDistance << "}" << std::endl;
}

/// Counts and times the steps of an exchange.
class MeasuredExchange : public Exchange
{
public:
  explicit MeasuredExchange(Exchange& exchange)
    : exchange_(exchange)
  {
  }
  int rank() const override { return this->exchange_.rank(); }
  int numberOfRanks() const override { return this->exchange_.numberOfRanks(); }
  std::string fail(const std::string& why) override { return this->exchange_.fail(why); }
  using Exchange::step;
  std::vector<Message> step(std::vector<Message> messages, std::vector<double>& least) override
  {
    ++this->steps;
    for (std::size_t i = 0; i < messages.size(); ++i)
    {
      const bool isToOther = i != rankIndex(this->rank());
      this->bytes += isToOther ? static_cast<vtkTypeInt64>(messages[i].size()) : 0;
    }
    const auto begin = std::chrono::steady_clock::now();
    std::vector<Message> received = this->exchange_.step(std::move(messages), least);
    this->seconds +=
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return received;
  }

  vtkTypeInt64 steps = 0;
  /// Sent by this rank to others.
  vtkTypeInt64 bytes = 0;
  /// In steps, with waiting for other ranks.
  double seconds = 0.0;

private:
  Exchange& exchange_;
};

/// One process of mpirun.
void measureUnderMpi(const Options& options, vtkMPIController* controller)
{
  RankPiece piece;
  RankSource source;
  readPiece(options["--read"], controller->GetLocalProcessId(), piece, source);
  for (int i = 0; i < options.count("--repeat"); ++i)
  {
    controller->Barrier();
    forgetPeakMemory();
    RunOfRank own = { {}, memory("VmRSS"), 0, 0, 0, 0.0 };
    if (controller->GetNumberOfProcesses() == 1)
    {
      geodesictest::MemoryRanks alone(1);
      alone.run(
        [&](Exchange& exchange) {
          own.run = measureRank(exchange, piece, source, options.number("--relative-error"), [] {});
        });
      own.peak = memory("VmHWM");
      printRuns({ own }, options.number("--relative-error"));
      continue;
    }
    RankExchange ofProcesses(controller);
    MeasuredExchange exchange(ofProcesses);
    own.run = measureRank(exchange, piece, source, options.number("--relative-error"),
      [&]
      {
        exchange.steps = 0;
        exchange.bytes = 0;
        exchange.seconds = 0.0;
      });
    own.peak = memory("VmHWM");
    own.steps = exchange.steps;
    own.bytes = exchange.bytes;
    own.secondsInSteps = exchange.seconds;
    const std::vector<RunOfRank> runs = valuesOfRanks(exchange, own);
    if (exchange.rank() == 0)
    {
      printRuns(runs, options.number("--relative-error"));
    }
  }
}
#endif

}

int main(int argc, char* argv[])
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.empty() || arguments[0] == "--help")
  {
    std::cout << Usage;
    return arguments.empty() ? 1 : 0;
  }
  try
  {
    const Options options = parse(arguments);
    if (options["--read"].empty())
    {
      measureMesh(options);
      return 0;
    }
#ifdef GEODESIC_HAS_MPI
    vtkNew<vtkMPIController> controller;
    controller->Initialize(&argc, &argv);
    measureUnderMpi(options, controller);
    controller->Finalize();
#else
    throw std::runtime_error("--read needs a VTK with MPI");
#endif
  }
  catch (const std::exception& error)
  {
    std::cerr << "geodesicRanksBenchmark: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
