#pragma once

#include <rooms.h>

#include "path/terms.h"

/// The maps of move_base's own tests.
namespace f1tenth_racer::testing
{
using namespace move_base::testing;
}  // namespace f1tenth_racer::testing
