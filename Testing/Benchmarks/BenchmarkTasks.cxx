// SPDX-License-Identifier: BSD-3-Clause
#include "BenchmarkTasks.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <numeric>

namespace
{

double now()
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // anonymous namespace

TaskModel::TaskModel(const std::vector<int>& numbersOfThreads)
{
  for (const int number : numbersOfThreads)
  {
    this->threads_.push_back({ number, 0.0 });
  }
}

geodesic::ParallelFor TaskModel::parallelFor()
{
  return [this](std::size_t count, const std::function<void(std::size_t)>& task,
           const std::function<void()>&)
  {
    const double begin = now();
    std::vector<double> seconds(count);
    double last = begin;
    for (std::size_t i = 0; i < count; ++i)
    {
      task(i);
      const double end = now();
      seconds[i] = end - last;
      last = end;
    }
    const double spent = std::accumulate(seconds.begin(), seconds.end(), 0.0);
    this->tasks_ += spent;
    this->deal(std::move(seconds));
    this->overhead_ += now() - begin - spent;
  };
}

void TaskModel::deal(std::vector<double> tasks)
{
  std::sort(tasks.begin(), tasks.end(), std::greater<double>());
  for (Threads& threads : this->threads_)
  {
    std::vector<double> loads(static_cast<std::size_t>(threads.number), 0.0);
    for (const double task : tasks)
    {
      *std::min_element(loads.begin(), loads.end()) += task;
    }
    threads.seconds += *std::max_element(loads.begin(), loads.end());
  }
}

double TaskModel::serialShare(double seconds) const
{
  const double work = seconds - this->overhead_;
  return (work - this->tasks_) / work;
}

std::vector<double> TaskModel::gains(double seconds) const
{
  const double work = seconds - this->overhead_;
  std::vector<double> gains;
  for (const Threads& threads : this->threads_)
  {
    gains.push_back(work / (work - this->tasks_ + threads.seconds));
  }
  return gains;
}
