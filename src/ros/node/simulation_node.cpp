#include "ros/node/simulation_node.hpp"

#include <chrono>
#include <utility>

#include <rigid_body_sim/dynamics/describe_solution.hpp>
#include <rigid_body_sim/scene/build_world.hpp>

#include "ros/mouse/handles.hpp"
#include "ros/node/interfaces.hpp"
#include "ros/outputs/ros_transport.hpp"

namespace rigid_body_sim {
namespace {

using SteadyClock = std::chrono::steady_clock;

/// Given to roscpp [s] to write the last diagnostics: a shutdown drops what is not written yet.
constexpr double kTimeToWrite = 0.2;

/// <body>/wrench and ~wrench are of different types.
void checkNames(const Scene& scene) {
  const std::string any_body = ros::names::resolve("~wrench");
  for (const BodyDef& body : scene.bodies)
    if (ros::names::resolve(body.name + "/wrench") == any_body)
      throw SceneError(scene.source, body.line,
                       "body '" + body.name + "': name must not be that of the node, else " +
                           any_body + " would be two topics");
}

/// The trials of auto may take long.
Simulation makeSimulation(const Scene& scene, StepWatch& watch) {
  checkNames(scene);
  const World world = buildWorld(scene);
  watch.begin(StepWatch::kBeforeTheRun);
  Simulation simulation(world, initialState(scene, world));
  watch.end();
  return simulation;
}

OutputTopics rosTopics(const ros::NodeHandle& nh, const World& world, const NodeOptions& options) {
  RosTransport transport(nh);
  OutputTopics topics = openTopics(transport, world, {options.publish_clock, options.body_topics});
  topics.changes = transport.changes();
  return topics;
}

Topic<Input> inputsTopic(const ros::NodeHandle& nh) {
  constexpr std::uint32_t kASecond = 10000;  // of inputs that wait for a subscriber
  return RosTransport(nh, kASecond).open<Input>("~inputs", false);
}

std::vector<std::string> movingNames(const World& world) {
  std::vector<std::string> names;
  for (const Body& body : world.bodies)
    if (!body.fixed) names.push_back(body.name);
  return names;
}

}  // namespace

SimulationNode::SimulationNode(const NodeOptions& options, const Scene& scene)
    : reset_time_(options.reset_time),
      simulation_(makeSimulation(scene, watch_)),
      paused_(options.start_paused),
      time_(options, queues_.nh, queues_.queue),
      outputs_(rosTopics(queues_.nh, simulation_.world(), options), options, scene, simulation_,
               time_.origin()),
      inputs_(
          inputsTopic(queues_.nh), scene.world_frame, simulation_, time_.origin(),
          options.publish_clock ? 1 / options.clock_rate : 0,
          [this](const SimulationInput& input) { follow(input); }, [this] { prepareForInput(); }),
      monitor_(queues_.nh, queues_.private_nh, scene.world_frame, simulation_, time_.origin()),
      mouse_(simulation_, inputs_, options.wrench_timeout,
             TfFrames(scene, options.tf_prefix).bodies()),
      handles_(queues_.private_nh,
               toHandles(scene, simulation_.world(), TfFrames(scene, options.tf_prefix)),
               [this](const HandleTopics::Feedback& feedback) {
                 if (feedback.event_type == HandleTopics::Feedback::MENU_SELECT)
                   return choose(feedback);
                 refusals_.check("mouse feedback", mouse_.take(feedback));
               }),
      lockstep_(options, scene.time_step),
      interfaces_(queues_.nh, queues_.private_nh, scene, options,
                  {simulation_, inputs_, time_.origin(), refusals_, lockstep_},
                  [this](double t) { return time_.faultOfJump(t, outputs_.lastStamp()); }),
      pause_(queues_.private_nh.advertiseService("pause", &SimulationNode::pause, this)),
      step_(queues_.step_nh.advertiseService("step", &SimulationNode::stepPaused, this)),
      reset_(queues_.private_nh.advertiseService("reset", &SimulationNode::reset, this)),
      real_time_factor_(queues_.private_nh.advertiseService(
          "set_real_time_factor", &SimulationNode::setRealTimeFactor, this)) {
  lockstep_.watchOthers(queues_.nh);
  followBodies();
  for (const std::string& line : describeSolution(simulation_)) ROS_INFO("%s", line.c_str());
  for (const std::string& line : interfaceLines(movingNames(simulation_.world())))
    ROS_INFO("%s", line.c_str());
}

void SimulationNode::run() {
  try {
    time_.startRun();
    restartClocks();
    outputs_.setStanding(paused_);
    if (!paused_) outputs_.publishDue();
    waitInStep();
    while (ros::ok()) {
      serveUntilDue();
      // a pause may have ended just now, in lockstep before the messages have come
      if (!paused_ && !lockstep_.isWaiting() && ros::ok()) goOn();
    }
  } catch (const SimulationDiverged&) {
    ros::WallDuration(kTimeToWrite).sleep();
    throw;
  }
}

/// The time [s] that the next step reaches.
double SimulationNode::nextTime() const {
  const Simulation& shown = rest_of_step_ ? *rest_of_step_ : simulation_;
  return static_cast<double>(shown.steps() + 1) * shown.world().solver.time_step;
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
  outputs_.repeatBodies();
  if (paused_) outputs_.repeatState();
  Health health;
  health.status.overruns = static_cast<std::uint64_t>(time_.overruns());
  health.status.refused = static_cast<std::uint64_t>(refusals_.count());
  health.status.paused = paused_;
  health.status.requested_real_time_factor = time_.realTimeFactor();
  health.divergence = divergence_;
  monitor_.report(std::move(health), SteadyClock::now());
}

/// Ties the wall to simulation time as it is now.
void SimulationNode::restartClocks() {
  time_.restart(outputs_.shownTime());
  monitor_.restart(SteadyClock::now());
}

/// Publishes at the instant that is due within the step, or takes the step.
void SimulationNode::goOn() {
  if (const std::optional<double> t = outputs_.instantWithinStep()) {
    time_.dropBacklog(*t);
    publishWithinStep([&] { outputs_.publishInstant(*t); });
  } else {
    time_.begin(nextTime(), simulation_.world().solver.time_step);
    advance();
  }
}

/// What acts during the step has to be known before anything within it is shown.
void SimulationNode::publishWithinStep(const std::function<void()>& publish) {
  if (!pulled_) refusals_.check("mouse feedback", mouse_.pull());
  pulled_ = true;
  reportingDivergence(publish);
  within_step_ = true;
}

/// One step, and what is to be published within and after it.
void SimulationNode::advance() {
  monitor_.beginWhereAskedFor();
  time_.origin().stamp(nextTime());  // throws where ROS time ends
  if (outputs_.instantWithinStep())
    publishWithinStep([this] { outputs_.publishWithinStep(nextTime()); });
  if (!pulled_) refusals_.check("mouse feedback", mouse_.pull());
  reportingDivergence([this] { (rest_of_step_ ? *rest_of_step_ : simulation_).step(); });
  divergence_.clear();
  outputs_.publishDue();
  endStep();
  waitInStep();
}

void SimulationNode::endStep() {
  leaveStep();
  outputs_.followBodies();
}

/// What was shown of a step is over.
void SimulationNode::leaveStep() {
  within_step_ = pulled_ = false;
  outputs_.watch(simulation_);
  rest_of_step_.reset();
}

/// An input comes. After a state within the next step has been shown it acts from the end of that
/// step on: the step is taken now, and a copy shows the rest of it in its time.
void SimulationNode::prepareForInput() {
  if (!within_step_ || rest_of_step_ || !divergence_.empty()) return;
  Simulation before(simulation_);
  reportingDivergence([this] { simulation_.step(); });
  before.stopTracking();
  outputs_.watch(rest_of_step_.emplace(std::move(before)));
}

/// Reports a divergence before it is thrown on.
void SimulationNode::reportingDivergence(const std::function<void()>& action) {
  watch_.begin(simulation_.time());
  try {
    action();
    watch_.end();
  } catch (const SimulationDiverged& error) {
    watch_.end();
    divergence_ = error.what();
    report();
    throw;
  }
}

/// What else changes with an input that has been applied.
void SimulationNode::follow(const SimulationInput& input) {
  mouse_.follow(input);
  outputs_.takeInput();
  const auto* reset = std::get_if<ResetInput>(&input);
  const bool loads = std::holds_alternative<LoadInput>(input);
  if (reset || loads || std::holds_alternative<StateInput>(input) ||
      std::holds_alternative<PresenceInput>(input))
    outputs_.breakTrails();
  if (reset || loads) divergence_.clear();
  if (loads || (reset && reset->restart_time)) return beginAnew(loads);
  followBodies();
  if (!reset) return;
  if (!rest_of_step_) endStep();
  restartClocks();
}

/// Time has been set, by a state that was loaded or by a reset.
void SimulationNode::beginAnew(bool loads) {
  leaveStep();
  const ros::Time last_stamp = outputs_.lastStamp();
  const double t = simulation_.time();
  if (loads) time_.jumpTo(t, last_stamp, simulation_.world().solver.time_step);
  outputs_.restart(t);
  outputs_.setStanding(false);  // all bodies are published below, not only those that come in
  followBodies();
  lockstep_.restart();
  outputs_.setStanding(paused_);
  restartClocks();
  // a run begins with the state at its start, whether it is due there or not
  if (!paused_) outputs_.publishDue();
  outputs_.publishNow();
  waitInStep();
}

}  // namespace rigid_body_sim
