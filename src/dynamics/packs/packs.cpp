#include "dynamics/packs/packs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dynamics/packs/block_lane.hpp"
#include "dynamics/packs/in_parts.hpp"
#include "dynamics/packs/read_block.hpp"

namespace rigid_body_sim {

namespace {

/// Bodies that are stepped, and read, before the next.
constexpr std::size_t kAtOnce = 64;

/// What takes a thread some 200 us: steps of one body, and states copied.
constexpr std::size_t kLeastSteps = 16384, kLeastCopies = 16384;

/// Whether a step begins with the wrenches that the one before evaluated at its end.
bool leavesWrenchesCurrent(PackKind kind) {
  return kind != PackKind::kSemiImplicitEuler && kind != PackKind::kRk4;
}

}  // namespace

bool hasPackSteps(const Method& method) {
  const auto& all = {semiImplicitEulerStep, strangStep, magnus4Step, rk4Step};
  return std::find(all.begin(), all.end(), method.step) != all.end();
}

/// A torque of −0 would lose its sign where that of no force at all is added to it.
bool hasPackSteps(const HeldWrench& held) {
  const auto isNegativeZero = [](double x) { return x == 0 && std::signbit(x); };
  return held.world_point_forces.empty() && held.body_point_forces.size() <= 1 && !held.drive &&
         !held.medium && !isNegativeZero(held.tau_P.x()) && !isNegativeZero(held.tau_P.y()) &&
         !isNegativeZero(held.tau_P.z());
}

std::optional<PackKind> packKindOf(const SteadyMotion& motion) {
  const StepFunction step = motion.method->step;
  if (step == semiImplicitEulerStep) return PackKind::kSemiImplicitEuler;
  if (step == magnus4Step) return PackKind::kMagnus4;
  if (step == rk4Step) return PackKind::kRk4;
  if (step != strangStep) return std::nullopt;
  const RotationSplit<double>& split = motion.body->split;
  if (split.a == 0 && split.b == 2) return PackKind::kStrang02;
  if (split.a == 2 && split.b == 0) return PackKind::kStrang20;
  if (split.a == 1 && split.b == 2) return PackKind::kStrang12;
  return std::nullopt;
}

std::vector<std::size_t> Packs::bodies() const {
  std::vector<std::size_t> bodies;
  bodies.reserve(size_);
  for (const Shelf& shelf : shelves_)
    bodies.insert(bodies.end(), shelf.bodies.begin(), shelf.bodies.end());
  return bodies;
}

std::vector<std::size_t> Packs::takeOffers() { return std::exchange(offered_, {}); }

Packs::Shelf& Packs::shelfOf(PackKind kind, PackLoad load, const Method& method,
                             std::uint32_t& index) {
  const auto fits = [&](const Shelf& shelf) { return shelf.kind == kind && shelf.load == load; };
  const auto found = std::find_if(shelves_.begin(), shelves_.end(), fits);
  index = static_cast<std::uint32_t>(found - shelves_.begin());
  if (found != shelves_.end()) return *found;
  shelves_.push_back({kind, load, &method, {}, {}, {}, {}});
  return shelves_.back();
}

bool Packs::add(std::size_t body, const SteadyMotion& motion, const BodyState& state,
                double next_event, std::int64_t steps) {
  const std::optional<PackKind> kind = packKindOf(motion);
  if (!kind) return false;
  PackBlock alone = emptyBlock();
  PushBlock push{};
  putBody(motion, *kind, time_step_, state, alone, 0);
  const PackLoad load = putPush(motion, time_step_, push, 0);
  const bool loaded = load != PackLoad::kNone;
  const bool is_certain = isCertain(alone, 0) && staysModest(alone, 0) && staysModest(push, 0) &&
                          slowsSlowly(alone, push, 0);
  if (!is_certain) return false;
  std::uint32_t index = 0;
  Shelf& shelf = shelfOf(*kind, load, *motion.method, index);
  const std::size_t lane = shelf.lanes.size();
  if (lane % PackBlock::kLanes == 0) {
    shelf.blocks.push_back(emptyBlock());
    if (loaded) shelf.pushes.push_back({});
  }
  copyLane(alone, 0, shelf.blocks.back(), lane % PackBlock::kLanes);
  if (loaded) copyLane(push, 0, shelf.pushes.back(), lane % PackBlock::kLanes);
  shelf.bodies.push_back(body);
  shelf.lanes.push_back({steps, motion.wrenches_current, next_event});
  places_[body] = {index, static_cast<std::uint32_t>(lane)};
  new_.push_back(body);
  next_event_ = std::min(next_event_, next_event);
  if (++size_ == 1) certain_steps_ = kCertainSteps;
  return true;
}

/// The last of a shelf takes the place of another.
void Packs::putLast(std::size_t lane, Shelf& shelf) {
  constexpr std::size_t kLanes = PackBlock::kLanes;
  const std::size_t last = (shelf.lanes.size() - 1) % kLanes;
  copyLane(shelf.blocks.back(), last, shelf.blocks[lane / kLanes], lane % kLanes);
  if (!shelf.pushes.empty())
    copyLane(shelf.pushes.back(), last, shelf.pushes[lane / kLanes], lane % kLanes);
  shelf.lanes[lane] = shelf.lanes.back();
  shelf.bodies[lane] = shelf.bodies.back();
  places_[shelf.bodies[lane]].lane = static_cast<std::uint32_t>(lane);
}

void Packs::remove(std::size_t body) {
  const Place place = std::exchange(places_[body], Place());
  Shelf& shelf = shelves_[place.shelf];
  if (place.lane + 1 != shelf.lanes.size()) putLast(place.lane, shelf);
  shelf.lanes.pop_back();
  shelf.bodies.pop_back();
  const std::size_t last_lane = shelf.lanes.size() % PackBlock::kLanes;
  if (last_lane == 0) {
    shelf.blocks.pop_back();
    if (!shelf.pushes.empty()) shelf.pushes.pop_back();
  } else {
    copyLane(emptyBlock(), 0, shelf.blocks.back(), last_lane);
    if (!shelf.pushes.empty()) copyLane(PushBlock{}, 0, shelf.pushes.back(), last_lane);
  }
  --size_;
}

BodyState Packs::state(std::size_t body) const {
  const Place place = places_[body];
  return bodyIn(shelves_[place.shelf].blocks[place.lane / PackBlock::kLanes],
                place.lane % PackBlock::kLanes);
}

void Packs::copyLanes(const Shelf& shelf, std::size_t first, std::size_t end,
                      std::vector<BodyState>& states) {
  constexpr std::size_t kLanes = PackBlock::kLanes;
  std::size_t i = first;
  for (; i + kLanes <= end; i += kLanes) {
    BodyState* to[kLanes];
    for (std::size_t k = 0; k < kLanes; ++k) to[k] = &states[shelf.bodies[i + k]];
    readBlock()(shelf.blocks[i / kLanes], to);
  }
  for (; i < end; ++i)
    copyState(shelf.blocks[i / kLanes].columns, i % kLanes, states[shelf.bodies[i]]);
}

void Packs::copyTo(std::vector<BodyState>& states) const {
  for (const Shelf& shelf : shelves_) {
    const std::size_t bodies = shelf.lanes.size();
    inParts(bodies, PackBlock::kLanes, worthwhileThreads(threads_, bodies, kLeastCopies),
            [&](std::size_t first, std::size_t end) { copyLanes(shelf, first, end, states); });
  }
}

/// Where they are evaluated once for a step that follows, at its end, the first step evaluates them
/// at its start, too.
std::int64_t Packs::evaluationsOf(const Shelf& shelf, const Lane& lane, std::int64_t steps) {
  const std::int64_t taken = steps - lane.since;
  const bool begins = taken > 0 && leavesWrenchesCurrent(shelf.kind) && !lane.wrenches_current;
  return taken * shelf.method->evaluations + (begins ? 1 : 0);
}

Packs::Stepped Packs::steppedTo(std::size_t body, std::int64_t steps) const {
  const Place place = places_[body];
  const Shelf& shelf = shelves_[place.shelf];
  const Lane& lane = shelf.lanes[place.lane];
  const std::size_t in_block = place.lane % PackBlock::kLanes;
  const PackBlock& block = shelf.blocks[place.lane / PackBlock::kLanes];
  const bool is_current =
      steps > lane.since ? leavesWrenchesCurrent(shelf.kind) : lane.wrenches_current;
  return {bodyIn(block, in_block), evaluationsOf(shelf, lane, steps), is_current,
          block.columns[kMagnificationColumn][in_block]};
}

/// As methods add a torque of zero to L_W: a zero gets its sign.
void Packs::addNoTorque(const Place& place) {
  if (shelves_[place.shelf].load != PackLoad::kNone) return;
  PackBlock& block = shelves_[place.shelf].blocks[place.lane / PackBlock::kLanes];
  for (int i = 0; i < 3; ++i)
    block.columns[kWorldSpinColumn + i][place.lane % PackBlock::kLanes] += 0.0;
}

void Packs::advance(std::int64_t steps, std::int64_t count, std::vector<BodyState>* read) {
  for (std::size_t body : new_)
    if (holds(body)) addNoTorque(places_[body]);
  new_.clear();
  double lengths[kCertainSteps];  // between times that are rounded, as of every step
  for (std::int64_t k = 0; k < count; ++k)
    lengths[k] = static_cast<double>(steps + k + 1) * time_step_ -
                 static_cast<double>(steps + k) * time_step_;
  for (Shelf& shelf : shelves_) {
    const std::size_t bodies = shelf.lanes.size();
    const PackStep step = packKernelsFor(bodies).step(shelf.kind, shelf.load);
    const auto stepPart = [&](std::size_t begin, std::size_t end) {
      const std::size_t parts = (end - begin + kAtOnce - 1) / kAtOnce;
      for (std::size_t k = 0; k < parts; ++k) {
        const std::size_t first = begin + kAtOnce * (is_backward_ ? parts - 1 - k : k);
        const std::size_t block = first / PackBlock::kLanes, to = std::min(end, first + kAtOnce);
        step(lengths, static_cast<int>(count), shelf.blocks.data() + block,
             shelf.pushes.empty() ? nullptr : shelf.pushes.data() + block, to - first);
        if (read) copyLanes(shelf, first, to, *read);
      }
    };
    const std::size_t work = bodies * static_cast<std::size_t>(count);
    inParts(bodies, PackBlock::kLanes, worthwhileThreads(threads_, work, kLeastSteps), stepPart);
  }
  is_backward_ = !is_backward_;
  certain_steps_ -= count;
}

std::vector<std::size_t> Packs::review() {
  std::vector<std::size_t> uncertain;
  for (const Shelf& shelf : shelves_)
    for (std::size_t b = 0; b < shelf.blocks.size(); ++b) {
      const bool drags = shelf.load == PackLoad::kDrag;
      const std::size_t first = b * PackBlock::kLanes,
                        bodies = std::min(PackBlock::kLanes, shelf.bodies.size() - first);
      if (!drags && areCertain(shelf.blocks[b], bodies)) continue;
      for (std::size_t k = 0; k < bodies; ++k)
        if (!isCertain(shelf.blocks[b], k) ||
            (drags && !slowsSlowly(shelf.blocks[b], shelf.pushes[b], k)))
          uncertain.push_back(shelf.bodies[first + k]);
    }
  certain_steps_ = kCertainSteps;
  return uncertain;
}

std::vector<std::size_t> Packs::withEventBy(double t) {
  std::vector<std::size_t> bodies;
  next_event_ = std::numeric_limits<double>::infinity();
  for (const Shelf& shelf : shelves_)
    for (std::size_t i = 0; i < shelf.lanes.size(); ++i)
      if (shelf.lanes[i].next_event <= t)
        bodies.push_back(shelf.bodies[i]);
      else
        next_event_ = std::min(next_event_, shelf.lanes[i].next_event);
  return bodies;
}

std::int64_t Packs::evaluations(std::int64_t steps) const {
  std::int64_t sum = 0;
  for (const Shelf& shelf : shelves_)
    for (const Lane& lane : shelf.lanes) sum += evaluationsOf(shelf, lane, steps);
  return sum;
}

double Packs::magnification() const {
  double most = 0;
  for (const Shelf& shelf : shelves_) {
    if (!shelf.method->claimsTo(kFeedsLeastAxis)) continue;
    for (std::size_t i = 0; i < shelf.lanes.size(); ++i)
      most = std::max(
          most,
          shelf.blocks[i / PackBlock::kLanes].columns[kMagnificationColumn][i % PackBlock::kLanes]);
  }
  return most;
}

}  // namespace rigid_body_sim
