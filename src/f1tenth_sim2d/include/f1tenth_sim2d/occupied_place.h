#pragma once

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
/// A place at which a car would overlap something; the message names it.
class OccupiedPlace : public Error
{
public:
  using Error::Error;
};
}  // namespace f1tenth_sim2d
