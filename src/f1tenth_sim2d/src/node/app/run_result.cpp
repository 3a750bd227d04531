#include "node/app/run_result.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "f1tenth_sim2d/errors.h"

namespace f1tenth_sim2d
{
namespace
{
nlohmann::ordered_json toJson(const RunResult & result)
{
  auto strays = nlohmann::ordered_json::array();
  for (const StrayAnswer & each : result.strays) {
    strays.push_back({{"participant", each.participant}, {"period", each.period}, {"time", each.time_sec}});
  }
  return {
    {"reason", result.reason},
    {"error", result.error},
    {"participant", result.participant},
    {"sim_time", result.sim_time_sec},
    {"wall_time", result.wall_time_sec},
    {"periods", result.periods},
    {"trajectory_hash", result.trajectory_hash},
    {"seed", result.seed},
    {"stray_answers", strays},
    {"physics_step", result.physics_step_sec},
    {"world_sha256", result.world_sha256},
    {"cars_sha256", result.cars_sha256},
  };
}

[[noreturn]] void fail(const std::string & file)
{
  throw Error("result_file: cannot write " + file + ": " + std::strerror(errno));
}
}  // namespace

void writeResult(const std::string & file, const RunResult & result)
{
  const std::string temporary = file + ".tmp";
  std::ofstream stream(temporary, std::ios::trunc);
  stream << toJson(result).dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  stream.close();
  if (!stream) {
    fail(temporary);
  }
  if (std::rename(temporary.c_str(), file.c_str()) != 0) {
    fail(file);
  }
}
}  // namespace f1tenth_sim2d
