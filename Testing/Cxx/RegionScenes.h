// SPDX-License-Identifier: BSD-3-Clause
// Random surfaces with random regions as the source; and barriers, faces without area, blocks. The
// truth is the brute-force solver's on the surface without the faces of regions, from where these
// met others.
#ifndef RegionScenes_h
#define RegionScenes_h

#include "RandomBarriers.h"

namespace GeodesicTesting
{

/// A random surface, each face of which may be in a region, a barrier, or both.
struct RegionScene
{
  std::string name;
  /// Open faces are those in no region that are no barriers.
  RandomBarriers made;
  /// For each face of the surface its region, and of the whole; -1: none. Faces without area may be
  /// in the region of a face at their edge.
  std::vector<int> regionOf;
  std::vector<int> regionOfWhole;
  std::vector<bool> isBarrierOfWhole;
  /// What regions have in common with open faces.
  geodesictest::Sources sources;
  bool hasFlatFaces;

  bool isInRegion(std::size_t faceOfWhole) const
  {
    return this->regionOfWhole[faceOfWhole] >= 0 && !this->isBarrierOfWhole[faceOfWhole];
  }
};

/// Another seed for each text.
inline std::uint64_t SeedOf(const std::string& text)
{
  std::uint64_t seed = 14695981039346656037ULL;
  for (const char c : text)
  {
    seed = (seed ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  }
  return seed;
}

/// For each face its region: patches around faces, with holes, that may touch; or all faces.
inline std::vector<int> RandomRegions(
  const geodesictest::PlainMesh& mesh, geodesictest::Random& random)
{
  const std::size_t faces = mesh.triangles.size();
  std::vector<int> regionOf(faces, -1);
  if (random.chance(0.03))
  {
    regionOf.assign(faces, 0);
    return regionOf;
  }
  std::vector<std::vector<std::size_t>> around(mesh.points.size());
  for (std::size_t f = 0; f < faces; ++f)
  {
    for (const geodesictest::Index v : mesh.triangles[f])
    {
      around[v].push_back(f);
    }
  }
  const int regions = static_cast<int>(random.between(1, 3));
  for (int region = 0; region < regions; ++region)
  {
    const std::size_t wanted =
      random.chance(0.3) ? 1 : 1 + random.below(random.chance(0.1) ? 200 : 25);
    std::vector<std::size_t> chosen = { random.below(faces) };
    regionOf[chosen.front()] = region;
    for (std::size_t i = 0; i < chosen.size() && chosen.size() < wanted; ++i)
    {
      for (const geodesictest::Index v : mesh.triangles[chosen[i]])
      {
        for (const std::size_t f : around[v])
        {
          if (regionOf[f] < 0 && random.chance(0.7))
          {
            regionOf[f] = region;
            chosen.push_back(f);
          }
        }
      }
    }
    for (std::size_t i = 1; i < chosen.size(); ++i)
    {
      if (random.chance(0.1))
      {
        regionOf[chosen[i]] = -1;
      }
    }
  }
  return regionOf;
}

/// Edges and corners of open faces that regions have, too.
inline void AddWhereRegionsMeetOpenFaces(RegionScene& scene)
{
  using Edge = std::pair<geodesictest::Index, geodesictest::Index>;
  const geodesictest::PlainMesh& whole = scene.made.whole;
  std::set<Edge> edges;
  std::set<geodesictest::Index> corners;
  for (std::size_t f = 0; f < whole.triangles.size(); ++f)
  {
    const geodesictest::Triangle& t = whole.triangles[f];
    for (std::size_t k = 0; scene.isInRegion(f) && k < 3; ++k)
    {
      edges.insert(std::minmax({ t[k], t[(k + 1) % 3] }));
      corners.insert(t[k]);
    }
  }
  for (geodesictest::Index f = 0; f < scene.made.open.triangles.size(); ++f)
  {
    const geodesictest::Triangle& t = scene.made.open.triangles[f];
    for (std::size_t k = 0; k < 3; ++k)
    {
      geodesictest::MeshSegment edge{ f, { 0, 0, 0 }, { 0, 0, 0 } };
      edge.from[k] = 1.0;
      edge.to[(k + 1) % 3] = 1.0;
      if (corners.count(t[k]) > 0)
      {
        scene.sources.points.push_back({ f, edge.from });
      }
      if (edges.count(std::minmax({ t[k], t[(k + 1) % 3] })) > 0)
      {
        scene.sources.segments.push_back(edge);
      }
    }
  }
}

inline RegionScene MakeRegionScene(
  const geodesictest::MeshKind& kind, std::uint64_t seed, bool mayHaveFlatFaces = true)
{
  geodesictest::Random random(SeedOf(kind.name) + seed);
  RegionScene scene;
  scene.name = std::string(kind.name) + ", seed " + std::to_string(seed);
  scene.hasFlatFaces = random.chance(0.4) && mayHaveFlatFaces;
  const geodesictest::PlainMesh before = kind.make(random.between(8, 100), random);
  const double offset = random.chance(0.5) ? 0.0 : std::pow(10.0, random.uniform(-17.0, -12.0));
  geodesictest::CappedMesh both = geodesictest::withCaps(before, geodesictest::Caps::AnyAndLoose,
    scene.hasFlatFaces ? random.uniform(0.1, 1.0) : 0.0, random, offset);
  if (scene.hasFlatFaces)
  {
    geodesictest::addNeedles(both, random.uniform(0.0, 0.5), random, offset);
  }
  const std::vector<int> regions = RandomRegions(before, random);
  const std::vector<bool> barriers = random.chance(0.5)
    ? std::vector<bool>(before.triangles.size(), false)
    : RandomFaces(before, random);
  scene.made.surface = both.mesh;
  scene.made.whole = both.conforming;
  scene.made.pointOfWhole = both.vertexOf;
  for (const std::vector<geodesictest::Index>& faces : both.facesBefore)
  {
    const geodesictest::Index one = faces[random.below(faces.size())];
    const bool isLeftOut = faces.size() > 1 && (random.chance(0.3) || barriers[one]);
    scene.regionOf.push_back(isLeftOut ? -1 : regions[one]);
    scene.made.isBarrier.push_back(
      std::all_of(faces.begin(), faces.end(), [&](geodesictest::Index f) { return barriers[f]; }));
  }
  for (const geodesictest::Index f : both.faceBefore)
  {
    scene.regionOfWhole.push_back(regions[f]);
    scene.isBarrierOfWhole.push_back(barriers[f]);
  }
  std::vector<bool> isClosed;
  for (std::size_t f = 0; f < scene.regionOfWhole.size(); ++f)
  {
    isClosed.push_back(scene.regionOfWhole[f] >= 0 || scene.isBarrierOfWhole[f]);
  }
  AddOpenFaces(scene.made, isClosed);
  AddWhereRegionsMeetOpenFaces(scene);
  return scene;
}

/// Whether there is a region outside of barriers.
inline bool HasRegion(const RegionScene& scene)
{
  bool has = false;
  for (std::size_t f = 0; f < scene.regionOfWhole.size(); ++f)
  {
    has = has || scene.isInRegion(f);
  }
  return has;
}

/// Whether regions lie on no other faces, too: which of these they are is open.
inline bool IsClear(const RegionScene& scene)
{
  if (TouchesItself(scene.made.whole, 1e-9))
  {
    return false;
  }
  const geodesictest::Barycentric places[] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 0.5, 0.5, 0 }, { 0, 0.5, 0.5 }, { 0.5, 0, 0.5 }, { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 } };
  for (geodesictest::Index f = 0; f < scene.made.whole.triangles.size(); ++f)
  {
    if (scene.isInRegion(f) &&
      std::any_of(std::begin(places), std::end(places),
        [&](const geodesictest::Barycentric& at) {
          return IsOnOtherFace(scene.made.whole, { f, at });
        }))
    {
      return false;
    }
  }
  return true;
}

/// The edges that one face of a region has.
inline double OutlineLengthOf(const RegionScene& scene)
{
  std::map<std::array<geodesictest::Index, 3>, int> uses;
  const geodesictest::PlainMesh& whole = scene.made.whole;
  for (std::size_t f = 0; f < whole.triangles.size(); ++f)
  {
    for (std::size_t k = 0; scene.isInRegion(f) && k < 3; ++k)
    {
      const auto [a, b] = std::minmax({ whole.triangles[f][k], whole.triangles[f][(k + 1) % 3] });
      ++uses[{ a, b, static_cast<geodesictest::Index>(scene.regionOfWhole[f]) }];
    }
  }
  double length = 0.0;
  for (const auto& [edge, count] : uses)
  {
    length +=
      count == 1 ? geodesictest::spaceDistance(whole.points[edge[0]], whole.points[edge[1]]) : 0.0;
  }
  return length;
}

/// Of the largest distance.
inline double AccuracyOn(const geodesictest::MeshKind& kind)
{
  return Contains(kind.name, "Needles") ? 5e-10 : 1e-10;
}

/// At the points of the whole: from the regions.
inline std::vector<double> TruthOf(const RegionScene& scene)
{
  const geodesictest::PlainMesh& whole = scene.made.whole;
  std::vector<double> truth(whole.points.size(), INFINITY);
  if (!scene.made.open.triangles.empty() && !scene.sources.points.empty())
  {
    truth = geodesictest::bruteForceDistances(scene.made.open, scene.sources).vertices;
  }
  for (std::size_t f = 0; f < whole.triangles.size(); ++f)
  {
    for (const geodesictest::Index v : whole.triangles[f])
    {
      truth[v] = scene.isInRegion(f) ? 0.0 : truth[v];
    }
  }
  return truth;
}

/// The faces of regions, each with its region times 10 in the array "region".
///
/// \param isWanted which faces; empty: all.
inline vtkSmartPointer<vtkPolyData> SourceOf(
  const RegionScene& scene, const std::vector<bool>& isWanted = {})
{
  std::vector<bool> isInSource = isWanted;
  isInSource.resize(scene.regionOf.size(), isWanted.empty());
  vtkNew<vtkIntArray> regions;
  regions->SetName("region");
  for (std::size_t f = 0; f < isInSource.size(); ++f)
  {
    isInSource[f] = isInSource[f] && scene.regionOf[f] >= 0;
    if (isInSource[f])
    {
      regions->InsertNextValue(10 * scene.regionOf[f]);
    }
  }
  if (regions->GetNumberOfTuples() == 0) // points without faces would be sources
  {
    return vtkSmartPointer<vtkPolyData>::New();
  }
  auto source = SurfaceOf(scene.made, isInSource);
  source->GetCellData()->Initialize();
  source->GetCellData()->AddArray(regions);
  return source;
}

/// Each face in a random block, of the surface and of the source.
struct SceneInBlocks
{
  vtkNew<vtkMultiBlockDataSet> surface;
  vtkNew<vtkMultiBlockDataSet> source;

  SceneInBlocks(const RegionScene& scene, geodesictest::Index count, geodesictest::Random& random)
  {
    std::vector<std::vector<bool>> isInBlock(
      count, std::vector<bool>(scene.made.surface.triangles.size(), false));
    for (std::size_t f = 0; f < scene.made.surface.triangles.size(); ++f)
    {
      isInBlock[random.below(count)][f] = true;
    }
    for (geodesictest::Index i = 0; i < count; ++i)
    {
      this->surface->SetBlock(i, SurfaceOf(scene.made, isInBlock[i]));
      this->source->SetBlock(i, SourceOf(scene, isInBlock[i]));
    }
  }
};

}

#endif
