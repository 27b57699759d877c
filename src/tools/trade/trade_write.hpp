#pragma once

#include <string>

namespace rigid_body_sim {

/// Writes an integrator and a time step into a scene file and keeps everything else: comments,
/// order, other keys; a tolerance, too, where it is not 0. With an integrator other than auto,
/// `tolerance` becomes a comment. Returns what was changed, one line. Throws std::runtime_error,
/// one line, and leaves the file as it was, where its keys do not stand on lines of their own or
/// the file cannot be written.
std::string writeSolver(const std::string& path, const std::string& integrator, double time_step,
                        double tolerance = 0);

}  // namespace rigid_body_sim
