#pragma once

#include <functional>
#include <sdf/Element.hh>
#include <sdf/ParserConfig.hh>
#include <sdf/Root.hh>
#include <string>

#include "sdf_messages.h"
#include "warning_collector.h"

/// Reading SDF and URDF through libsdformat, with its errors turned into LoadErrors.
namespace f1tenth_sim2d
{
/// "world[default]/model[walls]/link[Wall_0]"
std::string elementPath(sdf::ElementPtr element);

/// Settings for reading: elements unknown to SDF are reported instead of being copied in silence.
/// @param find  path for a URI, empty if there is none
sdf::ParserConfig parserConfig(std::function<std::string(const std::string &)> find);

/// Throws the first of errors that is one; elements unknown to SDF become warnings, and so does what was printed.
/// @param file        the file as the user named it
/// @param uri_hint    said after the name of a URI that was not found
/// @throws LoadError
void checkSdfErrors(
  const sdf::Errors & errors, const SdfMessages & messages, const sdf::Root & root, const std::string & file,
  const std::string & uri_hint, WarningCollector & warnings);
}  // namespace f1tenth_sim2d
