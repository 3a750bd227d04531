#include "random_sdf.h"

#include <vector>

#include "random_choice.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr int kDeepest = 2;

class SdfWriter
{
public:
  SdfWriter(RandomChoice & random, int minor_version, const TempFolder & folder)
  : random_(random), minor_(minor_version), folder_(folder)
  {
  }

  std::string document(const std::string & inside) const
  {
    return "<sdf version='1." + std::to_string(minor_) + "'>" + inside + "</sdf>";
  }

  std::string world()
  {
    std::string text = "<world name='world_" + std::to_string(minor_) + "'>";
    std::vector<std::string> frames;
    if (minor_ >= 7 && random_.chance(50)) {
      text += frame("corner", {});
      frames.push_back("corner");
    }
    if (random_.chance(30)) {
      const std::string gravity = "<gravity>0 0 -" + random_.number(1, 10) + "</gravity>";
      text += minor_ >= 6 ? gravity : "<physics type='ode'>" + gravity + "</physics>";
    }
    for (int i = random_.below(4) + 1; i > 0; --i) {
      text += random_.chance(30) ? include(frames) : model(newName("model"), frames, 0);
    }
    return text + "</world>";
  }

private:
  std::string newName(const std::string & kind) { return kind + "_" + std::to_string(count_++); }

  /// A <pose>, perhaps in one of these frames.
  std::string pose(const std::vector<std::string> & frames)
  {
    if (random_.chance(20)) {
      return "";
    }
    std::string attributes;
    if (!frames.empty() && random_.chance(40)) {
      attributes = " relative_to='" + random_.of(frames) + "'";
    }
    if (minor_ >= 9 && random_.chance(20)) {
      return "<pose" + attributes + " degrees='true'>" + random_.numbers(3, -5, 5) + " " + random_.numbers(3, -80, 80) +
             "</pose>";
    }
    if (minor_ >= 9 && random_.chance(20)) {
      return "<pose" + attributes + " rotation_format='quat_xyzw'>" + random_.numbers(3, -5, 5) +
             " 0.5 -0.5 0.5 0.5</pose>";
    }
    return "<pose" + attributes + ">" + random_.pose() + "</pose>";
  }

  std::string frame(const std::string & name, const std::vector<std::string> & others)
  {
    const std::string attached =
      !others.empty() && random_.chance(50) ? " attached_to='" + random_.of(others) + "'" : "";
    return "<frame name='" + name + "'" + attached + ">" + pose(others) + "</frame>";
  }

  std::string geometry()
  {
    switch (random_.below(minor_ >= 8 ? 7 : 5)) {
      case 0:
        return "<box><size>" + random_.numbers(3, 0.1, 3) + "</size></box>";
      case 1:
        return "<cylinder><radius>" + random_.number(0.1, 2) + "</radius><length>" + random_.number(0.1, 2) +
               "</length></cylinder>";
      case 2:
        return "<sphere><radius>" + random_.number(0.1, 2) + "</radius></sphere>";
      case 3:
        return "<plane><normal>" + random_.numbers(2, -1, 1) + " 1</normal><size>1 1</size></plane>";
      case 4:
        return "<polyline><point>0 0</point><point>" + random_.number(1, 3) + " 0</point><point>0 " +
               random_.number(1, 3) + "</point><height>" + random_.number(0.1, 2) + "</height></polyline>";
      case 5:
        return "<capsule><radius>" + random_.number(0.1, 2) + "</radius><length>" + random_.number(0.1, 2) +
               "</length></capsule>";
      default:
        return "<ellipsoid><radii>" + random_.numbers(3, 0.1, 2) + "</radii></ellipsoid>";
    }
  }

  std::string collision(const std::vector<std::string> & frames)
  {
    std::string text =
      "<collision name='" + newName("collision") + "'>" + pose(frames) + "<geometry>" + geometry() + "</geometry>";
    if (random_.chance(50)) {
      text += "<surface><friction><ode><mu>" + random_.number(0, 2) +
              "</mu></ode></friction><bounce><restitution_coefficient>" + random_.number(0, 1) +
              "</restitution_coefficient></bounce></surface>";
    }
    return text + "</collision>";
  }

  std::string inertial()
  {
    if (random_.chance(30)) {
      return "";
    }
    const std::string moments = random_.chance(80)
                                  ? "<inertia><ixx>" + random_.number(1, 1.5) + "</ixx><iyy>" + random_.number(1, 1.5) +
                                      "</iyy><izz>" + random_.number(1, 1.5) + "</izz><ixy>" +
                                      random_.number(-0.1, 0.1) + "</ixy><ixz>" + random_.number(-0.1, 0.1) +
                                      "</ixz><iyz>" + random_.number(-0.1, 0.1) + "</iyz></inertia>"
                                  : "";
    return "<inertial>" + pose({}) + "<mass>" + random_.number(0.1, 20) + "</mass>" + moments + "</inertial>";
  }

  std::string link(const std::string & name, const std::vector<std::string> & frames)
  {
    std::string text = "<link name='" + name + "'>" + pose(frames) + inertial();
    for (int i = random_.below(3); i > 0; --i) {
      text += collision(frames);
    }
    if (random_.chance(20)) {
      text += "<visual name='" + newName("visual") + "'><geometry>" + geometry() + "</geometry></visual>";
    }
    if (random_.chance(20)) {
      text += "<sensor name='" + newName("sensor") + "' type='" + random_.of({"contact", "imu", "camera"}) + "'>" +
              pose(frames) + "<update_rate>10</update_rate></sensor>";
    }
    return text + "</link>";
  }

  std::string joint(const std::string & parent, const std::string & child, const std::vector<std::string> & frames)
  {
    const std::string type = random_.of({"revolute", "prismatic", "fixed"});
    std::string axis;
    if (type != "fixed") {
      const std::string in_model =
        minor_ >= 5 && minor_ <= 6 && random_.chance(50) ? "<use_parent_model_frame>1</use_parent_model_frame>" : "";
      const std::string expressed = minor_ >= 7 && random_.chance(40) ? " expressed_in='__model__'" : "";
      axis = "<axis>" + in_model + "<xyz" + expressed + ">" + random_.numbers(2, -1, 1) + " 1</xyz><limit><lower>-" +
             random_.number(0, 2) + "</lower><upper>" + random_.number(0, 2) + "</upper><effort>" +
             random_.number(1, 9) + "</effort></limit></axis>";
    }
    return "<joint name='" + newName("joint") + "' type='" + type + "'>" + pose(frames) + "<parent>" + parent +
           "</parent><child>" + child + "</child>" + axis + "</joint>";
  }

  /// @param frames  of the model or world around it
  std::string model(const std::string & name, const std::vector<std::string> & frames, int depth)
  {
    std::string text = "<model name='" + name + "'>" + pose(frames) +
                       (random_.chance(50) ? "<static>" + random_.of({"1", "true", "0", "false"}) + "</static>" : "");
    std::vector<std::string> links;
    for (int i = random_.below(3) + 1; i > 0; --i) {
      links.push_back(newName("link"));
    }
    std::vector<std::string> known;
    if (minor_ >= 7) {
      known.push_back("__model__");
      if (random_.chance(40)) {
        text += frame("f", {"__model__"});
        known.push_back("f");
      }
    }
    for (const std::string & each : links) {
      text += link(each, known);
      if (minor_ >= 7) {
        known.push_back(each);
      }
    }
    for (std::size_t i = 1; i < links.size(); ++i) {
      text += joint(links[i - 1], links[i], {});
    }
    if (minor_ >= 8 && depth < kDeepest && random_.chance(30)) {
      text += model(newName("inner"), known, depth + 1);
    }
    if (minor_ >= 8 && depth < kDeepest && random_.chance(15)) {
      text += include(known);
    }
    if (random_.chance(20)) {
      text += "<plugin name='" + newName("plugin") + "' filename='libthing.so'><a>1</a></plugin>";
    }
    return text + "</model>";
  }

  std::string include(const std::vector<std::string> & frames)
  {
    const std::string name = newName("thing");
    folder_.write("models/" + name + "/model.config", "<model><sdf version='1.4'>model.sdf</sdf></model>");
    SdfWriter inner(random_, random_.below(7) + 3, folder_);
    inner.count_ = count_ + 100;
    folder_.write("models/" + name + "/model.sdf", inner.document(inner.model(name, {}, kDeepest)));
    std::string text =
      "<include><uri>model://" + name + "</uri>" + (random_.chance(50) ? "<name>" + newName("called") + "</name>" : "");
    if (random_.chance(60)) {
      text += "<pose" +
              (!frames.empty() && random_.chance(40) ? " relative_to='" + random_.of(frames) + "'" : std::string()) +
              ">" + random_.pose() + "</pose>";
    }
    return text + (random_.chance(30) ? "<static>true</static>" : "") + "</include>";
  }

  RandomChoice & random_;
  int minor_;
  const TempFolder & folder_;
  int count_{0};
};
}  // namespace

std::string writeRandomWorld(std::uint32_t seed, const TempFolder & folder)
{
  RandomChoice random(seed);
  SdfWriter writer(random, random.below(7) + 3, folder);
  return folder.write("worlds/test.world", writer.document(writer.world()));
}
}  // namespace f1tenth_sim2d
