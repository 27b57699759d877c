#include "bag_output.hpp"

#include <stdexcept>

#include "bag_transport.hpp"

namespace rigid_body_sim {

BagOutput::BagOutput(const std::string& path, double rate, const Scene& scene,
                     const Simulation& simulation)
    : path_(path), bag_(std::make_unique<rosbag::Bag>()) {
  NodeOptions options;
  options.publish_clock = true;
  options.publish_rate = rate;
  guarded([&] {
    bag_->open(path, rosbag::bagmode::Write);
    BagTransport transport(*bag_);
    outputs_ =
        std::make_unique<Outputs>(openTopics(transport, simulation.world(), options.publish_clock),
                                  options, scene, simulation, origin_);
  });
}

void BagOutput::writeDue() {
  guarded([&] { outputs_->publishDue(); });
}

void BagOutput::finish() {
  guarded([&] { bag_->close(); });
}

void BagOutput::guarded(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::exception& error) {
    // its destructor would write once more, throw, and end the program
    static const rosbag::Bag* const failed = bag_->isOpen() ? bag_.release() : nullptr;
    static_cast<void>(failed);
    throw std::runtime_error(path_ + ": " + error.what());
  }
}

}  // namespace rigid_body_sim
