#include <algorithm>
#include <utility>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "dynamics/contact/buried.hpp"
#include "dynamics/require.hpp"
#include "dynamics/run/check_input.hpp"
#include "dynamics/run/contact_trial.hpp"
#include "dynamics/run/parts.hpp"
#include "dynamics/world_changes.hpp"
#include "dynamics/wrenches/delay.hpp"

namespace rigid_body_sim {
namespace {

std::string divergedMessage(double time, const std::string& body, const std::string& quantity) {
  return "t = " + shortest(time) + " s: body '" + body + "': " + quantity;
}

/// World and state, checked.
Run start(World world, State state) {
  world = withoutChanges(std::move(world));
  checkWorld(world);  // also what rests while a body is absent
  world = withChanges(std::move(world), state.changes);
  checkState(world, state);
  if (state.laws.empty()) requireNoneBuried(world, state.bodies);
  Run run(std::make_shared<const World>(std::move(world)),
          std::make_shared<const State>(std::move(state)));
  if (needsContactTrial(run)) run.boundContact(tryContact(run));
  return run;
}

void requireCount(std::int64_t steps) {
  require(steps >= 0, "a number of steps must be >= 0", Got{static_cast<double>(steps)});
}

}  // namespace

SimulationDiverged::SimulationDiverged(double t, const std::string& b, const std::string& q)
    : std::runtime_error(divergedMessage(t, b, q)), time(t), body(b), quantity(q) {}

Simulation::Simulation(World world, State state)
    : parts_(std::make_unique<Parts>(start(std::move(world), std::move(state)))) {}

Simulation::Simulation(const Simulation& other) : parts_(std::make_unique<Parts>(*other.parts_)) {}
Simulation::Simulation(Simulation&& other) noexcept = default;
Simulation& Simulation::operator=(const Simulation& other) { return *this = Simulation(other); }
Simulation& Simulation::operator=(Simulation&& other) noexcept = default;
Simulation::~Simulation() = default;

const World& Simulation::world() const { return *parts_->run.now().world; }
std::size_t Simulation::worldChanges() const { return parts_->run.now().world_changes; }
double Simulation::time() const { return parts_->run.now().time; }
std::int64_t Simulation::steps() const { return parts_->run.now().steps; }

BodyState Simulation::body(std::size_t body) const {
  const World& world = *parts_->run.now().world;
  if (body >= world.bodies.size()) checkIndex(world, body);
  return parts_->run.body(body);
}

void Simulation::readBodies(std::vector<BodyState>& states) const {
  parts_->run.readBodies(states);
}

std::vector<BodyState> Simulation::bodies() const {
  std::vector<BodyState> states;
  readBodies(states);
  return states;
}

State Simulation::state() const { return parts_->run.state(); }

State Simulation::sample(double t) const {
  checkTimeWithinStep(world(), time(), t);
  return parts_->run.sample(t);
}

std::vector<BodyMotion> Simulation::motions(const std::vector<std::size_t>& bodies,
                                            double t) const {
  checkTimeWithinStep(world(), time(), t);
  for (std::size_t body : bodies) checkIndex(world(), body);
  return parts_->run.motions(bodies, t);
}

void Simulation::step() {
  if (parts_->balance) {
    parts_->run.step(parts_->balance->beginStep());
    parts_->balance->endStep();
  } else {
    parts_->run.step();
  }
  if (parts_->error) parts_->error->follow(parts_->run);
}

void Simulation::step(std::int64_t count) {
  requireCount(count);
  if (!parts_->balance && !parts_->error) return parts_->run.step(count);
  for (std::int64_t k = 0; k < count; ++k) step();
}

void Simulation::step(std::int64_t count, std::vector<BodyState>& states) {
  requireCount(count);
  if (!parts_->balance && !parts_->error) return parts_->run.step(count, &states);
  step(count);
  readBodies(states);
}

void Simulation::apply(const SimulationInput& input) {
  if (const auto* wrench = std::get_if<WrenchInput>(&input)) {
    applyWrench(wrench->slot, wrench->wrench);
  } else if (const auto* clear = std::get_if<ClearInput>(&input)) {
    clearWrenches(clear->body, clear->slot);
  } else if (const auto* state = std::get_if<StateInput>(&input)) {
    checkBody(world(), state->body);
    setState(state->body, toBodyState(world().bodies[state->body], state->motion));
  } else if (const auto* command = std::get_if<CommandInput>(&input)) {
    this->command(command->command);
  } else if (const auto* load = std::get_if<LoadInput>(&input)) {
    this->load(load->state);
  } else if (const auto* wind = std::get_if<WindInput>(&input)) {
    setWind(wind->velocity_W);
  } else if (const auto* mass = std::get_if<MassInput>(&input)) {
    setMassProperties(mass->body, mass->properties_B);
  } else if (const auto* presence = std::get_if<PresenceInput>(&input)) {
    checkIndex(world(), presence->body);
    std::optional<BodyState> entering;
    if (presence->motion) entering = toBodyState(world().bodies[presence->body], *presence->motion);
    setPresent(presence->body, entering);
  } else {
    reset(std::get<ResetInput>(input).restart_time);
  }
}

void Simulation::checkWrenches(const std::vector<WrenchInput>& wrenches) const {
  for (const WrenchInput& input : wrenches) {
    checkWrench(world(), input.wrench);
    if (!HeldWrench::holds(input.wrench))
      parts_->run.requireSupport(kCoupling, world().bodies[input.wrench.body].name);
  }
  if (parts_->wrenches_at_most + wrenches.size() <= kMaxWrenches) return;
  const auto adds = [this](const WrenchInput& input) {
    return !replaces(input.slot, input.wrench);
  };
  const auto added = std::count_if(wrenches.begin(), wrenches.end(), adds);
  if (wrenchCount() + static_cast<std::size_t>(added) > kMaxWrenches)
    throw std::invalid_argument("at most " + std::to_string(kMaxWrenches) +
                                " wrenches may act or be to come");
}

void Simulation::applyWrench(const std::string& slot, const PointWrench& wrench) {
  checkWrenches({{slot, wrench}});
  std::size_t& at_most = parts_->wrenches_at_most;
  if (at_most >= kMaxWrenches) at_most = wrenchCount();
  PointWrench timed = onSteps(wrench, world().solver.time_step);
  delayTo(time(), timed);
  parts_->run.put(slot, timed);
  ++at_most;
  if (parts_->error) parts_->error->put(slot, timed);
}

void Simulation::clearWrenches(std::size_t body, const std::string& slot) {
  const bool every = body == ClearInput::kEveryBody;
  if (!every) checkIndex(world(), body);
  const std::size_t first = every ? 0 : body, end = every ? world().bodies.size() : body + 1;
  bool any = false;
  for (std::size_t i = first; i < end; ++i) any |= parts_->run.clear(i, slot);
  if (any && parts_->error) parts_->error->restart();
}

void Simulation::setState(std::size_t body, const BodyState& state) {
  checkBodyState(world(), body, state);
  requireFiniteEnergy(world().bodies[body], state);
  requireNotBuried(world(), body, state);
  parts_->run.setState(body, state);
  parts_->restartTracking();
}

void Simulation::reset(bool restart_time) {
  parts_->run.reset(restart_time);
  parts_->begin();
}

void Simulation::load(const State& state) {
  if (state.changes == parts_->run.now().changes)
    checkState(world(), state);
  else
    checkState(withChanges(world(), state.changes), state);
  checkFixed(world(), state, *parts_->run.now().start);
  parts_->run.load(state);
  parts_->begin();
}

bool Simulation::replaces(const std::string& slot, const PointWrench& wrench) const {
  checkIndex(world(), wrench.body);
  return !slot.empty() && wrench.start <= time() &&
         parts_->run.now().schedules[wrench.body].holds(slot);
}

std::size_t Simulation::wrenchCount() const {
  std::size_t count = 0;
  for (const WrenchSchedule& schedule : parts_->run.now().schedules) count += schedule.size();
  return count;
}

std::size_t Simulation::wrenchCount(std::size_t body) const {
  checkIndex(world(), body);
  return parts_->run.now().schedules[body].size();
}

const std::vector<PointWrench>& Simulation::activeWrenches(std::size_t body) const {
  checkIndex(world(), body);
  return parts_->run.now().schedules[body].active();
}

std::vector<PointWrench> Simulation::activeWrenches(std::size_t body, double t) const {
  checkIndex(world(), body);
  checkTimeWithinStep(world(), time(), t);
  return parts_->run.now().schedules[body].activeAt(t);
}

const std::vector<ContactEvent>& Simulation::contactEvents() const {
  return parts_->run.contactEvents();
}

Wrench Simulation::appliedWrench(std::size_t body) const {
  Wrench sum;
  std::vector<BodyState> states(3);  // of the body, and of those that axes and point turn with
  states[0] = this->body(body);
  for (PointWrench applied : activeWrenches(body)) {
    const auto place = [&](std::size_t& frame, std::size_t k) {
      if (frame == kWorld) return;
      if (frame != body) states[k] = this->body(frame);
      frame = frame == body ? 0 : k;
    };
    place(applied.axes, 1);
    place(applied.point_frame, 2);
    applied.body = 0;
    addPointWrench(applied, states, sum);
  }
  return sum;
}

std::vector<MotionPlan> Simulation::plans() const {
  std::vector<MotionPlan> plans;
  const RunState& now = parts_->run.now();
  for (std::size_t g = 0; g < now.groups.size(); ++g) plans.push_back(now.planOf(g));
  return plans;
}

ContactTrial Simulation::contactTrial() const { return parts_->run.contactTrial(); }
double Simulation::horizonBegins() const { return parts_->run.now().horizon_begins; }
int Simulation::maxSubsteps() const { return parts_->run.now().groups.maxSubsteps(); }
double Simulation::magnification() const { return parts_->run.now().magnification(); }
std::int64_t Simulation::evaluations() const { return parts_->run.now().evaluations(); }

void Simulation::trackError() { parts_->error.emplace(parts_->run); }

ErrorEstimate Simulation::errorEstimate() const {
  return parts_->error ? parts_->error->estimate() : ErrorEstimate();
}

void Simulation::trackBalance() {
  if (!parts_->balance) parts_->balance.emplace(world(), state());
}

Totals Simulation::balance() const {
  return parts_->balance ? parts_->balance->remainder(world(), state()) : Totals::unknown();
}

Totals Simulation::exchanged() const {
  return parts_->balance ? parts_->balance->exchanged() : Totals::unknown();
}

void Simulation::stopTracking() {
  parts_->error.reset();
  parts_->balance.reset();
}

}  // namespace rigid_body_sim
