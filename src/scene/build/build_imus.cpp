#include "scene/build/build_imus.hpp"

#include <rigid_body_sim/math/rotation.hpp>
#include <rigid_body_sim/scene/scene_error.hpp>

namespace rigid_body_sim {
namespace {

void checkPlace(const Scene& scene, const BodyDef& body, const ImuDef& def,
                const std::vector<GravityCenter>& centers) {
  const Vector3d x_W = body.position + rotate(body.orientation, def.imu.position_B);
  for (const GravityCenter& of : centers)
    if (x_W == of.center_W)
      throw SceneError(scene.source, def.line,
                       "body '" + body.name + "': imus." + def.imu.name +
                           " lies at a center of central_gravity, where gravity is infinite; move "
                           "its position");
}

}  // namespace

std::vector<GravityCenter> gravityCentersOf(const Scene& scene) {
  std::vector<GravityCenter> centers;
  for (const ForceDef& force : scene.forces)
    if (const auto* gravity = std::get_if<CentralGravityDef>(&force.law))
      centers.push_back({gravity->center, gravity->mu});
  return centers;
}

std::vector<Imu> imusOf(const Scene& scene) {
  const std::vector<GravityCenter> centers = gravityCentersOf(scene);
  std::vector<Imu> imus;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const BodyDef& body = scene.bodies[i];
    for (const ImuDef& def : body.imus) {
      if (body.fixed) checkPlace(scene, body, def, centers);
      imus.push_back(def.imu);
      imus.back().body = i;
    }
  }
  return imus;
}

}  // namespace rigid_body_sim
