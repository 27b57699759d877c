#include "scene/build/pivot_rules.hpp"

#include <rigid_body_sim/mass/principal_axes.hpp>
#include <rigid_body_sim/scene/scene_error.hpp>

#include "math/shortest.hpp"
#include "scene/build/body_mass.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {

std::optional<Vector3d> pivotOf(const BodyDef& body) {
  if (!body.pivot) return std::nullopt;
  return body.pivot->point;
}

Matrix3d turningInertia(const BodyDef& body) {
  const MassProperties m = massProperties(body);
  return body.pivot ? parallelAxes(m.I_Bcm, m.mass, m.com_B - body.pivot->point) : m.I_Bcm;
}

void checkPivot(const Scene& scene, const BodyDef& body) {
  if (!body.pivot) return;
  const auto fail = [&](int line, const std::string& rule) {
    throw SceneError(scene.source, line, "body '" + body.name + "': " + rule);
  };
  if (body.fixed)
    fail(body.pivot->line,
         "pivot cannot stand beside fixed: true, for a fixed body does not turn; remove one of "
         "them");
  if (body.twist.names_linear || !body.twist.linear.isZero(0))
    fail(body.twist.line,
         "twist.linear must be left out beside pivot, for the pivot stays where it is, got " +
             listed(body.twist.linear) + " m/s");
  const Matrix3d I = turningInertia(body);
  if (!I.allFinite())
    fail(body.pivot->line, "pivot.point must be so near that the inertia about it is finite, got " +
                               listed(body.pivot->point) + " m");
  // of less than 1e-15 of the greatest moment rounding leaves nothing
  if (!(principalAxes(I).I(0) > 1e-15 * I.cwiseAbs().maxCoeff()))
    fail(body.pivot->line,
         "pivot.point must be so near that the body's own inertia is not lost in that about it, up "
         "to " +
             shortest(I.cwiseAbs().maxCoeff()) + " kg m^2, got " + listed(body.pivot->point) +
             " m");
  for (const ForceDef& force : scene.forces)
    if (std::holds_alternative<CentralGravityDef>(force.law))
      fail(body.pivot->line, "pivot is not supported beside central_gravity");
}

}  // namespace rigid_body_sim
