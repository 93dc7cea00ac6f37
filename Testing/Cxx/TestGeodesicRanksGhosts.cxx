// SPDX-License-Identifier: BSD-3-Clause
// Under MPI: ghost cells whose points differ by roundings from those of what they duplicate are
// copies all the same, in blocks of one process and over ranks. Random surfaces with barriers and
// hidden cells, which are holes, cut at random. Cells of different ranks are copies only where they
// have the same corners, all of them.
#include "GeodesicTesting.h"
#include "RanksTesting.h"

#include "vtkGeodesicPaths.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"

#include <cfloat>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <limits>

using namespace GeodesicTesting;

namespace
{

using Random = std::mt19937_64;

double Uniform(Random& random)
{
  return std::uniform_real_distribution<double>()(random);
}

/// A surface in parts, which have copies of the faces around them.
struct CutSurface
{
  vtkSmartPointer<vtkPolyData> Whole;
  Cut Parts;
  std::uint64_t Seed;
  bool HasGlobalIds;
};

/// \param orphans whether there are faces that are nobody's, but copies of them.
CutSurface MakeCutSurface(std::uint64_t seed, int parts, bool orphans)
{
  Random random(seed);
  CutSurface made{ NoisySquare(8), {}, seed, random() % 2 == 0 };
  MovePoints(made.Whole,
    [&](const Point& p) {
      return Point{ p[0] + 0.5, p[1], p[2] + 0.05 * (Uniform(random) - 0.5) };
    });
  std::vector<int> barriers;
  std::vector<int> hidden;
  std::vector<int> numbers;
  Random holes(~seed);
  const double hiddenShare = holes() % 2 == 0 ? 0.0 : 0.15 * Uniform(holes);
  const double share = 0.15 * Uniform(random);
  std::vector<Point> centres;
  for (int i = 0; i < parts; ++i)
  {
    centres.push_back({ 0.5 + Uniform(random), Uniform(random), 0.0 });
  }
  const bool isScattered = random() % 4 == 0;
  std::vector<int> partOf;
  for (vtkIdType face = 0; face < made.Whole->GetNumberOfPolys(); ++face)
  {
    const Point p = CentreOf(made.Whole, face);
    const auto distance = [&](const Point& c) { return std::hypot(p[0] - c[0], p[1] - c[1]); };
    const auto nearest = std::min_element(centres.begin(), centres.end(),
      [&](const Point& a, const Point& b) { return distance(a) < distance(b); });
    const int scattered = static_cast<int>(random() % static_cast<unsigned>(parts));
    const bool isOrphan = orphans && Uniform(random) < 0.1;
    partOf.push_back(isOrphan ? parts
        : isScattered         ? scattered
                              : static_cast<int>(nearest - centres.begin()));
    barriers.push_back(face > 1 && Uniform(random) < share ? 1 : 0);
    hidden.push_back(face > 1 && Uniform(holes) < hiddenShare ? 1 : 0);
    numbers.push_back(static_cast<int>(face));
  }
  AddArray<vtkIntArray>(made.Whole->GetCellData(), "hidden", hidden);
  AddArray<vtkIntArray>(made.Whole->GetCellData(), "barrier", barriers);
  AddArray<vtkIntArray>(made.Whole->GetCellData(), "face", numbers);
  made.Parts = [partOf](vtkIdType face) { return partOf[static_cast<std::size_t>(face)]; };
  return made;
}

bool IsHidden(vtkPolyData* data, vtkIdType face)
{
  return CellValue(data, "hidden", face) != 0.0;
}

/// The surface without its hidden faces, of those that isThere(face) is true for.
template <typename IsThere>
vtkSmartPointer<vtkPolyData> WithHoles(const CutSurface& surface, const IsThere& isThere)
{
  std::vector<vtkIdType> faces;
  for (vtkIdType face = 0; face < surface.Whole->GetNumberOfPolys(); ++face)
  {
    if (!IsHidden(surface.Whole, face) && isThere(face))
    {
      faces.push_back(face);
    }
  }
  return Part(surface.Whole, faces, true);
}

/// Marks the hidden faces of a part as such, copies and others alike.
void HideFaces(vtkPolyData* piece)
{
  vtkSmartPointer<vtkUnsignedCharArray> marks = piece->GetCellGhostArray();
  if (!marks)
  {
    marks = vtkSmartPointer<vtkUnsignedCharArray>::New();
    marks->SetName(vtkDataSetAttributes::GhostArrayName());
    marks->SetNumberOfTuples(piece->GetNumberOfPolys());
    marks->Fill(0);
    piece->GetCellData()->AddArray(marks);
  }
  for (vtkIdType face = 0; face < piece->GetNumberOfPolys(); ++face)
  {
    const int mark = IsHidden(piece, face) ? vtkDataSetAttributes::HIDDENCELL : 0;
    marks->SetValue(face, static_cast<unsigned char>(marks->GetValue(face) | mark));
  }
}

/// One part, every point of which is off by a rounding. The array "point" tells its number.
vtkSmartPointer<vtkPolyData> RoundedPart(const CutSurface& surface, int part, bool withGhosts)
{
  auto piece = withGhosts ? PartWithGhosts(surface.Whole, surface.Parts, part, true)
                          : Part(surface.Whole, FacesOf(surface.Whole, surface.Parts, part), true);
  HideFaces(piece);
  vtkNew<vtkIdTypeArray> numbers;
  numbers->DeepCopy(piece->GetPointData()->GetGlobalIds());
  numbers->SetName("point");
  if (!surface.HasGlobalIds)
  {
    piece->GetPointData()->SetGlobalIds(nullptr);
    piece->GetPointData()->RemoveArray("GlobalPointIds");
  }
  piece->GetPointData()->AddArray(numbers);
  vtkIdType next = 0;
  MovePoints(piece,
    [&](const Point& p)
    {
      const auto point = static_cast<std::uint64_t>(numbers->GetValue(next++));
      Random random(point * 64 + static_cast<std::uint64_t>(part) + 100000 * surface.Seed);
      const double largest = std::max({ std::abs(p[0]), std::abs(p[1]), std::abs(p[2]) });
      Point moved;
      for (std::size_t k = 0; k < 3; ++k)
      {
        moved[k] = p[k] + 0.5 * DBL_EPSILON * largest * (static_cast<double>(random() % 3) - 1.0);
      }
      return moved;
    });
  return piece;
}

/// In a face that is no barrier.
vtkSmartPointer<vtkPolyData> SourceOn(const CutSurface& surface)
{
  return PointSources({ CentreOf(surface.Whole, 0) });
}

void Ask(vtkGeodesicDistanceField* filter, const CutSurface& surface, bool isBoundary)
{
  filter->RefineMeshOff();
  filter->SetBarrierArrayName("barrier");
  filter->SetSourceData(SourceOn(surface));
  filter->SetSourceType(isBoundary ? vtkGeodesicDistanceField::SURFACE_BOUNDARY
                                   : vtkGeodesicDistanceField::SOURCE_CURVE);
}

/// Where the parts of a surface are.
struct Place
{
  /// Null for blocks in one process.
  vtkMultiProcessController* Controller;
  Ranks Parts;

  vtkSmartPointer<vtkDataObject> Surface(const CutSurface& surface, bool withGhosts) const
  {
    if (this->Controller)
    {
      return RoundedPart(surface, this->Parts.Rank, withGhosts);
    }
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    for (int i = 0; i < this->Parts.Count; ++i)
    {
      blocks->SetBlock(static_cast<unsigned int>(i), RoundedPart(surface, i, withGhosts));
    }
    return blocks;
  }
  /// Adds up over all parts.
  std::vector<int> Sum(const std::vector<int>& own) const
  {
    std::vector<int> all = own;
    if (this->Controller)
    {
      this->Controller->AllReduce(
        own.data(), all.data(), static_cast<vtkIdType>(own.size()), vtkCommunicator::SUM_OP);
    }
    return all;
  }
};

/// Whether a part has a face at each of its points that is not hidden.
std::vector<char> ArePointsOfFaces(vtkPolyData* part)
{
  std::vector<char> are(static_cast<std::size_t>(part->GetNumberOfPoints()), 0);
  for (vtkIdType face = 0; face < part->GetNumberOfPolys(); ++face)
  {
    vtkNew<vtkIdList> ids;
    part->GetPolys()->GetCellAtId(face, ids);
    for (vtkIdType k = 0; !IsHidden(part, face) && k < 3; ++k)
    {
      are[static_cast<std::size_t>(ids->GetId(k))] = 1;
    }
  }
  return are;
}

/// The distance at each point of the whole's faces, NaN where a part has none. All parts have the
/// same but for roundings.
std::vector<double> DistancesAtPoints(
  vtkGeodesicDistanceField* filter, const CutSurface& surface, double& spread)
{
  std::vector<double> distances(static_cast<std::size_t>(surface.Whole->GetNumberOfPoints()),
    std::numeric_limits<double>::quiet_NaN());
  for (vtkPolyData* part : LeavesOf(filter->GetOutputDataObject(0)))
  {
    vtkDataArray* values = part->GetPointData()->GetArray("GeodesicDistance");
    vtkDataArray* numbers = part->GetPointData()->GetArray("point");
    const std::vector<char> areOfFaces = ArePointsOfFaces(part);
    for (vtkIdType i = 0; i < part->GetNumberOfPoints(); ++i)
    {
      if (areOfFaces[static_cast<std::size_t>(i)] == 0)
      {
        continue;
      }
      double& at = distances[static_cast<std::size_t>(numbers->GetTuple1(i))];
      const double value = values->GetTuple1(i);
      const bool isSame = std::isnan(at) || at == value;
      spread = isSame ? spread : std::max(spread, std::abs(at - value));
      at = value;
    }
  }
  return distances;
}

double worstOfAll = 0.0;

void CompareField(Check& check, const CutSurface& surface, const Place& place, bool isBoundary,
  bool orphans, const std::string& what)
{
  // The faces that any part has.
  std::vector<char> isThere(static_cast<std::size_t>(surface.Whole->GetNumberOfPolys()), 0);
  for (int part = 0; part < place.Parts.Count; ++part)
  {
    const auto ghosted = PartWithGhosts(surface.Whole, surface.Parts, part);
    vtkDataArray* numbers = ghosted->GetCellData()->GetArray("face");
    for (vtkIdType i = 0; i < ghosted->GetNumberOfPolys(); ++i)
    {
      isThere[static_cast<std::size_t>(numbers->GetTuple1(i))] = 1;
    }
  }
  const auto whole = WithHoles(
    surface, [&](vtkIdType face) { return isThere[static_cast<std::size_t>(face)] != 0; });
  vtkNew<vtkGeodesicDistanceField> alone;
  alone->SetController(nullptr);
  alone->SetInputData(whole);
  Ask(alone, surface, isBoundary);
  alone->Update();
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetController(place.Controller);
  filter->SetInputDataObject(place.Surface(surface, true));
  Ask(filter, surface, isBoundary);
  Messages messages(filter);
  messages.Update();
  check.That(messages.Error().empty(), what + messages.Error());
  double worst = 0.0;
  const std::vector<double> distances = DistancesAtPoints(filter, surface, worst);
  for (vtkIdType i = 0; i < whole->GetNumberOfPoints(); ++i)
  {
    const double expected = Distances(alone)->GetTuple1(i);
    const double value =
      distances[static_cast<std::size_t>(whole->GetPointData()->GetGlobalIds()->GetTuple1(i))];
    const bool isKnown = !std::isnan(value) && value != expected;
    worst = isKnown ? std::max(worst, std::abs(value - expected)) : worst;
  }
  worstOfAll = std::max(worstOfAll, worst);
  check.That(worst < 1e-13, what + "wrong by " + std::to_string(worst));
  if (orphans)
  {
    return;
  }
  vtkNew<vtkGeodesicDistanceField> plain;
  plain->SetController(place.Controller);
  plain->SetInputDataObject(place.Surface(surface, false));
  Ask(plain, surface, isBoundary);
  plain->Update();
  check.That(plain->GetSeamPointsJoined() == filter->GetSeamPointsJoined(),
    what + "points on seams are counted as without ghosts");
}

bool IsCopy(vtkDataArray* marks, vtkIdType face)
{
  return (static_cast<int>(marks->GetTuple1(face)) & vtkDataSetAttributes::DUPLICATECELL) != 0;
}

/// Ghosts are refined as what they duplicate.
void CheckRefinement(
  Check& check, const CutSurface& surface, const Place& place, const std::string& what)
{
  vtkNew<vtkGeodesicDistanceField> filter;
  filter->SetController(place.Controller);
  filter->SetInputDataObject(place.Surface(surface, true));
  Ask(filter, surface, false);
  filter->RefineMeshOn();
  Messages messages(filter);
  messages.Update();
  check.That(messages.Error().empty(), what + messages.Error());
  std::vector<int> counts(static_cast<std::size_t>(surface.Whole->GetNumberOfPolys()), 0);
  const auto visit = [&](bool ofGhosts, auto use)
  {
    for (vtkPolyData* part : LeavesOf(filter->GetOutputDataObject(0)))
    {
      vtkDataArray* faces = part->GetCellData()->GetArray("face");
      vtkDataArray* marks = part->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName());
      std::map<std::size_t, int> own;
      for (vtkIdType i = 0; i < part->GetNumberOfPolys(); ++i)
      {
        own[static_cast<std::size_t>(faces->GetTuple1(i))] += IsCopy(marks, i) == ofGhosts ? 1 : 0;
      }
      for (const auto& [face, count] : own)
      {
        use(face, count);
      }
    }
  };
  visit(false, [&](std::size_t face, int count) { counts[face] += count; });
  const std::vector<int> all = place.Sum(counts);
  bool areAlike = true;
  visit(true,
    [&](std::size_t face, int count)
    { areAlike = areAlike && (count == 0 || count == all[face]); });
  check.That(areAlike, what + "ghosts are refined as what they duplicate");
  check.That(*std::max_element(all.begin(), all.end()) > 1, what + "faces are refined");
}

/// Paths from anywhere are as long as over the whole.
void ComparePaths(
  Check& check, const CutSurface& surface, const Place& place, const std::string& what)
{
  Random random(surface.Seed);
  std::vector<Point> targets;
  const auto whole = WithHoles(surface, [](vtkIdType) { return true; });
  for (int i = 0; i < 5; ++i)
  {
    targets.push_back(CentreOf(
      whole, static_cast<vtkIdType>(random() % static_cast<unsigned>(whole->GetNumberOfPolys()))));
  }
  const auto lengths = [&](vtkMultiProcessController* controller, vtkDataObject* data)
  {
    const auto filter = FilterOn<vtkGeodesicPaths>(data, SourceOn(surface));
    filter->SetController(controller);
    filter->SetBarrierArrayName("barrier");
    const bool isMine = !controller || controller->GetLocalProcessId() == 0;
    filter->SetTargetsData(PointSources(isMine ? targets : std::vector<Point>()));
    Messages messages(filter);
    messages.Update();
    check.That(messages.Error().empty(), what + messages.Error());
    std::map<double, double> found;
    vtkPolyData* output = filter->GetOutput();
    for (vtkIdType i = 0; i < output->GetNumberOfLines(); ++i)
    {
      found[CellValue(output, "TargetId", i)] = CellValue(output, "GeodesicDistance", i);
    }
    return found;
  };
  const auto expected = lengths(nullptr, whole);
  const auto found = lengths(place.Controller, place.Surface(surface, true));
  if (place.Controller && place.Controller->GetLocalProcessId() != 0)
  {
    return;
  }
  check.That(expected.size() == found.size(), what + "as many paths");
  for (const auto& [target, length] : expected)
  {
    const auto at = found.find(target);
    check.That(at != found.end() && std::abs(at->second - length) < 1e-13,
      what + "a path is as long as over the whole");
  }
}

void CheckSeed(Check& check, std::uint64_t seed, const Place& place)
{
  const std::string what =
    std::string(place.Controller ? "ranks" : "blocks") + ", seed " + std::to_string(seed) + ": ";
  const bool orphans = seed % 4 == 3;
  const CutSurface surface = MakeCutSurface(seed, place.Parts.Count, orphans);
  CompareField(check, surface, place, seed % 2 == 0, orphans, what);
  if (!orphans && seed % 4 == 0)
  {
    CheckRefinement(check, surface, place, what + "refined, ");
  }
  if (!orphans && seed % 4 == 1)
  {
    ComparePaths(check, surface, place, what + "paths, ");
  }
}

/// A quad with a notch on rank 0, and on rank 1 the triangle in the notch, which has three of the
/// quad's corners: neither is a copy of the other, whichever is marked. The fourth corner is the
/// very first point of all ranks, the one with label 0.
void CheckNotch(Check& check, Ranks ranks, bool isQuadMarked)
{
  const bool isEmpty = ranks.Rank > 1;
  const std::vector<Point> corners = { { 0, 3, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 } };
  const auto piece = PointSources(isEmpty ? std::vector<Point>() : corners);
  if (!isEmpty)
  {
    const std::vector<vtkIdType> quad = { 0, 1, 2, 3 };
    const vtkIdType first = ranks.Rank; // of the cell's corners
    vtkNew<vtkCellArray> polys;
    polys->InsertNextCell(4 - first, quad.data() + first);
    vtkNew<vtkUnsignedCharArray> marks;
    marks->SetName(vtkDataSetAttributes::GhostArrayName());
    marks->InsertNextValue(
      isQuadMarked == (ranks.Rank == 0) ? vtkDataSetAttributes::DUPLICATECELL : 0);
    piece->SetPolys(polys);
    piece->GetCellData()->AddArray(marks);
  }
  const auto filter = PlainField(piece, PointSources({ { -1, 0, 0 } }));
  Messages messages(filter);
  messages.Update();
  const std::string what =
    std::string("notch, ") + (isQuadMarked ? "the quad" : "the triangle") + " is marked: ";
  check.That(messages.Error().empty(), what + messages.Error());
  if (!isEmpty)
  {
    check.Near(Distances(filter)->GetTuple1(0), std::sqrt(10.0), 1e-13, what + "the quad is there");
    check.Near(Distances(filter)->GetTuple1(3), 2.0, 1e-13, what + "the triangle is there");
  }
}

}

int TestGeodesicRanksGhosts(int argc, char* argv[])
{
  return RunOnRanks(argc, argv,
    [](Check& check, Ranks ranks)
    {
      CheckNotch(check, ranks, false);
      CheckNotch(check, ranks, true);
      // How many seeds: more by hand.
      const char* given = std::getenv("GEODESIC_GHOST_SEEDS");
      const std::uint64_t count = given ? std::strtoull(given, nullptr, 10) : 24;
      const auto all = static_cast<std::uint64_t>(ranks.Count);
      for (std::uint64_t seed = 0; seed < count; ++seed)
      {
        CheckSeed(check, seed, { vtkMultiProcessController::GetGlobalController(), ranks });
        if (seed % all == static_cast<std::uint64_t>(ranks.Rank))
        {
          CheckSeed(check, seed, { nullptr, { 0, 2 + static_cast<int>(seed % 3) } });
        }
      }
      std::cout << "The largest difference is " << worstOfAll << "\n";
    });
}
