#include "tools/simulate/bag_output.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "ros/bag/bag_transport.hpp"

namespace rigid_body_sim {
namespace {

/// A file that takes nothing is reported before the run: rosbag notices once its buffers are full.
void requireWritable(const std::string& path) {
  std::ofstream probe(path);
  if (!probe || !(probe << '\n' << std::flush)) throw std::runtime_error("no room");
}

}  // namespace

BagOutput::BagOutput(const std::string& path, double rate, const TimeOrigin& origin,
                     const Scene& scene, const Simulation& simulation)
    : path_(path), bag_(std::make_unique<rosbag::Bag>()), origin_(origin) {
  NodeOptions options;
  options.publish_clock = true;
  options.publish_rate = rate;
  guarded([&] {
    requireWritable(path);
    bag_->open(path, rosbag::bagmode::Write);
    BagTransport transport(*bag_);
    outputs_ = std::make_unique<Outputs>(
        openTopics(transport, simulation.world(), {options.publish_clock}), options, scene,
        simulation, origin_);
  });
}

void BagOutput::writeDue() {
  guarded([&] { outputs_->publishDue(); });
}

void BagOutput::writeWithinStep(double t_end) {
  guarded([&] { outputs_->publishWithinStep(t_end); });
}

void BagOutput::finish() {
  guarded([&] { bag_->close(); });
}

void BagOutput::guarded(const std::function<void()>& action) {
  errno = 0;
  try {
    action();
  } catch (const std::exception& error) {
    // rosbag says which call failed ("Error seeking"), the system why ("No space left on device")
    const std::string reason = errno != 0 ? std::strerror(errno) : error.what();
    // its destructor would write once more, throw, and end the program
    static const rosbag::Bag* const failed = bag_->isOpen() ? bag_.release() : nullptr;
    static_cast<void>(failed);
    throw std::runtime_error(path_ + ": cannot be written: " + reason);
  }
}

}  // namespace rigid_body_sim
