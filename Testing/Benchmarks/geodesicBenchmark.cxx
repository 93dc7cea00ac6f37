// SPDX-License-Identifier: BSD-3-Clause
// Measures the engine on a mesh and prints a JSON object a run.
#include "BenchmarkFilter.h"
#include "BenchmarkMesh.h"
#include "BenchmarkMeter.h"
#include "BenchmarkPeers.h"
#include "BenchmarkQueries.h"
#include "BenchmarkTasks.h"
#include "EdgesOfMesh.h"

#include "PolyData/reading/SourceParts.h"
#include "PolyData/reading/SurfaceReader.h"
#include "ThreadTeam.h"
#include "field/DistanceField.h"
#include "field/SegmentEnvelope.h"
#include "paths/JoinPoints.h"
#include "refinement/AdaptiveRefinement.h"
#include "refinement/SolveForRefinement.h"
#include "source/PolylineLocator.h"

#include "vtkDijkstraGraphGeodesicPath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSMPTools.h"

#include <iostream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

const char* const Usage = R"(Measures geodesic distance fields and prints a JSON object a run.

  --mesh FILE               the surface: obj, ply, stl or vtp
  --subdivide LEVELS        refine it by Loop subdivision first
  --noise FRACTION          and move its vertices at random, by a fraction of the mean edge length
  --write FILE              and write it: obj, ply, stl or vtp
  --source vertex:ID        measure from a vertex (the default: vertex:0)
           boundary         from the boundary
           curve:FILE       from the curves and points of a file
           path:ID,ID       from the polyline along mesh edges between two vertices
  --relative-error E        the largest relative error; 0, exact, is the default
  --refine T                refine until the interpolant is within this fraction of the diagonal;
                            output_cells are the faces made
  --envelope                count the windows of the final lower envelope, too, and divide those
                            propagated by them
  --threads N               threads that VTK may use
  --model N,N,...           and what that many threads would give, from the times of the tasks of a
                            solve on one thread; and the share of what is outside of tasks
  --repeat R                so many runs; 0 with --write: none
  --update                  and the whole filter's Update(), which refines where --refine is given,
                            and one that reaches nothing: the mesh structure and the output
  --arrays                  and the filter's Update() without and with all arrays that it can make
  --paths N                 and shortest paths from N random targets
  --contour N               and isolines of N distances at equal steps; where --refine is given with
                            that tolerance of chords, and beside it by vtkContourFilter
  --matrix NxM              and the distances of N random sources and M random targets
  --reach FRACTION          take targets (and sources of a matrix: any two of them) within this
                            fraction of the largest distance; the farthest is among them
  --error                   and the largest relative error at points, against the exact field: of
                            the run, and of the peers where the source is a vertex
  --against PEER,PEER...    and measure on the same mesh, from the vertex or else from vertex 0: )";

struct Options
{
  std::string mesh;
  int subdivide = 0;
  double noise = 0.0;
  std::string write;
  std::string source = "vertex:0";
  double relativeError = 0.0;
  /// 0: none.
  double refine = 0.0;
  bool envelope = false;
  bool update = false;
  bool error = false;
  bool arrays = false;
  /// 0: none, as for the next ones.
  int paths = 0;
  int contour = 0;
  int matrixSources = 0;
  int matrixTargets = 0;
  double reach = 1.0;
  int threads = 0;
  std::vector<int> model;
  int repeat = 1;
  std::vector<std::string> against;
};

/// \throws std::runtime_error
double toNumber(const std::string& option, const std::string& text, double least)
{
  std::istringstream stream(text);
  double value = 0.0;
  if (!(stream >> value) || !stream.eof() || !(value >= least))
  {
    throw std::runtime_error(option + " takes a number, not " + text);
  }
  return value;
}

std::vector<std::string> split(const std::string& text)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');)
  {
    parts.push_back(part);
  }
  return parts;
}

/// Sets an option that has no value; returns false where it is none.
bool setFlag(Options& options, const std::string& name)
{
  options.envelope |= name == "--envelope";
  options.update |= name == "--update";
  options.error |= name == "--error";
  options.arrays |= name == "--arrays";
  return name == "--envelope" || name == "--update" || name == "--error" || name == "--arrays";
}

/// Sets an option of what is asked of a field; returns false where it is none.
bool setQuery(Options& options, const std::string& name, const std::string& value)
{
  if (name == "--paths")
  {
    options.paths = static_cast<int>(toNumber(name, value, 1));
  }
  else if (name == "--contour")
  {
    options.contour = static_cast<int>(toNumber(name, value, 1));
  }
  else if (name == "--matrix")
  {
    const std::size_t times = value.find('x');
    if (times == std::string::npos)
    {
      throw std::runtime_error("--matrix takes SOURCESxTARGETS, such as 100x100, not " + value);
    }
    options.matrixSources = static_cast<int>(toNumber(name, value.substr(0, times), 1));
    options.matrixTargets = static_cast<int>(toNumber(name, value.substr(times + 1), 1));
  }
  else if (name == "--reach")
  {
    options.reach = toNumber(name, value, 0);
  }
  else
  {
    return false;
  }
  return true;
}

void setOption(Options& options, const std::string& name, const std::string& value)
{
  if (name == "--mesh")
  {
    options.mesh = value;
  }
  else if (name == "--subdivide")
  {
    options.subdivide = static_cast<int>(toNumber(name, value, 0));
  }
  else if (name == "--noise")
  {
    options.noise = toNumber(name, value, 0);
  }
  else if (name == "--write")
  {
    options.write = value;
  }
  else if (name == "--source")
  {
    options.source = value;
  }
  else if (name == "--relative-error")
  {
    options.relativeError = toNumber(name, value, 0);
  }
  else if (name == "--refine")
  {
    options.refine = toNumber(name, value, 0);
  }
  else if (name == "--threads")
  {
    options.threads = static_cast<int>(toNumber(name, value, 1));
  }
  else if (name == "--model")
  {
    for (const std::string& number : split(value))
    {
      options.model.push_back(static_cast<int>(toNumber(name, number, 1)));
    }
  }
  else if (name == "--repeat")
  {
    options.repeat = static_cast<int>(toNumber(name, value, 0));
  }
  else if (name == "--against")
  {
    options.against = split(value);
  }
  else if (!setQuery(options, name, value))
  {
    throw std::runtime_error("unknown option " + name);
  }
}

Options parse(const std::vector<std::string>& arguments)
{
  Options options;
  for (std::size_t i = 0; i < arguments.size(); ++i)
  {
    if (setFlag(options, arguments[i]))
    {
      continue;
    }
    if (i + 1 == arguments.size())
    {
      throw std::runtime_error(arguments[i] + " needs a value");
    }
    setOption(options, arguments[i], arguments[i + 1]);
    ++i;
  }
  if (options.mesh.empty())
  {
    throw std::runtime_error("--mesh is missing");
  }
  for (const std::string& peer : options.against)
  {
    if (!isPeer(peer))
    {
      throw std::runtime_error("--against " + peer + ": built in are " + peerNames());
    }
  }
  return options;
}

/// What the option --source says.
struct Source
{
  bool boundary = false;
  /// Curves and points; none for the boundary.
  vtkSmartPointer<vtkPolyData> curves;
  /// Where peers, which know no curves, measure from.
  vtkIdType vertex = 0;
  /// Whether that vertex is the source.
  bool isVertex = false;
};

vtkIdType vertexId(const std::string& text, vtkPolyData* mesh)
{
  const auto id = static_cast<vtkIdType>(toNumber("--source", text, 0));
  if (id >= mesh->GetNumberOfPoints())
  {
    throw std::runtime_error(
      "--source: the mesh has only " + std::to_string(mesh->GetNumberOfPoints()) + " points");
  }
  return id;
}

vtkSmartPointer<vtkPolyData> pathAlongEdges(vtkPolyData* mesh, vtkIdType from, vtkIdType to)
{
  vtkNew<vtkDijkstraGraphGeodesicPath> path;
  path->SetInputData(mesh);
  path->SetStartVertex(from);
  path->SetEndVertex(to);
  path->StopWhenEndReachedOn();
  path->Update();
  return path->GetOutput();
}

Source makeSource(const std::string& text, vtkPolyData* mesh)
{
  const std::size_t colon = text.find(':');
  const std::string kind = text.substr(0, colon);
  const std::string value = colon == std::string::npos ? "" : text.substr(colon + 1);
  Source source;
  if (kind == "vertex")
  {
    source.vertex = vertexId(value, mesh);
    source.isVertex = true;
    vtkNew<vtkPoints> points;
    points->SetDataType(mesh->GetPoints()->GetDataType());
    points->InsertNextPoint(mesh->GetPoint(source.vertex));
    source.curves = vtkSmartPointer<vtkPolyData>::New();
    source.curves->SetPoints(points);
  }
  else if (kind == "boundary")
  {
    source.boundary = true;
  }
  else if (kind == "curve")
  {
    source.curves = readMesh(value);
  }
  else if (kind == "path" && split(value).size() == 2)
  {
    source.curves =
      pathAlongEdges(mesh, vertexId(split(value)[0], mesh), vertexId(split(value)[1], mesh));
  }
  else
  {
    throw std::runtime_error(
      "--source takes vertex:ID, boundary, curve:FILE or path:ID,ID, not " + text);
  }
  return source;
}

std::string quoted(const std::string& text)
{
  std::string result = "\"";
  for (const char c : text)
  {
    result += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  }
  return result + '"';
}

double largestFinite(const std::vector<double>& distances)
{
  double largest = 0.0;
  for (const double distance : distances)
  {
    largest = std::isfinite(distance) ? std::max(largest, distance) : largest;
  }
  return largest;
}

std::vector<geodesic::SourceCurve> makeCurves(
  const Source& source, const geodesic::PolyDataSurface& surface)
{
  if (source.boundary)
  {
    return geodesictest::boundaryCurves(surface.mesh());
  }
  const std::vector<geodesic::PolyDataBlock> blocks =
    geodesic::polyDataBlocks(source.curves, geodesic::PartName("the source"));
  geodesic::PolylineLocator locator(surface.partition);
  geodesic::SourceCells read = geodesic::readParts({ blocks, nullptr, true, surface, locator }, {});
  read.located.setFaces(geodesic::ReplicatedPatch(surface.mesh()), read.polylines);
  return geodesic::putOntoSurface(
    surface.mesh(), read.polylines, read.precision, geodesic::joinByShortestPaths(surface.mesh()))
    .curves;
}

/// Pieces of the lower envelope over all edges, divided by the edges.
double windowsPerEdge(const geodesic::DistanceField& field)
{
  const geodesic::TriangleMesh& mesh = field.mesh();
  geodesic::SegmentEnvelope envelope;
  std::size_t pieces = 0;
  for (geodesic::Id side = 0; side < mesh.numberOfHalfedges(); ++side)
  {
    const geodesic::Id face = geodesic::TriangleMesh::faceOf(side);
    const auto& distances = field.vertexDistances();
    const geodesic::Triangle& corners = mesh.triangle(face);
    const bool reached =
      std::isfinite(distances[corners[0]] + distances[corners[1]] + distances[corners[2]]);
    if (reached && mesh.edgeOf(side) == side)
    {
      std::array<double, 3> begin{};
      std::array<double, 3> end{};
      begin[side % 3] = 1.0;
      end[(side + 1 - 3 * face) % 3] = 1.0;
      const geodesic::FaceDistance distance(field, face);
      pieces += envelope.along(distance, distance.inPlane(begin), distance.inPlane(end)).size();
    }
  }
  return static_cast<double>(pieces) / static_cast<double>(geodesictest::numberOfEdges(mesh));
}

/// JSON has no infinity: null.
std::string numberOrNull(double value)
{
  std::ostringstream text;
  text.precision(10);
  text << value;
  return std::isfinite(value) ? text.str() : "null";
}

/// Over all points that the exact field reaches, apart from the source itself.
double largestRelativeError(const std::vector<double>& distances, const std::vector<double>& exact)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < exact.size(); ++i)
  {
    if (std::isfinite(exact[i]) && exact[i] > 0.0)
    {
      largest = std::max(largest, std::abs(distances[i] - exact[i]) / exact[i]);
    }
  }
  return largest;
}

/// The distances of the mesh's points.
std::vector<double> atPoints(
  const geodesic::DistanceField& field, const geodesic::PolyDataSurface& surface)
{
  std::vector<double> atVertices = field.vertexDistances();
  surface.completeValues(geodesic::Infinity, atVertices);
  std::vector<double> distances(surface.numberOfPoints);
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    distances[i] = atVertices[surface.vertexOf(static_cast<geodesic::Id>(i))];
  }
  return distances;
}

/// A job on the threads that vtkSMPTools is set to use.
geodesic::Job threads()
{
  return geodesic::Job({},
    geodesic::teamOf(static_cast<std::size_t>(vtkSMPTools::GetEstimatedNumberOfThreads())),
    geodesic::Job::Sharing::WherePaying);
}

/// As the filter sets them.
geodesic::FrontOptions frontOptionsFor(const Options& options)
{
  geodesic::FrontOptions frontOptions;
  frontOptions.relativeError = options.relativeError;
  frontOptions.job = threads();
  return frontOptions;
}

geodesic::DistanceField solveField(const geodesic::TriangleMesh& mesh,
  const std::vector<geodesic::SourceCurve>& curves, double refinementTolerance,
  const geodesic::FrontOptions& options)
{
  if (!(refinementTolerance > 0.0))
  {
    return geodesic::solve(mesh, curves, options);
  }
  geodesic::PinnedFaces pinned(mesh.numberOfFaces(), 0);
  return geodesic::solveForRefinement(geodesic::MeshPartition(mesh),
    geodesic::makeSourceWindows(mesh, curves, options.job), refinementTolerance, options, pinned);
}

/// The same, of the field of a solve; solves anew where not all windows were kept.
double windowsPerEdge(const geodesic::DistanceField& field,
  const std::vector<geodesic::SourceCurve>& curves, const geodesic::FrontOptions& options)
{
  if (field.hasWindows() && field.droppedTolerance() == 0.0)
  {
    return windowsPerEdge(field);
  }
  return windowsPerEdge(geodesic::solve(field.mesh(), curves, options, geodesic::KeepWindows::All));
}

geodesic::RefinedMesh refineField(const geodesic::DistanceField& field, double tolerance)
{
  geodesic::RefinementOptions options;
  options.tolerance = tolerance;
  options.job = threads();
  return geodesic::refine(field, options);
}

/// The distances of the mesh's points.
struct EngineRun
{
  std::vector<double> distances;
  /// The exact ones, where --error asks for them.
  std::vector<double> exact;
};

/// The stages of the engine one by one.
EngineRun measureEngine(
  const Options& options, vtkPolyData* mesh, const Source& source, std::ostream& json)
{
  forgetPeakMemory();
  const std::uint64_t loaded = memory("VmRSS");
  Stopwatch watch;
  const geodesic::PolyDataSurface surface =
    geodesic::readSurface(geodesic::polyDataBlocks(mesh, geodesic::PartName("the surface")), {},
      geodesic::OneRank::instance(), threads());
  const double buildSeconds = watch.lap();
  const std::vector<geodesic::SourceCurve> curves = makeCurves(source, surface);
  const double sourceSeconds = watch.lap();
  const geodesic::FrontOptions frontOptions = frontOptionsFor(options);
  const auto field =
    solveField(surface.mesh(), curves, options.refine * surface.diagonal, frontOptions);
  const double solveSeconds = watch.lap();
  json << ", \"faces\": " << surface.mesh().numberOfFaces()
       << ", \"edges\": " << geodesictest::numberOfEdges(surface.mesh())
       << ", \"build_s\": " << buildSeconds << ", \"source_s\": " << sourceSeconds
       << ", \"solve_s\": " << solveSeconds;

  std::size_t outputCells = surface.mesh().numberOfFaces();
  double refineSeconds = 0.0;
  if (options.refine > 0.0)
  {
    watch.lap();
    const geodesic::RefinedMesh refined = refineField(field, options.refine * surface.diagonal);
    refineSeconds = watch.lap();
    outputCells = refined.triangles.size();
    json << ", \"interpolation_error_bound\": " << refined.errorBound;
  }
  json << ", \"refine_s\": " << refineSeconds << ", \"loaded_rss_bytes\": " << loaded
       << ", \"peak_rss_bytes\": " << memory("VmHWM")
       << ", \"windows_propagated\": " << field.windowsPropagated()
       << ", \"relative_error_bound\": " << field.relativeErrorBound()
       << ", \"max_distance\": " << largestFinite(field.vertexDistances())
       << ", \"output_cells\": " << outputCells;

  if (options.envelope)
  {
    const double perEdge = windowsPerEdge(field, curves, frontOptions);
    json << ", \"windows_per_edge\": " << perEdge << ", \"windows_propagated_per_envelope\": "
         << numberOrNull(static_cast<double>(field.windowsPropagated()) /
              (perEdge * static_cast<double>(geodesictest::numberOfEdges(surface.mesh()))));
  }
  EngineRun run;
  run.distances = atPoints(field, surface);
  if (options.error)
  {
    geodesic::FrontOptions exactOptions;
    exactOptions.job = frontOptions.job;
    run.exact = atPoints(geodesic::solve(surface.mesh(), curves, exactOptions), surface);
    json << ", \"max_relative_error\": "
         << numberOrNull(largestRelativeError(run.distances, run.exact));
  }
  return run;
}

/// A solve on one thread, and how it would be shared by more.
void measureModel(
  const Options& options, vtkPolyData* mesh, const Source& source, std::ostream& json)
{
  const geodesic::PolyDataSurface surface =
    geodesic::readSurface(geodesic::polyDataBlocks(mesh, geodesic::PartName("the surface")), {},
      geodesic::OneRank::instance(), threads());
  const std::vector<geodesic::SourceCurve> curves = makeCurves(source, surface);
  TaskModel model(options.model);
  geodesic::FrontOptions frontOptions = frontOptionsFor(options);
  frontOptions.job = geodesic::Job({}, model.parallelFor());
  Stopwatch watch;
  solveField(surface.mesh(), curves, options.refine * surface.diagonal, frontOptions);
  const double seconds = watch.lap();
  json << ", \"serial_share\": " << model.serialShare(seconds);
  const std::vector<double> gains = model.gains(seconds);
  for (std::size_t i = 0; i < gains.size(); ++i)
  {
    json << ", \"model_" << options.model[i] << "\": " << gains[i];
  }
}

void write(const std::string& name, const QueryRun& run, std::ostream& json)
{
  json << ", \"" << name << "_s\": " << run.seconds << ", \"" << name
       << "_loaded_rss_bytes\": " << run.loadedBytes << ", \"" << name
       << "_peak_rss_bytes\": " << run.peakBytes << ", \"" << name
       << "_output_points\": " << run.outputPoints << ", \"" << name
       << "_output_cells\": " << run.outputCells;
}

/// What can be asked of a field.
void measureQueries(const Options& options, const QuerySubject& subject, std::ostream& json)
{
  const double reach = options.reach * subject.largestDistance;
  if (options.arrays)
  {
    write("field", runField(subject, false), json);
    write("arrays", runField(subject, true), json);
  }
  if (options.paths > 0)
  {
    write("paths", runPaths(subject, randomPoints(subject, reach, options.paths, 1)), json);
  }
  if (options.contour > 0)
  {
    write("contour", runContour(subject, options.contour, options.refine), json);
  }
  if (options.contour > 0 && options.refine > 0.0)
  {
    write("refined_contour", runRefinedContour(subject, options.contour, options.refine), json);
  }
  if (options.matrixSources > 0)
  {
    // Any two points within half of it are as near to each other as that.
    const double half = options.reach < 1.0 ? 0.5 * reach : reach;
    write("matrix",
      runMatrix(subject.surface, randomPoints(subject, half, options.matrixSources, 2),
        randomPoints(subject, half, options.matrixTargets, 3)),
      json);
  }
}

void run(const Options& options, vtkPolyData* mesh, const Source& source)
{
  std::ostringstream json;
  json.precision(10);
  json << "{\"mesh\": " << quoted(options.mesh) << ", \"source\": " << quoted(options.source)
       << ", \"relative_error\": " << options.relativeError
       << ", \"threads\": " << vtkSMPTools::GetEstimatedNumberOfThreads();
  const EngineRun engine = measureEngine(options, mesh, source, json);
  if (options.update)
  {
    const FilterRun filter = runFilter(mesh, source.curves, options.relativeError, options.refine);
    json << ", \"without_reach_s\": " << runFilterWithoutReach(mesh, source.curves).seconds
         << ", \"update_s\": " << filter.seconds
         << ", \"update_output_cells\": " << filter.outputCells;
  }
  if (!options.model.empty())
  {
    measureModel(options, mesh, source, json);
  }
  measureQueries(
    options, { mesh, source.curves, engine.distances, largestFinite(engine.distances) }, json);
  for (const std::string& name : options.against)
  {
    const PeerRun peer = runPeer(name, mesh, source.vertex);
    json << ", \"" << name << "_s\": " << peer.seconds;
    if (options.error && source.isVertex)
    {
      json << ", \"" << name << "_max_relative_error\": "
           << numberOrNull(largestRelativeError(peer.distances, engine.exact));
    }
  }
  std::cout << json.str() << "}" << std::endl;
}

void measure(const Options& options)
{
  if (options.threads > 1 && std::string(vtkSMPTools::GetBackend()) == "Sequential")
  {
    vtkSMPTools::SetBackend("STDThread");
  }
  if (options.threads > 0)
  {
    vtkSMPTools::Initialize(options.threads);
  }
  vtkSmartPointer<vtkPolyData> mesh = plainTriangles(readMesh(options.mesh));
  if (mesh->GetNumberOfPolys() == 0)
  {
    throw std::runtime_error(options.mesh + " has no faces that can be read");
  }
  if (options.subdivide > 0)
  {
    mesh = subdivide(mesh, options.subdivide);
  }
  if (options.noise > 0.0)
  {
    mesh = addNoise(mesh, options.noise);
  }
  if (!options.write.empty())
  {
    writeMesh(mesh, options.write);
  }
  const Source source = makeSource(options.source, mesh);
  for (int i = 0; i < options.repeat; ++i)
  {
    run(options, mesh, source);
  }
}

}

int main(int argc, char* argv[])
{
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.empty() || arguments[0] == "--help")
  {
    std::cout << Usage << peerNames() << "\n";
    return arguments.empty() ? 1 : 0;
  }
  try
  {
    measure(parse(arguments));
  }
  catch (const std::exception& error)
  {
    std::cerr << "geodesicBenchmark: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
