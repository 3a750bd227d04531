#include "random_urdf.h"

#include "random_choice.h"

namespace f1tenth_sim2d
{
namespace
{
class UrdfWriter
{
public:
  explicit UrdfWriter(std::uint32_t seed) : random_(seed) {}

  std::string robot()
  {
    std::string text = "<robot name='robot'>";
    const int count = random_.below(8) + 1;
    for (int i = 0; i < count; ++i) {
      text += link(i) + extensions("link_" + std::to_string(i));
    }
    for (int i = 1; i < count; ++i) {
      text += joint(i, random_.below(i));
    }
    if (random_.chance(50)) {
      text += "<gazebo><plugin name='p' filename='libp.so'><bodyName>link_0</bodyName></plugin></gazebo>";
    }
    if (random_.chance(20)) {
      text += "<gazebo><static>true</static></gazebo>";
    }
    return text + "</robot>";
  }

private:
  std::string origin()
  {
    return random_.chance(70) ? "<origin xyz='" + random_.numbers(3, -2, 2) + "' rpy='" + random_.number(-3, 3) + " " +
                                  random_.number(-1.4, 1.4) + " " + random_.number(-3, 3) + "'/>"
                              : "";
  }

  std::string geometry()
  {
    switch (random_.below(3)) {
      case 0:
        return "<box size='" + random_.numbers(3, 0.1, 2) + "'/>";
      case 1:
        return "<cylinder radius='" + random_.number(0.1, 1) + "' length='" + random_.number(0.1, 1) + "'/>";
      default:
        return "<sphere radius='" + random_.number(0.1, 1) + "'/>";
    }
  }

  std::string link(int index)
  {
    std::string text = "<link name='link_" + std::to_string(index) + "'>";
    // Gazebo leaves out a link without mass; if it has a collision, we refuse it. The first one would take all with it.
    if (index > 0 && random_.chance(20)) {
      return text + "</link>";
    }
    text += "<inertial>" + origin() + "<mass value='" + random_.number(0.1, 5) + "'/><inertia ixx='" +
            random_.number(1, 1.5) + "' iyy='" + random_.number(1, 1.5) + "' izz='" + random_.number(1, 1.5) +
            "' ixy='" + random_.number(-0.1, 0.1) + "' ixz='" + random_.number(-0.1, 0.1) + "' iyz='" +
            random_.number(-0.1, 0.1) + "'/></inertial>";
    for (int i = random_.below(3); i > 0; --i) {
      const std::string name =
        random_.chance(30) ? " name='own_" + std::to_string(index) + std::to_string(i) + "'" : "";
      text += "<collision" + name + ">" + origin() + "<geometry>" + geometry() + "</geometry></collision>";
    }
    return text + "</link>";
  }

  std::string extensions(const std::string & link)
  {
    std::string text;
    if (random_.chance(50)) {
      text += "<gazebo reference='" + link + "'><mu1>" + random_.number(0, 2) + "</mu1><mu2 value='1'/><kp>1000</kp>" +
              "<material>Gazebo/Red</material><selfCollide>true</selfCollide></gazebo>";
    }
    if (random_.chance(20)) {
      text += "<gazebo reference='" + link + "'><collision><surface><friction><ode><mu>" + random_.number(0, 2) +
              "</mu></ode></friction></surface></collision></gazebo>";
    }
    if (random_.chance(30)) {
      text += "<gazebo reference='" + link + "'><sensor name='sensor_of_" + link + "' type='camera'>" +
              (random_.chance(50) ? "<pose>" + random_.pose() + "</pose>" : "") +
              "<update_rate>10</update_rate></sensor></gazebo>";
    }
    return text;
  }

  std::string joint(int child, int parent)
  {
    const std::string type = random_.of({"fixed", "fixed", "continuous", "revolute", "prismatic"});
    const std::string name = "joint_" + std::to_string((child * 7) % 11) + "_" + std::to_string(child);
    std::string text = "<joint name='" + name + "' type='" + type + "'>" + origin() + "<parent link='link_" +
                       std::to_string(parent) + "'/><child link='link_" + std::to_string(child) + "'/>";
    if (type != "fixed") {
      text += (random_.chance(80) ? "<axis xyz='" + random_.numbers(2, -1, 1) + " 1'/>" : "") +
              std::string("<limit lower='-") + random_.number(0.1, 2) + "' upper='" + random_.number(0.1, 2) +
              "' effort='" + random_.number(1, 5) + "' velocity='" + random_.number(1, 5) + "'/>";
    }
    text += "</joint>";
    if (type == "fixed" && random_.chance(30)) {
      const std::string tag = random_.of({"preserveFixedJoint", "disableFixedJointLumping"});
      text += "<gazebo reference='" + name + "'><" + tag + ">true</" + tag + "></gazebo>";
    }
    return text;
  }

  RandomChoice random_;
};
}  // namespace

std::string randomUrdf(std::uint32_t seed)
{
  return UrdfWriter(seed).robot();
}
}  // namespace f1tenth_sim2d
