#include "loaders/car/transmissions.h"

#include <cmath>

#include "loaders/xml/xml_text.h"

namespace f1tenth_sim2d
{
namespace
{
using Interface = TransmissionDescription::Interface;

std::string withoutPackage(const std::string & name)
{
  return name.substr(name.find_last_of('/') + 1);
}

/// "hardware_interface/VelocityJointInterface", with or without the package in front.
std::optional<Interface> interfaceCalled(const std::string & name)
{
  const std::string plain = withoutPackage(name);
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

void appendInterfaces(const Element & parent, std::vector<Interface> & interfaces, WarningCollector & warnings)
{
  for (const Element & tag : parent.children("hardwareInterface")) {
    if (const auto interface = interfaceCalled(tag.text())) {
      interfaces.push_back(*interface);
    } else {
      warnings.add("the <hardwareInterface> '" + tag.text() + "' is left out", tag.fileLine());
    }
  }
}

double reductionOf(const Element & actuator, WarningCollector & warnings)
{
  const Element tag = actuator.child("mechanicalReduction");
  const std::optional<double> reduction = tag ? numberIn(tag.text()) : 1.0;
  if (!reduction || !std::isfinite(*reduction) || *reduction == 0.0) {
    warnings.add("the <mechanicalReduction> '" + tag.text() + "' is taken as 1", tag.fileLine());
    return 1.0;
  }
  return *reduction;
}
}  // namespace

std::optional<TransmissionDescription> readTransmission(const Element & element, WarningCollector & warnings)
{
  const std::string type = element.has("type") ? element.attribute("type") : element.child("type").text();
  if (withoutPackage(type) != "SimpleTransmission") {
    warnings.add(
      "a transmission of type '" + type + "' is left out: simulated is SimpleTransmission", element.fileLine());
    return std::nullopt;
  }
  const Element joint = element.child("joint");
  const Element actuator = element.child("actuator");
  TransmissionDescription transmission;
  transmission.name = element.name();
  transmission.joint = joint.name();
  appendInterfaces(joint, transmission.interfaces, warnings);
  if (transmission.interfaces.empty()) {  // where it stood before ROS Indigo, and still does in many a car
    appendInterfaces(actuator, transmission.interfaces, warnings);
  }
  transmission.mechanical_reduction = reductionOf(actuator, warnings);
  return transmission;
}
}  // namespace f1tenth_sim2d
