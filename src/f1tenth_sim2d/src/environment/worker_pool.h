#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace f1tenth_sim2d
{
/// Threads that share out numbered tasks among themselves.
class WorkerPool
{
public:
  /// @param threads  in total, including the one that calls run
  explicit WorkerPool(std::size_t threads);
  WorkerPool(const WorkerPool &) = delete;
  WorkerPool & operator=(const WorkerPool &) = delete;
  ~WorkerPool();

  /// Calls task(0) … task(count - 1), in any order, and waits for all of them.
  /// @throws what a task has thrown: of several, the one with the least number
  void run(std::size_t count, const std::function<void(std::size_t)> & task);

private:
  void work();
  void takeTasks();
  void keep(std::size_t index, std::exception_ptr failure);

  std::mutex mutex_;  ///< guards whatever is written here, except next_
  std::condition_variable begins_;
  std::condition_variable ends_;
  const std::function<void(std::size_t)> * task_{nullptr};
  std::size_t count_{0};
  std::atomic<std::size_t> round_{0};
  std::atomic<std::size_t> busy_{0};  ///< workers that have not finished the round
  std::atomic<std::size_t> next_{0};
  std::size_t failed_{0};
  std::exception_ptr failure_;
  std::atomic<bool> stop_{false};
  std::vector<std::thread> workers_;
};
}  // namespace f1tenth_sim2d
