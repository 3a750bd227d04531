#include "workspace_support/parameter_reader.h"

#include <gtest/gtest.h>

#include <cmath>

#include "workspace_support/errors.h"

namespace workspace_support
{
namespace
{
using XmlRpc::XmlRpcValue;

XmlRpcValue list(const std::vector<XmlRpcValue> & entries)
{
  XmlRpcValue value;
  value.setSize(static_cast<int>(entries.size()));
  for (std::size_t i = 0; i < entries.size(); ++i) {
    value[static_cast<int>(i)] = entries[i];
  }
  return value;
}

XmlRpcValue someParameters()
{
  XmlRpcValue map;
  map["speed"] = 2.5;
  map["count"] = 7;
  map["whole"] = 4.0;
  map["on"] = true;
  map["frame"] = "odom";
  map["nan"] = NAN;
  map["names"] = list({"a", "b"});
  map["points"] = list({list({1, 2.5}), list({3, 4})});
  map["points_as_text"] = "[[1, 2.5], [3, 4]]";
  map["costmap"]["layer"]["radius"] = 0.3;
  return map;
}

ParameterReader someReader()
{
  return {"/node", someParameters()};
}

std::string refusalOf(const std::function<void()> & action)
{
  try {
    action();
  } catch (const OptionError & error) {
    return error.what();
  }
  return "not refused";
}

template <class Value, class... Rule>
std::string refusal(const std::string & name, Value value, const Rule &... rule)
{
  return refusalOf([&] { someReader().read(name, value, rule...); });
}

template <class Value>
Value valueOf(const ParameterNames & names)
{
  Value value{};
  EXPECT_TRUE(someReader().read(names, value));
  return value;
}
}  // namespace

TEST(ParameterReader, ReadsWhatIsThere)
{
  EXPECT_EQ(valueOf<double>("speed"), 2.5);
  EXPECT_EQ(valueOf<double>("count"), 7.0);
  EXPECT_EQ(valueOf<int>("count"), 7);
  EXPECT_EQ(valueOf<int>("whole"), 4);
  EXPECT_TRUE(valueOf<bool>("on"));
  EXPECT_EQ(valueOf<std::string>("frame"), "odom");
  EXPECT_EQ(valueOf<std::optional<double>>("speed"), 2.5);
  EXPECT_EQ(valueOf<std::vector<std::string>>("names"), (std::vector<std::string>{"a", "b"}));
  for (const char * name : {"points", "points_as_text"}) {
    const auto points = valueOf<std::vector<Vec2>>(name);
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(points[0].y, 2.5);
    EXPECT_EQ(points[1].x, 3.0);
  }
}

TEST(ParameterReader, LeavesWhatIsNotThere)
{
  ParameterReader reader = someReader();
  double value = 3.0;
  std::optional<double> limit;
  EXPECT_FALSE(reader.read("absent", value));
  EXPECT_FALSE(reader.read("speed/of/light", value));
  EXPECT_FALSE(reader.read("absent", limit));
  EXPECT_EQ(value, 3.0);
  EXPECT_FALSE(limit);
}

TEST(ParameterReader, TakesTheFirstNameThatIsSet)
{
  EXPECT_EQ(valueOf<double>({"absent", "costmap/layer/radius", "speed"}), 0.3);
}

TEST(ParameterReader, SaysWhatWasFoundAndWhatIsAllowed)
{
  EXPECT_EQ(refusal("frame", 0.0), "parameter /node/frame: found \"odom\", must be a finite number");
  EXPECT_EQ(refusal("nan", 0.0), "parameter /node/nan: found nan, must be a finite number");
  EXPECT_EQ(refusal("speed", 0), "parameter /node/speed: found 2.5, must be a whole number");
  EXPECT_EQ(refusal("count", false), "parameter /node/count: found 7, must be true or false");
  EXPECT_EQ(refusal("on", std::string()), "parameter /node/on: found true, must be a text");
  EXPECT_EQ(refusal("costmap", 0.0), "parameter /node/costmap: found a map, must be a finite number");
  EXPECT_EQ(
    refusal("names", std::vector<Vec2>()),
    "parameter /node/names: found a list, must be a list of points, [[x, y], ...]");
}

TEST(ParameterReader, PointsAreWholePairsOfFiniteNumbers)
{
  XmlRpcValue map;
  map["half"] = "[[0.1, 0.2], [0.3, 0.4], [0.5]]";
  map["four"] = "[[1, 2, 3, 4]]";
  map["flat"] = "1 2 3 4";
  map["open"] = "[[1, 2], [3, 4]";
  map["beyond"] = "[[1, 2], [3, 4]] 5";
  map["nan"] = list({list({0.1, NAN})});
  map["triple"] = list({list({1, 2, 3})});
  for (const auto & entry : map) {
    std::vector<Vec2> points;
    const std::string said = refusalOf([&] { ParameterReader("/node", map).read(entry.first, points); });
    EXPECT_NE(said.find("must be a list of points, [[x, y], ...]"), std::string::npos) << said;
  }
  map["blanks"] = " [ [1 2.5],[-3,4e-1] ] ";
  std::vector<Vec2> points;
  EXPECT_TRUE(ParameterReader("/node", map).read("blanks", points));
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[1].y, 0.4);
}

TEST(ParameterReader, NumbersObeyTheirRule)
{
  EXPECT_EQ(
    refusal("count", 0, atLeast(8, " (or none)")),
    "parameter /node/count: found 7, must be a whole number >= 8 (or none)");
  EXPECT_EQ(refusal("speed", 0.0, positive()), "not refused");
  EXPECT_EQ(positive().range, " > 0");
  EXPECT_FALSE(positive().allows(0.0));
  EXPECT_EQ(within(0.0, 8.0).range, " >= 0 and <= 8");
  EXPECT_TRUE(within(0.0, 8.0).allows(8.0));
  EXPECT_FALSE(within(0.0, 8.0).allows(8.1));
  EXPECT_FALSE(duration().allows(1e10));
}

TEST(ParameterReader, NamesAreDifferentTexts)
{
  XmlRpcValue map;
  map["names"] = list({"a", "a"});
  map["mixed"] = list({"a", 3});
  map["one"] = "a";
  const auto refusalOfNames = [&](const char * key) {
    std::vector<std::string> names;
    return refusalOf([&] { ParameterReader("/node", map).read(key, names); });
  };
  EXPECT_EQ(refusalOfNames("names"), "parameter /node/names[1]: found \"a\" twice, must be a different name");
  EXPECT_EQ(refusalOfNames("mixed"), "parameter /node/mixed[1]: found 3, must be a name");
  EXPECT_EQ(refusalOfNames("one"), "parameter /node/one: found \"a\", must be a list of names");
}

TEST(ParameterReader, PluginsHaveANameAndAType)
{
  XmlRpcValue plugin;
  plugin["name"] = "walls";
  plugin["type"] = "costmap_2d::StaticLayer";
  XmlRpcValue map;
  map["plugins"] = list({plugin});
  map["nameless"] = list({XmlRpcValue("walls")});
  ParameterReader reader("/node", map);
  std::vector<PluginName> plugins;
  EXPECT_TRUE(reader.read("plugins", plugins));
  ASSERT_EQ(plugins.size(), 1u);
  EXPECT_EQ(plugins[0].name, "walls");
  EXPECT_EQ(plugins[0].type, "costmap_2d::StaticLayer");
  EXPECT_EQ(
    refusalOf([&] { reader.read("nameless", plugins); }),
    "parameter /node/nameless: found a list, must be a list of {name: NAME, type: TYPE}");
}

TEST(ParameterReader, AChoiceIsOneOfItsWords)
{
  int value = 0;
  EXPECT_TRUE(someReader().readChoice<int>("frame", value, {{"map", 1}, {"odom", 2}}));
  EXPECT_EQ(value, 2);
  EXPECT_EQ(
    refusalOf([&] {
      someReader().readChoice<int>("frame", value, {{"map", 1}, {"world", 2}});
    }),
    "parameter /node/frame: found \"odom\", must be one of map, world");
}

TEST(ParameterReader, ARequiredTextMustBeThere)
{
  std::string value;
  EXPECT_EQ(
    refusalOf([&] { someReader().readRequired("absent", value); }),
    "parameter /node/absent: not set, must be a text that is not empty");
  someReader().readRequired("frame", value);
  EXPECT_EQ(value, "odom");
}

TEST(ParameterReader, PutsTheFullNameBeforeTheComplaintOfACheck)
{
  const auto complain = [] { throw OptionError("speed: found 2.5, must be below 2"); };
  EXPECT_EQ(refusalOf([&] { someReader().check(complain); }), "parameter /node/speed: found 2.5, must be below 2");
}

TEST(ParameterReader, NamesThePlaceWhereThePlannersParameterIs)
{
  XmlRpcValue map;
  map["planner"]["speed"] = 2.5;
  map["speed_of_others"] = 1.0;
  ParameterReader reader("/node", map);
  double speed = 0.0;
  reader.read({"planner/speed", "speed"}, speed);
  const auto complain = [] { throw OptionError("speed: found 2.5, must be below 2"); };
  EXPECT_EQ(refusalOf([&] { reader.check(complain); }), "parameter /node/planner/speed: found 2.5, must be below 2");
}

TEST(ParameterReader, TellsWhatNobodyHasAskedFor)
{
  ParameterReader reader("/node", XmlRpcValue());
  EXPECT_TRUE(reader.unused().empty());
  XmlRpcValue map;
  map["used"] = 1;
  map["unused"] = 2;
  map["costmap"]["used"] = 3;
  map["costmap"]["unused"] = 4;
  map["whole"]["map"] = 5;
  ParameterReader some("/node", map);
  int value = 0;
  some.read("used", value);
  some.read("costmap/used", value);
  EXPECT_EQ(some.below("whole").keys(), std::vector<std::string>{"map"});
  EXPECT_EQ(some.unused(), (std::vector<std::string>{"costmap/unused", "unused"}));
  EXPECT_EQ(refusalOf([&] { some.refuseUnused(); }), "parameter /node/costmap/unused: unknown; allowed: used");
  some.ignore({"costmap/unused", "not there"});
  EXPECT_EQ(some.unused(), std::vector<std::string>{"unused"});
}

TEST(ParameterReader, RefusesWhatIsUnknownNamingWhatIsAllowed)
{
  XmlRpcValue map;
  map["sped"] = 1.0;
  ParameterReader reader("/node", map);
  double value = 0.0;
  reader.read("speed", value);
  reader.read("acceleration", value);
  EXPECT_EQ(refusalOf([&] { reader.refuseUnused(); }), "parameter /node/sped: unknown; allowed: speed, acceleration");
}

TEST(ParameterReader, RefusesWhatIsNoMap)
{
  EXPECT_EQ(refusalOf([] { ParameterReader("/node", XmlRpcValue(3)); }), "parameter /node: found 3, must be a map");
}
}  // namespace workspace_support
