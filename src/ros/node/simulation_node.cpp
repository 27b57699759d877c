#include "ros/node/simulation_node.hpp"

#include <rigid_body_sim/dynamics/describe_solution.hpp>
#include <rigid_body_sim/scene/build_world.hpp>

#include "ros/inputs/input_messages.hpp"
#include "ros/node/state_requests.hpp"
#include "ros/outputs/ros_transport.hpp"

namespace rigid_body_sim {
namespace {

constexpr std::uint32_t kStaticTfQueue = 100;

/// On a body, acting or to come, beside those of the scene: a sender without end must not fill the
/// memory, nor the time.
constexpr std::size_t kMostWrenches = 1000;

/// Given to roscpp [s] to write the last diagnostics: a shutdown drops what is not written yet.
constexpr double kTimeToWrite = 0.2;

/// <body>/wrench and ~wrench are of different types.
void checkNames(const Scene& scene) {
  const std::string general_door = ros::names::resolve("~wrench");
  for (const BodyDef& body : scene.bodies)
    if (ros::names::resolve(body.name + "/wrench") == general_door)
      throw SceneError(scene.source, body.line,
                       "body '" + body.name + "': name must not be that of the node, else " +
                           general_door + " would be two topics");
}

Simulation makeSimulation(const Scene& scene) {
  checkNames(scene);
  World world = buildWorld(scene);
  State initial = initialState(scene, world);
  return Simulation(std::move(world), std::move(initial));
}

/// How many the scene schedules, body by body.
std::vector<std::size_t> wrenchesOfScene(const World& world) {
  std::vector<std::size_t> counts(world.bodies.size());
  for (const PointWrench& wrench : world.wrenches) ++counts[wrench.body];
  return counts;
}

ros::NodeHandle onQueue(const std::string& name_space, ros::CallbackQueue& queue) {
  ros::NodeHandle nh(name_space);
  nh.setCallbackQueue(&queue);
  return nh;
}

OutputTopics rosTopics(const ros::NodeHandle& nh, const World& world, const NodeOptions& options) {
  RosTransport transport(nh);
  return openTopics(transport, world, options.publish_clock);
}

Topic<Input> inputsTopic(const ros::NodeHandle& nh) {
  constexpr std::uint32_t kASecond = 10000;  // of inputs that wait for a listener
  return RosTransport(nh, kASecond).open<Input>("~inputs", false);
}

std::vector<std::string> movingBodies(const World& world) {
  std::vector<std::string> names;
  for (const Body& body : world.bodies) {
    if (!body.fixed) names.push_back(body.name);
  }
  return names;
}

}  // namespace

SimulationNode::SimulationNode(const NodeOptions& options, const Scene& scene)
    : options_(options),
      simulation_(makeSimulation(scene)),
      frames_(scene, simulation_.world().bodies),
      rules_{scene.world_frame, options.wrench_timeout},
      wrenches_of_scene_(wrenchesOfScene(simulation_.world())),
      paused_(options.start_paused),
      nh_(onQueue("", queue_)),
      private_nh_(onQueue("~", queue_)),
      time_(options, nh_, queue_),
      outputs_(rosTopics(nh_, simulation_.world(), options), options, scene, simulation_,
               time_.origin()),
      inputs_(inputsTopic(nh_), scene.world_frame, simulation_, time_.origin()),
      monitor_(nh_, private_nh_, scene.world_frame, time_.origin()),
      mouse_(private_nh_, scene, simulation_, inputs_, options.wrench_timeout, refusals_),
      doors_(
          nh_, private_nh_, movingBodies(simulation_.world()), time_.origin(),
          [this](const WrenchRequest& request) { return take(request); },
          [this](const std::string& body, const std::string& slot) { return clear(body, slot); }),
      tf_static_(nh_.subscribe("/tf_static", kStaticTfQueue, &StaticFrames::add, &static_frames_)),
      services_{private_nh_.advertiseService("pause", &SimulationNode::pause, this),
                private_nh_.advertiseService("step", &SimulationNode::stepPaused, this),
                private_nh_.advertiseService("reset", &SimulationNode::reset, this),
                private_nh_.advertiseService("set_state", &SimulationNode::setState, this),
                private_nh_.advertiseService("get_state", &SimulationNode::getState, this)} {
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
  if (paused_) return serve(Timekeeper::kLongestWait);
  while (!paused_ && ros::ok()) {
    // anew each time: a callback may have set time back
    const double wait = time_.untilDue(nextTime());
    if (wait <= 0) return;
    serve(wait);
  }
}

/// The time [s] that the next step reaches.
double SimulationNode::nextTime() const {
  return static_cast<double>(simulation_.steps() + 1) * simulation_.world().solver.time_step;
}

/// Waits for a callback for that long at most, serves all there are, starts over with a clock that
/// does, and reports when that is due.
void SimulationNode::serve(double seconds) {
  queue_.callAvailable(ros::WallDuration(seconds));
  if (time_.takeSetBack()) startOver(true);
  const Monitor::Clock::time_point now = Monitor::Clock::now();
  mouse_.keepAlive(now);
  if (monitor_.isDue(now)) report();
}

void SimulationNode::report() {
  track(monitor_.isHeard());
  // not while paused: a viewer that has come since hears of no frame
  if (!paused_) outputs_.repeatBodies();
  RunFigures figures;
  figures.overruns = time_.overruns();
  figures.refused = refusals_.count();
  figures.paused = paused_;
  figures.divergence = divergence_;
  monitor_.report(simulation_, figures, Monitor::Clock::now());
}

/// The balance, and errors with auto, are tracked while somebody listens.
void SimulationNode::track(bool heard) {
  if (heard == tracked_) return;
  tracked_ = heard;
  if (!heard) return simulation_.stopTracking();
  simulation_.trackBalance();
  if (simulation_.world().solver.integrator == "auto") simulation_.trackError();
}

/// Ties the wall to simulation time as it is now.
void SimulationNode::restartClocks() {
  time_.restart(simulation_.time());
  monitor_.restart(simulation_.time(), Monitor::Clock::now());
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

/// One step and what it has to tell. Reports a divergence before it throws it on.
void SimulationNode::advance() {
  mouse_.pull();
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

/// Returns the fault of a request that is refused.
std::string SimulationNode::take(const WrenchRequest& request) {
  const std::string fault = tryToTake(request);
  if (!fault.empty()) refusals_.add("wrench", fault);
  return fault;
}

std::string SimulationNode::tryToTake(const WrenchRequest& request) {
  static_frames_.lookUp(request.wrench.frame, frames_);
  static_frames_.lookUp(request.wrench.point_frame, frames_);
  const ResolvedWrench resolved =
      takeWrench(request, simulation_.world().bodies, frames_, rules_, simulation_.time());
  if (!resolved.fault.empty()) return resolved.fault;
  const std::size_t body = resolved.wrench.body;
  if (simulation_.wrenchCount(body) >= kMostWrenches + wrenches_of_scene_[body] &&
      !simulation_.replaces(request.slot, resolved.wrench))
    return "body '" + request.wrench.body + "' must have less than " +
           std::to_string(kMostWrenches) + " wrenches that act or are to come";
  try {
    inputs_.apply(wrenchInput(request.slot, resolved.wrench, simulation_.world()));
  } catch (const std::invalid_argument& error) {
    return error.what();  // the scene's integrator does not accept it
  }
  return "";
}

WrenchDoors::Cleared SimulationNode::clear(const std::string& body, const std::string& slot) {
  const std::size_t before = simulation_.wrenchCount();
  try {
    inputs_.apply(clearInput(body, slot));
  } catch (const std::invalid_argument& error) {
    return {error.what()};
  }
  if (slot.empty()) mouse_.letGo(body);
  return {"", before - simulation_.wrenchCount()};
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
  const std::int64_t first = simulation_.steps();
  if (!paused_) response.message = "not paused: step moves a paused simulation only";
  try {
    while (response.message.empty() && simulation_.steps() - first < request.steps) {
      if (time_.isAhead(nextTime()))
        response.message = "the next step would pass the clock that this node follows";
      else
        advance();
      if (!ros::ok()) response.message = "shut down before the last step";
    }
    if (simulation_.steps() > first) outputs_.publishNow();
  } catch (const SimulationDiverged& error) {
    // paused: the last finite state waits for a reset
    ROS_FATAL("%s", error.what());
    response.message = error.what();
  }
  response.success = response.message.empty();
  response.stamp = time_.origin().stamp(simulation_.time());
  return true;
}

bool SimulationNode::reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  startOver(options_.reset_time);
  response.success = true;
  response.message =
      options_.reset_time ? "initial states, time at the start" : "initial states, time runs on";
  return true;
}

void SimulationNode::startOver(bool restart_time) {
  Input input;
  input.kind = restart_time ? Input::RESTART : Input::RESET;
  inputs_.apply(input);
  mouse_.letGo("");
  if (restart_time) outputs_.restart();
  outputs_.breakTrails();
  divergence_.clear();
  restartClocks();
  if (restart_time && !paused_) outputs_.publishDue();  // a run begins with the state at its start
}

bool SimulationNode::setState(SetState::Request& request, SetState::Response& response) {
  try {
    inputs_.apply(setStateInput(request));
    outputs_.breakTrails();
    response.success = true;
  } catch (const std::invalid_argument& error) {
    response.message = error.what();
  }
  return true;
}

bool SimulationNode::getState(GetState::Request& request, GetState::Response& response) {
  response = tellState(request, simulation_.world(), simulation_.state(), rules_.world_frame);
  response.stamp = time_.origin().stamp(simulation_.time());
  return true;
}

}  // namespace rigid_body_sim
