#include "loaders/car/urdf_extras.h"

#include <cmath>
#include <optional>

#include "loaders/files/xml_text.h"

namespace f1tenth_sim2d
{
namespace
{
using Interface = TransmissionDescription::Interface;

/// "hardware_interface/VelocityJointInterface", with or without the package in front.
std::optional<Interface> interfaceCalled(const std::string & name)
{
  const std::string plain = name.substr(name.find_last_of('/') + 1);
  if (plain == "EffortJointInterface") {
    return Interface::kEffort;
  }
  if (plain == "VelocityJointInterface") {
    return Interface::kVelocity;
  }
  if (plain == "PositionJointInterface") {
    return Interface::kPosition;
  }
  return std::nullopt;
}

void appendInterfaces(
  const tinyxml2::XMLElement * parent, const std::string & place, std::vector<Interface> & interfaces,
  WarningCollector & warnings)
{
  for (auto tag = parent ? parent->FirstChildElement("hardwareInterface") : nullptr; tag;
       tag = tag->NextSiblingElement("hardwareInterface")) {
    if (const auto interface = interfaceCalled(textOf(tag))) {
      interfaces.push_back(*interface);
    } else {
      warnings.add("the <hardwareInterface> '" + textOf(tag) + "' is left out", place);
    }
  }
}

double reductionOf(const tinyxml2::XMLElement * actuator, const std::string & place, WarningCollector & warnings)
{
  const tinyxml2::XMLElement * const tag = actuator ? actuator->FirstChildElement("mechanicalReduction") : nullptr;
  double reduction = 1.0;
  if (
    tag &&
    (tag->QueryDoubleText(&reduction) != tinyxml2::XML_SUCCESS || !std::isfinite(reduction) || reduction == 0.0)) {
    warnings.add("the <mechanicalReduction> '" + textOf(tag) + "' is taken as 1", place);
    return 1.0;
  }
  return reduction;
}

void appendTransmission(
  const tinyxml2::XMLElement & tag, std::vector<TransmissionDescription> & transmissions, WarningCollector & warnings)
{
  const std::string place = "robot/transmission[" + nameOf(&tag) + "]";
  const char * const attribute = tag.Attribute("type");
  const std::string type = attribute ? attribute : textOf(tag.FirstChildElement("type"));
  if (type.substr(type.find_last_of('/') + 1) != "SimpleTransmission") {
    warnings.add("a transmission of type '" + type + "' is left out: simulated is SimpleTransmission", place);
    return;
  }
  const tinyxml2::XMLElement * const joint = tag.FirstChildElement("joint");
  const tinyxml2::XMLElement * const actuator = tag.FirstChildElement("actuator");
  TransmissionDescription transmission;
  transmission.name = nameOf(&tag);
  transmission.joint = nameOf(joint);
  appendInterfaces(joint, place, transmission.interfaces, warnings);
  if (transmission.interfaces.empty()) {  // where it stood before ROS Indigo, and still does in many a car
    appendInterfaces(actuator, place, transmission.interfaces, warnings);
  }
  transmission.mechanical_reduction = reductionOf(actuator, place, warnings);
  transmissions.push_back(std::move(transmission));
}

void appendPlugins(
  const tinyxml2::XMLElement & parent, std::map<std::string, std::map<std::string, std::string>> & plugins)
{
  for (auto child = parent.FirstChildElement(); child; child = child->NextSiblingElement()) {
    if (std::string(child->Name()) == "plugin") {
      for (auto tag = child->FirstChildElement(); tag; tag = tag->NextSiblingElement()) {
        plugins[nameOf(child)].try_emplace(tag->Name(), textOf(tag));
      }
    } else if (std::string(child->Name()) == "sensor") {
      appendPlugins(*child, plugins);
    }
  }
}
}  // namespace

std::vector<TransmissionDescription> readTransmissions(const tinyxml2::XMLElement & robot, WarningCollector & warnings)
{
  std::vector<TransmissionDescription> transmissions;
  for (auto tag = robot.FirstChildElement("transmission"); tag; tag = tag->NextSiblingElement("transmission")) {
    appendTransmission(*tag, transmissions, warnings);
  }
  return transmissions;
}

std::map<std::string, std::map<std::string, std::string>> readPluginTags(const tinyxml2::XMLElement & robot)
{
  std::map<std::string, std::map<std::string, std::string>> plugins;
  for (auto tag = robot.FirstChildElement("gazebo"); tag; tag = tag->NextSiblingElement("gazebo")) {
    appendPlugins(*tag, plugins);
  }
  return plugins;
}
}  // namespace f1tenth_sim2d
