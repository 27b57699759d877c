#include "ros/node/simulation_node.hpp"

#include <chrono>

#include <rigid_body_sim/dynamics/describe_solution.hpp>
#include <rigid_body_sim/scene/build_world.hpp>

#include "ros/mouse/handles.hpp"
#include "ros/outputs/ros_transport.hpp"

namespace rigid_body_sim {
namespace {

using SteadyClock = std::chrono::steady_clock;

/// Given to roscpp [s] to write the last diagnostics: a shutdown drops what is not written yet.
constexpr double kTimeToWrite = 0.2;

/// While ~step takes many steps, other callbacks are served that often.
constexpr std::chrono::milliseconds kServicePeriod(50);

/// <body>/wrench and ~wrench are of different types.
void checkNames(const Scene& scene) {
  const std::string any_body = ros::names::resolve("~wrench");
  for (const BodyDef& body : scene.bodies)
    if (ros::names::resolve(body.name + "/wrench") == any_body)
      throw SceneError(scene.source, body.line,
                       "body '" + body.name + "': name must not be that of the node, else " +
                           any_body + " would be two topics");
}

Simulation makeSimulation(const Scene& scene) {
  checkNames(scene);
  World world = buildWorld(scene);
  State initial = initialState(scene, world);
  return Simulation(std::move(world), std::move(initial));
}

OutputTopics rosTopics(const ros::NodeHandle& nh, const World& world, const NodeOptions& options) {
  RosTransport transport(nh);
  return openTopics(transport, world, options.publish_clock);
}

Topic<Input> inputsTopic(const ros::NodeHandle& nh) {
  constexpr std::uint32_t kASecond = 10000;  // of inputs that wait for a subscriber
  return RosTransport(nh, kASecond).open<Input>("~inputs", false);
}

}  // namespace

SimulationNode::SimulationNode(const NodeOptions& options, const Scene& scene)
    : reset_time_(options.reset_time),
      simulation_(makeSimulation(scene)),
      paused_(options.start_paused),
      time_(options, queues_.nh, queues_.queue),
      outputs_(rosTopics(queues_.nh, simulation_.world(), options), options, scene, simulation_,
               time_.origin()),
      inputs_(inputsTopic(queues_.nh), scene.world_frame, simulation_, time_.origin(),
              options.publish_clock ? 1 / options.clock_rate : 0,
              [this](const SimulationInput& input) { follow(input); }),
      monitor_(queues_.nh, queues_.private_nh, scene.world_frame, simulation_, time_.origin()),
      mouse_(simulation_, inputs_, options.wrench_timeout),
      handles_(queues_.private_nh, toHandles(scene, simulation_.world()),
               [this](const HandleTopics::Feedback& feedback) {
                 refusals_.check("mouse feedback", mouse_.take(feedback));
               }),
      wrenches_(queues_.nh, queues_.private_nh, scene, simulation_, inputs_, time_.origin(),
                options.wrench_timeout, refusals_),
      states_(queues_.private_nh, scene.world_frame, simulation_, inputs_),
      pause_(queues_.private_nh.advertiseService("pause", &SimulationNode::pause, this)),
      step_(queues_.step_nh.advertiseService("step", &SimulationNode::stepPaused, this)),
      reset_(queues_.private_nh.advertiseService("reset", &SimulationNode::reset, this)) {
  for (const std::string& line : describeSolution(simulation_)) ROS_INFO("%s", line.c_str());
}

void SimulationNode::run() {
  restartClocks();
  if (!paused_) outputs_.publishDue();
  while (ros::ok()) {
    serveUntilDue();
    if (!paused_ && ros::ok()) step();
  }
}

/// Serves callbacks until the next step is due; while paused, for a moment.
void SimulationNode::serveUntilDue() {
  serve(0);
  queues_.step_queue.callAvailable();
  if (paused_) return serve(Timekeeper::kLongestWait);
  while (!paused_ && ros::ok()) {
    // anew each time: a callback may have set time back
    const double wait = time_.untilDue(nextTime());
    if (wait <= 0) return;
    serve(wait);
    queues_.step_queue.callAvailable();
  }
}

/// The time [s] that the next step reaches.
double SimulationNode::nextTime() const {
  return static_cast<double>(simulation_.steps() + 1) * simulation_.world().solver.time_step;
}

/// Waits for a callback for that long at most, serves all there are but ~step, starts over with a
/// clock that does, and reports when that is due.
void SimulationNode::serve(double seconds) {
  queues_.queue.callAvailable(ros::WallDuration(seconds));
  if (time_.takeSetBack()) inputs_.apply(ResetInput{true});
  const SteadyClock::time_point now = SteadyClock::now();
  handles_.keepAlive(now);
  inputs_.recordHeld(now);
  if (monitor_.isDue(now)) report();
}

void SimulationNode::report() {
  // not while paused: a viewer that has come since hears of no frame
  if (!paused_) outputs_.repeatBodies();
  Health health;
  health.status.overruns = static_cast<std::uint64_t>(time_.overruns());
  health.status.refused = static_cast<std::uint64_t>(refusals_.count());
  health.status.paused = paused_;
  health.divergence = divergence_;
  monitor_.report(std::move(health), SteadyClock::now());
}

/// Ties the wall to simulation time as it is now.
void SimulationNode::restartClocks() {
  time_.restart(simulation_.time());
  monitor_.restart(SteadyClock::now());
}

void SimulationNode::step() {
  time_.begin(nextTime(), simulation_.world().solver.time_step);
  try {
    advance();
  } catch (const SimulationDiverged&) {
    ros::WallDuration(kTimeToWrite).sleep();
    throw;
  }
}

/// One step, and what is to be published after it. Reports a divergence before it throws it on.
void SimulationNode::advance() {
  refusals_.check("mouse feedback", mouse_.pull());
  try {
    simulation_.step();
  } catch (const SimulationDiverged& error) {
    divergence_ = error.what();
    report();
    throw;
  }
  divergence_.clear();
  outputs_.publishDue();
}

/// What else changes with an input that has been applied.
void SimulationNode::follow(const SimulationInput& input) {
  mouse_.follow(input);
  const auto* reset = std::get_if<ResetInput>(&input);
  if (reset || std::holds_alternative<StateInput>(input)) outputs_.breakTrails();
  if (!reset) return;
  divergence_.clear();
  restartClocks();
  if (!reset->restart_time) return;
  outputs_.restart();
  if (!paused_) outputs_.publishDue();  // a run begins with the state at its start
}

bool SimulationNode::pause(std_srvs::SetBool::Request& request,
                           std_srvs::SetBool::Response& response) {
  if (paused_ && !request.data) {
    time_.restart(simulation_.time());
    outputs_.publishDue();
  }
  paused_ = request.data;
  response.success = true;
  response.message = paused_ ? "paused" : "running";
  return true;
}

bool SimulationNode::stepPaused(Step::Request& request, Step::Response& response) {
  std::uint32_t taken = 0;
  SteadyClock::time_point serve_next = SteadyClock::now() + kServicePeriod;
  if (!paused_) response.message = stepFault();
  try {
    while (response.message.empty() && taken < request.steps) {
      response.message = stepFault();
      if (!response.message.empty()) break;
      advance();
      ++taken;
      if (SteadyClock::now() < serve_next) continue;
      serve(0);
      serve_next = SteadyClock::now() + kServicePeriod;
    }
    if (taken > 0) outputs_.publishNow();
  } catch (const SimulationDiverged& error) {
    // paused: the last finite state waits for a reset
    ROS_FATAL("%s", error.what());
    response.message = error.what();
  }
  response.success = response.message.empty();
  if (!response.success && taken > 0)
    response.message +=
        "; " + std::to_string(taken) + " of " + std::to_string(request.steps) + " steps were taken";
  response.stamp = inputs_.stamp();
  return true;
}

/// Why no step may be taken by ~step now; empty if one may.
std::string SimulationNode::stepFault() const {
  if (!ros::ok()) return "the node shuts down";
  if (!paused_) return "not paused: ~step advances a paused simulation only";
  if (time_.isAhead(nextTime())) return "the next step would pass the clock that this node follows";
  return "";
}

bool SimulationNode::reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  inputs_.apply(ResetInput{reset_time_});
  response.success = true;
  response.message =
      reset_time_ ? "initial states, time at the start" : "initial states, time runs on";
  return true;
}

}  // namespace rigid_body_sim
