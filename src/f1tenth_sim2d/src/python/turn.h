#pragma once

#include <atomic>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace f1tenth_sim2d
{
/// Lets one thread at a time use an object; another one that comes meanwhile is refused, not kept waiting.
class Turn
{
public:
  /// @throws std::runtime_error if another thread has its turn (RuntimeError in Python)
  explicit Turn(std::atomic_flag & taken) : taken_(taken)
  {
    if (taken.test_and_set(std::memory_order_acquire)) {
      throw std::runtime_error(
        "another thread is using this simulation: one thread at a time may call it (use one simulation per thread, or "
        "a lock)");
    }
  }
  Turn(const Turn &) = delete;
  Turn & operator=(const Turn &) = delete;
  ~Turn() { taken_.clear(std::memory_order_release); }

private:
  std::atomic_flag & taken_;
};

/// A method of a class or its base as a function that takes the object's turn while it runs, and copies what it returns.
template <typename Object, typename Base, typename Result, typename... Arguments>
auto inTurn(Result (Base::*method)(Arguments...))
{
  return [method](Object & object, Arguments... arguments) -> std::decay_t<Result> {
    const Turn turn(object.taken());
    return (object.*method)(std::forward<Arguments>(arguments)...);
  };
}
template <typename Object, typename Base, typename Result, typename... Arguments>
auto inTurn(Result (Base::*method)(Arguments...) const)
{
  return [method](Object & object, Arguments... arguments) -> std::decay_t<Result> {
    const Turn turn(object.taken());
    return (object.*method)(std::forward<Arguments>(arguments)...);
  };
}
}  // namespace f1tenth_sim2d
