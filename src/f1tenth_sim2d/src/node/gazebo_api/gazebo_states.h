#pragma once

#include <gazebo_msgs/LinkStates.h>
#include <gazebo_msgs/ModelStates.h>

#include <vector>

#include "node/gazebo_api/gazebo_entities.h"
#include "node/messages/conversions.h"
#include "node/messages/output.h"

namespace f1tenth_sim2d
{
/// `/gazebo/model_states` or `/gazebo/link_states`.
template <class Message>
class EntityStatesOutput : public MessageOutput<Message>
{
public:
  using List = std::vector<Entity> (*)(const Simulation &);

  EntityStatesOutput(ros::Publisher publisher, const Simulation & simulation, List list)
  : MessageOutput<Message>(std::move(publisher), kRate), simulation_(simulation), list_(list)
  {
  }

private:
  static constexpr double kRate = 50.0;  // Hz

  void fill(Message & message, SimTime /*now*/) override
  {
    message.name.clear();
    message.pose.clear();
    message.twist.clear();
    for (const auto & entity : list_(simulation_)) {
      message.name.push_back(entity.name);
      message.pose.push_back(toPose(entity.pose));
      message.twist.push_back(twistOf(entity));
    }
  }

  const Simulation & simulation_;
  const List list_;
};
}  // namespace f1tenth_sim2d
