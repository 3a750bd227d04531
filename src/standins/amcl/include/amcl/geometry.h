#pragma once

#include <workspace_support/grid.h>
#include <workspace_support/planar.h>
#include <workspace_support/scan.h>

namespace amcl
{
using namespace workspace_support;
}  // namespace amcl
