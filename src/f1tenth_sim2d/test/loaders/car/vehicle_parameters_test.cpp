#include "f1tenth_sim2d/vehicle_parameters.h"

#include <gtest/gtest.h>

#include "f1tenth_sim2d/vehicle_keys.h"
#include "temp_folder.h"

namespace f1tenth_sim2d
{
namespace
{
std::string errorOf(const std::string & yaml)
{
  const TempFolder folder;
  const std::string path = folder.write("car.yaml", yaml);
  return withoutFolder(loadErrorOf([&path] { loadVehicleParameters(path); }), folder);
}

TEST(VehicleParameters, ShippedFileHoldsEveryDefault)
{
  const VehicleParameters shipped = loadVehicleParameters(F1TENTH_SIM2D_CONFIG "/f1tenth.yaml");
  const VehicleParameters defaults;
  EXPECT_EQ(shipped.m, defaults.m);
  EXPECT_EQ(shipped.l_f, defaults.l_f);
  EXPECT_EQ(shipped.l_r, defaults.l_r);
  EXPECT_EQ(shipped.h, defaults.h);
  EXPECT_EQ(shipped.I_z, defaults.I_z);
  EXPECT_EQ(shipped.mu, defaults.mu);
  EXPECT_EQ(shipped.C_Sf, defaults.C_Sf);
  EXPECT_EQ(shipped.C_Sr, defaults.C_Sr);
  EXPECT_EQ(shipped.steering_max, defaults.steering_max);
  EXPECT_EQ(shipped.steering_rate_max, defaults.steering_rate_max);
  EXPECT_EQ(shipped.a_max, defaults.a_max);
  EXPECT_EQ(shipped.v_switch, defaults.v_switch);
  EXPECT_EQ(shipped.v_min, defaults.v_min);
  EXPECT_EQ(shipped.v_max, defaults.v_max);
  EXPECT_EQ(shipped.actuation_latency, defaults.actuation_latency);
  EXPECT_EQ(shipped.speed_gain, defaults.speed_gain);
  EXPECT_EQ(shipped.command_timeout, defaults.command_timeout);
  EXPECT_EQ(shipped.model, defaults.model);
  EXPECT_EQ(shipped.R_w, defaults.R_w);
  EXPECT_EQ(shipped.I_y_w, defaults.I_y_w);
  EXPECT_EQ(shipped.T_sb, defaults.T_sb);
  EXPECT_EQ(shipped.T_se, defaults.T_se);
  for (const auto & key : vehicle_keys::kTire) {
    EXPECT_EQ(shipped.tire.*key.member, defaults.tire.*key.member) << key.name;
  }
  EXPECT_EQ(shipped.odometry_rate_hz, defaults.odometry_rate_hz);
  EXPECT_EQ(shipped.odometry_speed_scale, defaults.odometry_speed_scale);
  EXPECT_EQ(shipped.odometry_speed_noise_stddev, defaults.odometry_speed_noise_stddev);
  EXPECT_EQ(shipped.odometry_steering_offset, defaults.odometry_steering_offset);
  EXPECT_EQ(shipped.odometry_steering_noise_stddev, defaults.odometry_steering_noise_stddev);
}

TEST(VehicleParameters, KeysThatAreNotThereKeepTheirDefaults)
{
  const TempFolder folder;
  EXPECT_EQ(loadVehicleParameters(folder.write("empty.yaml", "# nothing\n")).m, 3.74);
  const VehicleParameters parameters = loadVehicleParameters(folder.write("heavy.yaml", "m: 5\nv_min: 0\n"));
  EXPECT_EQ(parameters.m, 5.0);
  EXPECT_EQ(parameters.v_min, 0.0);
  EXPECT_EQ(parameters.l_f, 0.15875);
}

TEST(VehicleParametersErrors, MissingFile)
{
  EXPECT_EQ(
    loadErrorOf([] { loadVehicleParameters("/nowhere/car.yaml"); }),
    "/nowhere/car.yaml: no such file, or it cannot be read");
}

TEST(VehicleParametersErrors, FolderInThePlaceOfTheFile)
{
  const TempFolder folder;
  EXPECT_EQ(
    withoutFolder(loadErrorOf([&folder] { loadVehicleParameters(folder.path() + "/."); }), folder),
    ".: is a folder, not a file");
}

TEST(VehicleParametersErrors, UnknownKeyNamesTheAllowedOnes)
{
  EXPECT_EQ(
    errorOf("m: 3.74\nmass: 4\n"),
    "car.yaml:2: unknown key 'mass', allowed are model, tire, m, l_f, l_r, h, I_z, mu, C_Sf, C_Sr, steering_max, "
    "steering_rate_max, a_max, v_switch, v_min, v_max, actuation_latency, speed_gain, command_timeout, "
    "R_w, I_y_w, T_sb, T_se, odometry_rate_hz, odometry_speed_scale, odometry_speed_noise_stddev, "
    "odometry_steering_offset, odometry_steering_noise_stddev");
}

TEST(VehicleParametersErrors, WrongType)
{
  EXPECT_EQ(errorOf("\nm: heavy\n"), "car.yaml:2: m is 'heavy', allowed are numbers greater than 0");
  EXPECT_EQ(errorOf("m: \"3\"\n"), "car.yaml:1: m is '3', allowed are numbers greater than 0");
  EXPECT_EQ(errorOf("m: [1, 2]\n"), "car.yaml:1: m is no single value, allowed are numbers greater than 0");
  EXPECT_EQ(errorOf("m: true\n"), "car.yaml:1: m is 'true', allowed are numbers greater than 0");
}

TEST(VehicleParametersErrors, OutOfRange)
{
  EXPECT_EQ(errorOf("m: 0\n"), "car.yaml:1: m is 0, allowed are numbers greater than 0");
  EXPECT_EQ(errorOf("m: .nan\n"), "car.yaml:1: m is .nan, allowed are numbers greater than 0");
  EXPECT_EQ(errorOf("v_max: .inf\n"), "car.yaml:1: v_max is .inf, allowed are numbers greater than 0");
  EXPECT_EQ(errorOf("v_min: 1\n"), "car.yaml:1: v_min is 1, allowed are numbers up to 0");
  EXPECT_EQ(
    errorOf("steering_max: 2\n"), "car.yaml:1: steering_max is 2, allowed are numbers greater than 0, up to 1.5 rad");
  EXPECT_EQ(
    errorOf("actuation_latency: -0.1\n"), "car.yaml:1: actuation_latency is -0.1, allowed are numbers from 0 to 1 s");
  EXPECT_EQ(
    errorOf("odometry_rate_hz: 0\n"),
    "car.yaml:1: odometry_rate_hz is 0, allowed are numbers greater than 0, up to 1000 Hz");
  EXPECT_EQ(
    errorOf("odometry_steering_offset: -2\n"),
    "car.yaml:1: odometry_steering_offset is -2, allowed are numbers from -1.5 to 1.5 rad");
  EXPECT_EQ(errorOf("h: -1\n"), "car.yaml:1: h is -1, allowed are numbers from 0");
}

TEST(VehicleParameters, ModelAndTyresAreRead)
{
  const TempFolder folder;
  const VehicleParameters parameters = loadVehicleParameters(
    folder.write("car.yaml", "model: single_track_drift\nR_w: 0.344\ntire:\n  p_ky1: -30\n  r_hx1: 0\n"));
  EXPECT_EQ(parameters.model, VehicleModel::kSingleTrackDrift);
  EXPECT_EQ(parameters.R_w, 0.344);
  EXPECT_EQ(parameters.tire.p_ky1, -30.0);
  EXPECT_EQ(parameters.tire.r_hx1, 0.0);
  EXPECT_EQ(parameters.tire.p_kx1, TireParameters{}.p_kx1);
  EXPECT_EQ(loadVehicleParameters(folder.write("k.yaml", "model: kinematic")).model, VehicleModel::kKinematic);
}

TEST(VehicleParametersErrors, UnknownModel)
{
  EXPECT_EQ(
    errorOf("m: 3\nmodel: drift\n"),
    "car.yaml:2: model is 'drift', allowed are single_track, kinematic, single_track_drift");
  EXPECT_EQ(
    errorOf("model: [1]\n"), "car.yaml:1: model is '', allowed are single_track, kinematic, single_track_drift");
}

TEST(VehicleParametersErrors, WrongTyres)
{
  EXPECT_EQ(errorOf("tire: 3\n"), "car.yaml:1: not a map, allowed are lines 'key: number'");
  EXPECT_EQ(errorOf("tire:\n  p_ky1: 20\n"), "car.yaml:2: p_ky1 is 20, allowed are numbers less than 0");
  EXPECT_EQ(errorOf("tire:\n  p_ex1: 1.5\n"), "car.yaml:2: p_ex1 is 1.5, allowed are numbers up to 1");
  EXPECT_EQ(errorOf("T_se: 1.5\n"), "car.yaml:1: T_se is 1.5, allowed are numbers from 0 to 1");
  const std::string error = errorOf("tire:\n  p_dx3: 0\n");
  EXPECT_EQ(error.substr(0, error.find(" p_dx1")), "car.yaml:2: unknown key 'p_dx3', allowed are p_cx1,");
}

TEST(VehicleParametersErrors, KeyGivenTwice)
{
  EXPECT_EQ(errorOf("m: 1\nmu: 1\nm: 2\n"), "car.yaml:3: m is given twice");
}

TEST(VehicleParametersErrors, NotAMap)
{
  EXPECT_EQ(errorOf("- 1\n- 2\n"), "car.yaml:1: not a map, allowed are lines 'key: number'");
  EXPECT_EQ(errorOf("m: 1\n  - x: [\n"), "car.yaml:2: not YAML: illegal map value");
}
}  // namespace
}  // namespace f1tenth_sim2d
