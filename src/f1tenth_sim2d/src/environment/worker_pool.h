#pragma once

#include <cstddef>
#include <functional>
#include <memory>
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
  explicit WorkerPool(std::size_t threads);
  ~WorkerPool();
  WorkerPool(const WorkerPool &) = delete;
  WorkerPool & operator=(const WorkerPool &) = delete;

  /// Calls task(0) … task(count - 1), in any order, and waits for all of them.
  /// @throws what a task has thrown: of several, the one with the least number; std::runtime_error in a process that
  ///         was forked off, which has none of the threads
  void run(std::size_t count, const std::function<void(std::size_t)> & task);

private:
  bool isForked() const;

  int process_;
  std::unique_ptr<Eigen::ThreadPool> pool_;
};
}  // namespace f1tenth_sim2d
