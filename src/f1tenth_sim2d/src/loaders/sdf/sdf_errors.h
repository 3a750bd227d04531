#pragma once

#include <sdf/ParserConfig.hh>
#include <sdf/Root.hh>
#include <string>

#include "f1tenth_sim2d/errors.h"
#include "loaders/files/warning_collector.h"
#include "loaders/sdf/sdf_messages.h"

namespace f1tenth_sim2d
{
/// Settings for reading: elements unknown to SDF are reported instead of being copied in silence.
sdf::ParserConfig parserConfig();

/// Calls read(); what libraries throw on their own account, libsdformat for a version that is no number, becomes a
/// LoadError.
template <typename Read>
auto withLoadErrors(const std::string & file, Read read)
{
  try {
    return read();
  } catch (const Error &) {
    throw;
  } catch (const std::exception & error) {
    throw LoadError(file, "", std::string("a library that reads it gives up: ") + error.what());
  }
}

/// Turns what libsdformat reported of reading a document into one LoadError. What can be left out becomes a warning.
/// @param file      the file as the user named it
/// @param uri_hint  said after the name of a URI that was not found
/// @throws LoadError
void checkSdfErrors(
  const sdf::Errors & errors, const SdfMessages & messages, const sdf::Root & root, const std::string & file,
  const std::string & uri_hint, WarningCollector & warnings);
}  // namespace f1tenth_sim2d
