#pragma once

#include <optional>

#include "f1tenth_sim2d/car_model.h"
#include "loaders/xml/element.h"
#include "loaders/xml/warning_collector.h"

namespace f1tenth_sim2d
{
/// A <transmission> of a URDF; none, with a warning, for a type that is not simulated. What is not understood of it
/// becomes a warning, too.
std::optional<TransmissionDescription> readTransmission(const Element & element, WarningCollector & warnings);
}  // namespace f1tenth_sim2d
