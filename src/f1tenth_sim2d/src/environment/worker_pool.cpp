#include "environment/worker_pool.h"

#include <chrono>
#include <utility>

namespace f1tenth_sim2d
{
namespace
{
/// Steps follow each other closely, and waking a thread costs up to 0.1 ms on virtual processors.
constexpr std::chrono::microseconds kAwake{200};

/// Busy-waits for a condition, but not for long.
template <typename Condition>
void watch(const Condition & condition)
{
  const auto end = std::chrono::steady_clock::now() + kAwake;
  while (!condition() && std::chrono::steady_clock::now() < end) {
    std::this_thread::yield();  // To others that have work.
  }
}
}  // namespace

WorkerPool::WorkerPool(std::size_t threads)
{
  for (std::size_t i = 1; i < threads; ++i) {
    workers_.emplace_back([this] { work(); });
  }
}

WorkerPool::~WorkerPool()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = true;
  }
  begins_.notify_all();
  for (std::thread & worker : workers_) {
    worker.join();
  }
}

void WorkerPool::run(std::size_t count, const std::function<void(std::size_t)> & task)
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    task_ = &task;
    count_ = count;
    next_ = 0;
    failure_ = nullptr;
    busy_ = workers_.size();
    ++round_;
  }
  begins_.notify_all();
  takeTasks();
  const auto is_over = [this] { return busy_ == 0; };
  watch(is_over);
  std::unique_lock<std::mutex> lock(mutex_);
  ends_.wait(lock, is_over);
  if (failure_) {
    std::rethrow_exception(std::exchange(failure_, nullptr));
  }
}

void WorkerPool::work()
{
  std::size_t done = 0;
  const auto has_work = [&] { return stop_ || round_ != done; };
  while (true) {
    watch(has_work);
    std::unique_lock<std::mutex> lock(mutex_);
    begins_.wait(lock, has_work);
    if (stop_) {
      return;
    }
    done = round_;
    lock.unlock();
    takeTasks();
    lock.lock();
    if (--busy_ == 0) {
      ends_.notify_one();
    }
  }
}

void WorkerPool::takeTasks()
{
  for (std::size_t index = next_++; index < count_; index = next_++) {
    try {
      (*task_)(index);
    } catch (...) {
      keep(index, std::current_exception());
    }
  }
}

void WorkerPool::keep(std::size_t index, std::exception_ptr failure)
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!failure_ || index < failed_) {
    failed_ = index;
    failure_ = std::move(failure);
  }
}
}  // namespace f1tenth_sim2d
