#pragma once

#include <functional>
#include <string>

#include <rigid_body_sim/scene/scene.hpp>
#include <rigid_body_sim/scene/scene_error.hpp>

namespace rigid_body_sim {

/// The directory of a ROS package; "" for one that is not there. ros::package::getPath is one.
using PackageFinder = std::function<std::string(const std::string& package)>;

/// Reads a scene file (YAML, one document within the limits of doc/robustness.md, without
/// anchors and aliases, so that its size bounds what it describes) and the mesh and URDF files that
/// it names. Every number becomes the nearest double, whatever the locale. An unknown, missing or
/// repeated key and every value that breaks its rule throws SceneError; nothing bad is ever
/// replaced by a default.
///
/// Files are named by package://<package>/<path>, which needs find_package, or by a path; a
/// relative one starts from the directory of the scene file.
Scene loadScene(const std::string& path, const PackageFinder& find_package = {});

/// The same from the text itself; source_name stands for the file in messages. Relative paths start
/// from the working directory.
Scene parseScene(const std::string& yaml_text, const std::string& source_name,
                 const PackageFinder& find_package = {});

}  // namespace rigid_body_sim
