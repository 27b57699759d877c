#include "ros/inputs/input_interfaces.hpp"

#include <utility>

#include "ros/messages/tf_frames.hpp"

namespace rigid_body_sim {

InputInterfaces::InputInterfaces(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh,
                                 const Scene& scene, const NodeOptions& options,
                                 const InputContext& context, StateFiles::FaultOfTime fault_of_time)
    : wrenches_(nh, private_nh, scene, context, options),
      commands_(nh, context, options),
      wind_(private_nh, scene.world_frame, context),
      mass_(private_nh, context),
      presence_(private_nh, scene.world_frame, TfFrames(scene, options.tf_prefix).bodies(),
                context),
      states_(private_nh, scene.world_frame, TfFrames(scene, options.tf_prefix).bodies(),
              context.simulation, context.inputs),
      state_files_(private_nh, context.simulation, context.inputs, std::move(fault_of_time),
                   filesOfScene(scene.source, scene.files)) {}

}  // namespace rigid_body_sim
