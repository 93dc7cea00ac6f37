// SPDX-License-Identifier: BSD-3-Clause
#include "ParallelFor.h"

#include "vtkSMPTools.h"

#include <exception>
#include <mutex>

namespace geodesic
{

decltype(SolveOptions::parallelFor) smpParallelFor()
{
  if (vtkSMPTools::GetEstimatedNumberOfThreads() < 2)
  {
    return {};
  }
  return [](std::size_t count, const std::function<void(std::size_t)>& task)
  {
    std::exception_ptr thrown;
    std::mutex guard;
    const auto run = [&](vtkIdType begin, vtkIdType end)
    {
      try
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          task(static_cast<std::size_t>(i));
        }
      }
      catch (...) // it must not leave the thread
      {
        const std::lock_guard<std::mutex> lock(guard);
        thrown = std::current_exception();
      }
    };
    vtkSMPTools::For(0, static_cast<vtkIdType>(count), 1, run);
    if (thrown)
    {
      std::rethrow_exception(thrown);
    }
  };
}

}
