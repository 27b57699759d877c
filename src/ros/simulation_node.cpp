#include "simulation_node.hpp"

#include <algorithm>

#include <rigid_body_sim/dynamics/describe_solution.hpp>
#include <rigid_body_sim/scene/build_world.hpp>

#include "state_requests.hpp"

namespace rigid_body_sim {
namespace {

/// Longest wait for a callback [s]: how soon a shutdown is seen.
constexpr double kLongestWait = 0.05;

constexpr std::uint32_t kQueueSize = 100;

/// Given to roscpp [s] to write the last diagnostics: a shutdown drops what is not written yet.
constexpr double kTimeToWrite = 0.2;

Simulation makeSimulation(const Scene& scene) {
  World world = buildWorld(scene);
  State initial = initialState(scene, world);
  return Simulation(std::move(world), std::move(initial));
}

ros::NodeHandle onQueue(const std::string& name_space, ros::CallbackQueue& queue) {
  ros::NodeHandle nh(name_space);
  nh.setCallbackQueue(&queue);
  return nh;
}

TimeOrigin startOf(const NodeOptions& options) {
  if (options.publish_clock) return {ros::Time()};
  const ros::WallTime now = ros::WallTime::now();
  return {ros::Time(now.sec, now.nsec)};
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
      origin_(startOf(options)),
      pacer_(options.real_time_factor),
      paused_(options.start_paused),
      nh_(onQueue("", queue_)),
      private_nh_(onQueue("~", queue_)),
      outputs_(nh_, private_nh_, options, scene, simulation_, origin_),
      monitor_(nh_, private_nh_, scene.world_frame, origin_),
      mouse_(private_nh_, scene, simulation_, origin_, options.wrench_timeout, refusals_),
      doors_(
          nh_, private_nh_, movingBodies(simulation_.world()), origin_,
          [this](const WrenchRequest& request) { return take(request); },
          [this](const std::string& body, const std::string& slot) { return clear(body, slot); }),
      tf_static_(nh_.subscribe("/tf_static", kQueueSize, &StaticFrames::add, &static_frames_)),
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
  if (paused_) return serve(kLongestWait);
  while (!paused_ && ros::ok()) {
    // anew each time: a callback may have set time back
    const double t_next = simulation_.time() + simulation_.world().solver.time_step;
    const double wait = pacer_.wait(t_next, Pacer::Clock::now());
    if (wait <= 0) return;
    serve(std::min(wait, kLongestWait));
  }
}

/// Waits for a callback for that long at most, serves all there are, and reports when that is due.
void SimulationNode::serve(double seconds) {
  queue_.callAvailable(ros::WallDuration(seconds));
  const Monitor::Clock::time_point now = Monitor::Clock::now();
  mouse_.keepAlive(now);
  if (monitor_.isDue(now)) report();
}

void SimulationNode::report() {
  track(monitor_.isHeard());
  RunFigures figures;
  figures.overruns = pacer_.overruns();
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
  pacer_.restart(simulation_.time(), Pacer::Clock::now());
  monitor_.restart(simulation_.time(), Monitor::Clock::now());
}

void SimulationNode::step() {
  const double h = simulation_.world().solver.time_step;
  pacer_.begin(simulation_.time() + h, h, Pacer::Clock::now());
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
  static_frames_.lookUp(request.wrench.frame, frames_);
  static_frames_.lookUp(request.wrench.point_frame, frames_);
  ResolvedWrench resolved =
      takeWrench(request, simulation_.world().bodies, frames_, rules_, simulation_.time());
  try {
    if (resolved.fault.empty()) simulation_.applyWrench(request.slot, resolved.wrench);
  } catch (const std::invalid_argument& error) {
    resolved.fault = error.what();  // the scene's integrator does not accept it
  }
  if (!resolved.fault.empty()) refusals_.add(resolved.fault);
  return resolved.fault;
}

WrenchDoors::Cleared SimulationNode::clear(const std::string& body, const std::string& slot) {
  const std::vector<Body>& bodies = simulation_.world().bodies;
  const std::size_t before = simulation_.wrenchCount();
  if (body.empty() && slot.empty()) simulation_.clearWrenches();
  bool known = body.empty();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (body.empty() ? slot.empty() : bodies[i].name != body) continue;
    known = true;
    if (slot.empty())
      simulation_.clearWrenches(i);
    else
      simulation_.clearWrenches(i, slot);
  }
  if (!known) return {"unknown body '" + body + "'"};
  if (slot.empty()) mouse_.letGo(body);
  return {"", before - simulation_.wrenchCount()};
}

bool SimulationNode::pause(std_srvs::SetBool::Request& request,
                           std_srvs::SetBool::Response& response) {
  if (paused_ && !request.data) {
    pacer_.restart(simulation_.time(), Pacer::Clock::now());
    outputs_.publishDue();
  }
  paused_ = request.data;
  response.success = true;
  response.message = paused_ ? "paused" : "running";
  return true;
}

bool SimulationNode::stepPaused(Step::Request& request, Step::Response& response) {
  response.success = paused_;
  if (!paused_) response.message = "not paused: step moves a paused simulation only";
  try {
    for (std::uint32_t i = 0; response.success && i < request.steps; ++i) {
      advance();
      response.success = ros::ok();
    }
    if (response.success && request.steps > 0) outputs_.publishNow();
    if (!ros::ok()) response.message = "shut down before the last step";
  } catch (const SimulationDiverged& error) {
    // paused: the last finite state waits for a reset
    ROS_FATAL("%s", error.what());
    response.success = false;
    response.message = error.what();
  }
  response.stamp = origin_.stamp(simulation_.time());
  return true;
}

bool SimulationNode::reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  simulation_.reset(options_.reset_time);
  mouse_.letGo("");
  if (options_.reset_time) outputs_.restart();
  outputs_.breakTrails();
  divergence_.clear();
  restartClocks();
  response.success = true;
  response.message =
      options_.reset_time ? "initial states, time at the start" : "initial states, time runs on";
  return true;
}

bool SimulationNode::setState(SetState::Request& request, SetState::Response& response) {
  const RequestedState requested = takeState(request, simulation_.world(), rules_.world_frame);
  if (requested.fault.empty()) {
    simulation_.setState(requested.body, requested.state);
    outputs_.breakTrails();
  }
  response.success = requested.fault.empty();
  response.message = requested.fault;
  return true;
}

bool SimulationNode::getState(GetState::Request& request, GetState::Response& response) {
  response = tellState(request, simulation_.world(), simulation_.state(), rules_.world_frame);
  response.stamp = origin_.stamp(simulation_.time());
  return true;
}

}  // namespace rigid_body_sim
