#pragma once

#include <memory>
#include <utility>

namespace f1tenth_sim2d
{
/// Owns an object of a derived class and is copied with it, by its clone().
template <typename Base>
class Cloned
{
public:
  Cloned(std::unique_ptr<Base> object) : object_(std::move(object)) {}
  Cloned(const Cloned & other) : object_(other.object_->clone()) {}
  Cloned & operator=(const Cloned &) = delete;

  Base * operator->() const { return object_.get(); }

private:
  std::unique_ptr<Base> object_;
};
}  // namespace f1tenth_sim2d
