#include "node/world/intervention_log.h"

#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
InterventionLog::InterventionLog(const std::string & file) : file_(file)
{
  if (!file_.empty()) {
    stream_.open(file_, std::ios::trunc);
    requireGood();
  }
}

void InterventionLog::add(SimTime time, const Intervention & intervention)
{
  if (file_.empty()) {
    return;
  }
  const nlohmann::ordered_json line{
    {"time", static_cast<double>(time) * 1e-9},
    {"kind", intervention.kind},
    {"caller", intervention.caller},
    {"model", intervention.model},
  };
  stream_ << line.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << std::endl;
  requireGood();
}

void InterventionLog::requireGood() const
{
  if (!stream_) {
    throw Error("interventions: cannot write " + file_ + ": " + std::strerror(errno));
  }
}
}  // namespace f1tenth_sim2d
