#pragma once

#include <cstddef>
#include <functional>
#include <unsupported/Eigen/CXX11/ThreadPool>

namespace f1tenth_sim2d
{
/// Threads that share out numbered tasks among themselves: Eigen's pool, whose idle threads look for work for a while
/// before they sleep, as steps follow each other closely. Not OpenMP: what its library synchronizes is invisible to
/// ThreadSanitizer, and after a fork it hangs.
class WorkerPool
{
public:
  /// @param threads  in total, including the one that calls run
  explicit WorkerPool(std::size_t threads) : pool_(static_cast<int>(threads) - 1) {}

  /// Calls task(0) … task(count - 1), in any order, and waits for all of them.
  /// @throws what a task has thrown: of several, the one with the least number
  void run(std::size_t count, const std::function<void(std::size_t)> & task);

private:
  Eigen::ThreadPool pool_;
};
}  // namespace f1tenth_sim2d
