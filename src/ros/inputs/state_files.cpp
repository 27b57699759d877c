#include "ros/inputs/state_files.hpp"

#include <filesystem>
#include <stdexcept>
#include <utility>

#include <rigid_body_sim/scene/scene_error.hpp>
#include <rigid_body_sim/scene/state_file.hpp>

#include "math/shortest.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

/// Says which file it is, wherever the node was started.
std::string absolute(const std::string& path) {
  if (path.empty()) throw std::invalid_argument("path must name a file, got an empty text");
  std::error_code no_matter;
  const std::filesystem::path full = std::filesystem::absolute(path, no_matter);
  return no_matter ? path : full.string();
}

/// A pipe would be waited for, and time would stand until somebody comes to its other end.
void requireRegular(const std::string& path) {
  std::error_code no_matter;  // what cannot be looked at cannot be opened either
  const std::filesystem::file_status there = std::filesystem::status(path, no_matter);
  if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there))
    throw SceneError(path, 0, "must be a regular file");
}

/// The answer to a request: what `action` says, or what it throws, in one line whatever the path.
template <class Action>
bool answer(StateFile::Response& response, const Action& action) {
  try {
    response.message = oneLine(action());
    response.success = true;
  } catch (const SceneError& fault) {
    response.message = oneLine(fault.what());
  } catch (const std::invalid_argument& refused) {
    response.message = oneLine(refused.what());
  }
  return true;
}

}  // namespace

StateFiles::StateFiles(ros::NodeHandle private_nh, const Simulation& simulation, Inputs& inputs,
                       FaultOfTime fault_of_time, std::vector<NamedFile> scene_files)
    : simulation_(simulation),
      inputs_(inputs),
      fault_of_time_(std::move(fault_of_time)),
      scene_files_(std::move(scene_files)),
      save_(private_nh.advertiseService("save", &StateFiles::save, this)),
      load_(private_nh.advertiseService("load", &StateFiles::load, this)) {}

bool StateFiles::save(StateFile::Request& request, StateFile::Response& response) {
  return answer(response, [&] {
    const std::string path = absolute(request.path);
    std::vector<NamedFile> files = scene_files_;
    files.push_back({"~save", path, true});
    requireDistinct(files);
    requireRegular(path);
    saveState(path, simulation_.world(), simulation_.state());
    return path + ": the state at " + shortest(simulation_.time()) + " s";
  });
}

bool StateFiles::load(StateFile::Request& request, StateFile::Response& response) {
  return answer(response, [&] {
    const std::string path = absolute(request.path);
    requireRegular(path);
    LoadInput input{loadState(path, simulation_.world())};
    const std::string fault = fault_of_time_(input.state.t);
    if (!fault.empty()) throw SceneError(path, 0, fault);
    try {
      inputs_.apply(input);
    } catch (const std::invalid_argument& refused) {
      throw SceneError(path, 0, refused.what());
    }
    return path + ": on from the state at " + shortest(simulation_.time()) + " s";
  });
}

}  // namespace rigid_body_sim
