#include "environment/worker_pool.h"

#include <unistd.h>

#include <atomic>
#include <exception>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

namespace f1tenth_sim2d
{
namespace
{
/// One call of run. A worker that comes late finds no task left; the round is gone when the last one has looked.
class Round
{
public:
  Round(std::size_t count, const std::function<void(std::size_t)> & task) : task_(task), left_(count), failures_(count)
  {
  }

  void takeTasks()
  {
    for (std::size_t index = next_++; index < failures_.size(); index = next_++) {
      try {
        task_(index);
      } catch (...) {
        failures_[index] = std::current_exception();
      }
      --left_;
    }
  }

  void finish() const
  {
    while (left_ > 0) {
      std::this_thread::yield();  // To others that have work: at most one task each.
    }
    for (const std::exception_ptr & failure : failures_) {
      if (failure) {
        std::rethrow_exception(failure);
      }
    }
  }

private:
  const std::function<void(std::size_t)> & task_;
  std::atomic<std::size_t> next_{0};
  std::atomic<std::size_t> left_;
  std::vector<std::exception_ptr> failures_;
};
}  // namespace

WorkerPool::WorkerPool(std::size_t threads)
: process_(::getpid()), pool_(std::make_unique<Eigen::ThreadPool>(static_cast<int>(threads) - 1))
{
}

WorkerPool::~WorkerPool()
{
  if (isForked()) {
    // Waiting for threads that are not there would never end.
    static_cast<void>(pool_.release());
  }
}

bool WorkerPool::isForked() const
{
  return pool_->NumThreads() > 0 && ::getpid() != process_;
}

void WorkerPool::run(std::size_t count, const std::function<void(std::size_t)> & task)
{
  if (isForked()) {
    throw std::runtime_error(
      "the environments were made before a fork, which their threads do not survive; make them in the child");
  }
  const auto round = std::make_shared<Round>(count, task);
  for (int worker = 0; worker < pool_->NumThreads(); ++worker) {
    pool_->Schedule([round] { round->takeTasks(); });
  }
  round->takeTasks();
  round->finish();
}
}  // namespace f1tenth_sim2d
