#include "../src/faulty_inputs/faulty_line.h"

#include <gtest/gtest.h>

#include "../src/faulty_inputs/fault_parameters.h"

namespace f1tenth_scenarios
{
using Numbers = std::vector<int>;

TEST(FaultyLine, PassesOnAtOnceWithoutAFault)
{
  FaultyLine<int> line({{1.0, 2.0, {}}});
  line.take(0.5, 1);
  line.take(0.5, 2);
  EXPECT_EQ(line.release(0.5), (Numbers{1, 2}));
  EXPECT_TRUE(line.release(0.6).empty());
}

TEST(FaultyLine, LosesWhatArrivesDuringAnOutage)
{
  FaultyLine<int> line({{1.0, 2.0, {}}});
  for (const double now : {0.975, 1.0, 1.975, 2.0}) {
    line.take(now, static_cast<int>(1000 * now));
  }
  EXPECT_EQ(line.release(2.0), (Numbers{975, 2000}));
}

TEST(FaultyLine, HoldsBackForTheDelay)
{
  FaultyLine<int> line({{1.0, 2.0, 0.2}});
  line.take(1.0, 1);
  line.take(1.1, 2);
  EXPECT_TRUE(line.release(1.175).empty());
  EXPECT_EQ(line.release(1.2), Numbers{1});
  EXPECT_EQ(line.release(1.3), Numbers{2});
}

TEST(FaultyLine, CatchesUpInOrderWhenTheDelayIsOver)
{
  FaultyLine<int> line({{1.0, 2.0, 0.2}});
  line.take(1.95, 1);
  EXPECT_TRUE(line.release(1.975).empty());
  line.take(2.0, 2);
  EXPECT_EQ(line.release(2.0), (Numbers{1, 2}));
}

XmlRpc::XmlRpcValue fault(const char * input, double at, double until)
{
  XmlRpc::XmlRpcValue value;
  value["input"] = input;
  value["at"] = at;
  value["until"] = until;
  return value;
}

std::string complaint(const XmlRpc::XmlRpcValue & entry)
{
  XmlRpc::XmlRpcValue list;
  list[0] = entry;
  try {
    readFaults(list);
  } catch (const FaultParameterError & error) {
    return error.what();
  }
  return "";
}

TEST(FaultParameters, AreReadByInput)
{
  XmlRpc::XmlRpcValue list;
  list[0] = fault("scan", 1.0, 2.0);
  list[1] = fault("odom", 1.0, 2.0);
  list[1]["delay"] = 1;
  list[2] = fault("scan", 3.0, 4.0);
  auto faults = readFaults(list);
  ASSERT_EQ(faults["scan"].size(), 2U);
  EXPECT_FALSE(faults["scan"][0].delay);
  EXPECT_EQ(faults["scan"][1].until, 4.0);
  EXPECT_EQ(faults["odom"][0].delay, 1.0);
}

TEST(FaultParameters, AreRefusedWithTheirPlace)
{
  XmlRpc::XmlRpcValue text("scan");
  EXPECT_THROW(readFaults(text), FaultParameterError);
  EXPECT_EQ(complaint(text), "~faults[0] must hold input, at, until and, if wanted, delay");
  EXPECT_EQ(complaint(fault("imu", 1.0, 2.0)), "~faults[0]/input is \"imu\", must be odom, scan or tf");
  EXPECT_EQ(complaint(fault("scan", 2.0, 2.0)), "~faults[0]/until must be after at");
  auto wrong = fault("scan", 1.0, 2.0);
  wrong["delay"] = "long";
  EXPECT_EQ(complaint(wrong), "~faults[0]/delay must be a number (s)");
  wrong["input"] = 1;
  EXPECT_EQ(complaint(wrong), "~faults[0]/input must be odom, scan or tf");
}
}  // namespace f1tenth_scenarios
