// SPDX-License-Identifier: BSD-3-Clause
#include "PolyData/Memory.h"

#include "vtkAbstractArray.h"
#include "vtkFieldData.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>

namespace geodesic
{

namespace
{

constexpr std::uint64_t Unknown = std::numeric_limits<std::uint64_t>::max();

#ifdef __linux__

/// The number after a word at the beginning of a line of a file; Unknown where there is none.
std::uint64_t numberAfter(const std::string& file, const std::string& word)
{
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
  {
    if (line.compare(0, word.size(), word) == 0)
    {
      const std::size_t digit = line.find_first_of("0123456789", word.size());
      return digit == std::string::npos ? Unknown : std::stoull(line.substr(digit));
    }
  }
  return Unknown;
}

std::uint64_t orZero(std::uint64_t number)
{
  return number == Unknown ? 0 : number;
}

std::uint64_t systemMemory()
{
  constexpr std::uint64_t kilo = 1024;
  const std::uint64_t available = numberAfter("/proc/meminfo", "MemAvailable:");
  const std::uint64_t swap = orZero(numberAfter("/proc/meminfo", "SwapFree:"));
  return available == Unknown ? Unknown : kilo * (available + swap);
}

/// What a control group leaves. What it has of files in memory can be freed.
///
/// \param folder of the group
/// \param limit, usage, files where it says them, in either version of control groups.
std::uint64_t groupMemory(const std::string& folder, const std::string& limit,
  const std::string& usage, const std::string& files)
{
  const std::uint64_t most = numberAfter(folder + limit, "");
  const std::uint64_t used = numberAfter(folder + usage, "");
  if (most == Unknown || used == Unknown)
  {
    return Unknown;
  }
  const std::uint64_t held =
    used - std::min(used, orZero(numberAfter(folder + "/memory.stat", files)));
  return most - std::min(most, held);
}

/// The least that is left by the control groups of this process and those around them.
std::uint64_t groupsMemory()
{
  std::uint64_t least = Unknown;
  std::ifstream stream("/proc/self/cgroup");
  // Lines are number:controllers:/path, without controllers in version 2.
  std::string number;
  std::string controllers;
  std::string path;
  while (std::getline(stream, number, ':') && std::getline(stream, controllers, ':') &&
    std::getline(stream, path))
  {
    const bool isSecondVersion = controllers.empty();
    if (!isSecondVersion && controllers != "memory")
    {
      continue;
    }
    const std::string root = isSecondVersion ? "/sys/fs/cgroup" : "/sys/fs/cgroup/memory";
    for (;; path.erase(path.rfind('/')))
    {
      path = path == "/" ? "" : path;
      least = std::min(least,
        isSecondVersion
          ? groupMemory(root + path, "/memory.max", "/memory.current", "inactive_file ")
          : groupMemory(root + path, "/memory.limit_in_bytes", "/memory.usage_in_bytes",
              "total_inactive_file "));
      if (path.rfind('/') == std::string::npos)
      {
        break;
      }
    }
  }
  return least;
}

#endif

}

std::uint64_t availableMemory()
{
#ifdef __linux__
  return std::min(systemMemory(), groupsMemory());
#else
  return Unknown;
#endif
}

void requireMemory(vtkIdType tuples, vtkIdType bytesATuple)
{
  constexpr std::size_t forSmallThings = 1 << 20;
  const std::size_t bytes =
    static_cast<std::size_t>(tuples) * static_cast<std::size_t>(bytesATuple) + forSmallThings;
  // Asking the system takes longer than using a little memory.
  constexpr std::size_t little = std::size_t(1) << 26;
  if (bytes > little)
  {
    const std::uint64_t available = availableMemory();
    if (available < bytes)
    {
      throw NotEnoughMemory(bytes, available);
    }
  }
  // Volatile, or the compiler may find that it is never used and leave it out.
  void* volatile memory = ::operator new(bytes);
  ::operator delete(memory);
}

void requireAnyMemory()
{
  constexpr std::uint64_t least = std::uint64_t(1) << 27;
  const std::uint64_t available = availableMemory();
  if (available < least)
  {
    throw NotEnoughMemory(0, available);
  }
}

vtkIdType bytesATuple(vtkFieldData* data)
{
  vtkIdType bytes = 0;
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    bytes += static_cast<vtkIdType>(array->GetNumberOfComponents()) *
      (array->GetDataTypeSize() > 0 ? array->GetDataTypeSize() : 1);
  }
  return bytes;
}

}
