// SPDX-License-Identifier: BSD-3-Clause
// Running out of memory, at whatever stage and on whatever thread, ends in an error with empty
// outputs; with enough memory the next execution is right. Nothing is said but by the filter.
#include "GeodesicTesting.h"

#include "vtkDoubleArray.h"
#include "vtkSMPTools.h"

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <new>

#ifdef __linux__
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>
#endif

using namespace GeodesicTesting;

namespace
{

/// When armed, memory is refused to all threads but one.
std::atomic<bool> RefuseToHelpers{ false };
std::atomic<int> Refused{ 0 };
/// When armed, no thread gets more memory at once than a message needs.
std::atomic<bool> RefuseLarge{ false };
constexpr std::size_t Large = 4096;
thread_local bool IsMainThread = false;

}

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmismatched-new-delete" // they match, but inlined one by one
#endif

void* operator new(std::size_t size)
{
  if (RefuseToHelpers.load(std::memory_order_relaxed) && !IsMainThread)
  {
    ++Refused;
    throw std::bad_alloc();
  }
  if (size >= Large && RefuseLarge.load(std::memory_order_relaxed))
  {
    throw std::bad_alloc();
  }
  if (void* memory = std::malloc(size > 0 ? size : 1))
  {
    return memory;
  }
  throw std::bad_alloc();
}

void operator delete(void* memory) noexcept
{
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

namespace
{

const Point Source{ 0.3, 0.4, 0 };

vtkSmartPointer<vtkPolyData> Surface()
{
  auto surface = Square(128);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Values");
  values->SetNumberOfComponents(600); // so much that the output takes the most
  values->SetNumberOfTuples(surface->GetNumberOfPoints());
  values->Fill(1.0);
  surface->GetPointData()->AddArray(values);
  return surface;
}

vtkSmartPointer<vtkGeodesicDistanceField> FilterOf(vtkPolyData* surface)
{
  auto filter = RefinedField(surface, PointSources({ Source }));
  filter->SetRefinementTolerance(0.00002);
  return filter;
}

void CheckRefused(
  Check& check, vtkGeodesicDistanceField* filter, const Messages& messages, const std::string& what)
{
  check.That(Contains(messages.Error(), "not enough memory"), what + " is told as an error");
  CheckOutputsEmpty(check, filter, what);
}

void CheckRight(Check& check, vtkGeodesicDistanceField* filter, const std::string& what)
{
  filter->Modified();
  RunWithoutError(check, filter, what + ": no error afterwards");
  CheckDistances(check, filter, DistanceTo({ Source }), what + ", afterwards");
}

void SetThreads(int threads)
{
  vtkSMPTools::SetBackend(threads == 1 ? "Sequential" : "STDThread");
  vtkSMPTools::Initialize(threads);
}

/// The engine's tasks get no memory on the threads that help.
void CheckHelpers(Check& check)
{
  SetThreads(2);
  const auto surface = Surface();
  Refused = 0;
  for (int run = 0; run < 20 && Refused == 0; ++run)
  {
    const auto filter = FilterOf(surface);
    Messages messages(filter);
    // While the threads are those of the team: the front is split only where that pays at the time,
    // the faces to refine always are.
    bool armed = true;
    Listener listener(filter, vtkCommand::ProgressEvent,
      [&]
      {
        const double progress = filter->GetProgress();
        RefuseToHelpers = armed && progress > 0.25 && progress < 0.95;
      });
    messages.Update();
    armed = false;
    RefuseToHelpers = false;
    if (Refused > 0)
    {
      CheckRefused(check, filter, messages, "no memory on a helping thread");
      CheckRight(check, filter, "no memory on a helping thread");
    }
  }
  check.That(Refused > 0, "a helping thread was refused memory");
}

#ifdef __linux__

/// Lets the process have no more memory than it has and so much.
class Limit
{
public:
  explicit Limit(std::size_t more)
  {
    malloc_trim(0);
    getrlimit(RLIMIT_AS, &this->Before);
    rlimit limit = this->Before;
    limit.rlim_cur = Size() + more;
    setrlimit(RLIMIT_AS, &limit);
  }
  ~Limit() { setrlimit(RLIMIT_AS, &this->Before); }
  Limit(const Limit&) = delete;
  void operator=(const Limit&) = delete;

private:
  static std::size_t Size()
  {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  }

  rlimit Before{};
};

/// From no memory at all to enough.
void CheckLimits(Check& check, int threads)
{
  SetThreads(threads);
  const auto surface = Surface();
  bool enough = false;
  for (std::size_t more = 0; !enough && more < (std::size_t(1) << 30);
       more += (std::size_t(1) << 18) + more / 8)
  {
    const std::string name =
      std::to_string(threads) + " threads with " + std::to_string(more >> 10) + " kB";
    const auto filter = FilterOf(surface);
    Messages messages(filter);
    {
      const Limit limit(more);
      messages.Update();
    }
    enough = messages.Error().empty();
    if (enough)
    {
      CheckDistances(check, filter, DistanceTo({ Source }), name);
    }
    else
    {
      CheckRefused(check, filter, messages, name);
    }
  }
  check.That(enough, "there is a limit that is enough");
}

/// From this progress of the filter on there is no more memory.
/// The error says what the filter was doing: the stage of this progress runs out of memory.
void CheckStage(
  Check& check, int threads, vtkPolyData* surface, double progress, const std::string& doing)
{
  const std::string name = std::to_string(threads) + " threads, no memory for " + doing;
  const auto filter = FilterOf(surface);
  Messages messages(filter);
  {
    Listener listener(filter, vtkCommand::ProgressEvent,
      [&] { RefuseLarge = RefuseLarge || filter->GetProgress() >= progress; });
    messages.Update();
    RefuseLarge = false;
  }
  check.That(Contains(messages.Error(), "ran out while " + doing), name + ": " + messages.Error());
  CheckRefused(check, filter, messages, name);
  CheckRight(check, filter, name);
}

void CheckStages(Check& check, int threads)
{
  SetThreads(threads);
  const auto surface = Surface();
  CheckStage(check, threads, surface, 0.0, "reading the surface");
  CheckStage(check, threads, surface, 0.26, "computing the distances");
  CheckStage(check, threads, surface, 0.56, "refining the surface");
  CheckStage(check, threads, surface, 0.96, "writing the outputs");
}

std::size_t MemoryOfTheSystem()
{
  std::ifstream stream("/proc/meminfo");
  for (std::string line; std::getline(stream, line);)
  {
    const std::string word = "MemAvailable:";
    if (line.compare(0, word.size(), word) == 0)
    {
      return std::stoull(line.substr(word.size())) * 1024;
    }
  }
  return 0;
}

/// The system hands out more memory than it has: what the output is to take is compared with what
/// is there before it is used. The input's values are never touched, so that they take no memory.
void CheckMoreThanThereIs(Check& check)
{
  SetThreads(1);
  const std::size_t available = MemoryOfTheSystem();
  if (available == 0)
  {
    std::cout << "The system does not say how much memory there is: not tested.\n";
    return;
  }
  auto surface = Square(16);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Values");
  values->SetNumberOfComponents(static_cast<int>(
    available / sizeof(double) / static_cast<std::size_t>(surface->GetNumberOfPoints())));
  double* memory = static_cast<double*>(std::malloc(available));
  if (!memory)
  {
    std::cout << "The system hands out no more memory than it has: not tested.\n";
    return;
  }
  values->SetArray(memory,
    static_cast<vtkIdType>(values->GetNumberOfComponents()) * surface->GetNumberOfPoints(), 1);
  surface->GetPointData()->AddArray(values);
  const auto filter = RefinedField(surface, PointSources({ Source }));
  Messages messages(filter);
  messages.Update();
  CheckRefused(check, filter, messages, "more memory than there is");
  CheckWords(check, messages.Error(),
    { "writing the outputs, after all was computed", "MB more", "available" },
    "more memory than there is");
  surface->GetPointData()->RemoveArray("Values");
  CheckRight(check, filter, "more memory than there is");
  values->Initialize();
  std::free(memory);
}

void CheckLimits(Check& check)
{
  // Freed memory goes back at once, and threads share what there is.
  mallopt(M_MMAP_THRESHOLD, 1 << 17);
  mallopt(M_TRIM_THRESHOLD, 1 << 17);
  mallopt(M_ARENA_MAX, 1);
  for (const int threads : { 1, 2 })
  {
    CheckLimits(check, threads);
    CheckStages(check, threads);
  }
}

#else

void CheckMoreThanThereIs(Check&)
{
  std::cout << "The memory of this system is not looked at: not tested.\n";
}

void CheckLimits(Check&)
{
  std::cout << "The process's memory is not limited on this system: not all stages are tested.\n";
}

#endif

}

int TestGeodesicMemory(int, char*[])
{
  IsMainThread = true;
  Check check;
  CheckMoreThanThereIs(check);
  CheckLimits(check);
  CheckHelpers(check);
  return check.Result();
}
