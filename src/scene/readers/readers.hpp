#pragma once

#include <rigid_body_sim/scene/scene.hpp>

#include "scene/readers/entry.hpp"

namespace rigid_body_sim {

BodyDef readBody(const Entry& entry);

/// Reads one key of a body anew, on which no other key depends; false, and nothing is read, for any
/// other.
bool readBodyKey(const Entry& list_item, std::string_view key, BodyDef& body);

WrenchDef readWrench(const Entry& entry);

/// Reads one key of a wrench anew.
void readWrenchKey(const Entry& list_item, std::string_view key, WrenchDef& wrench);

ForceDef readForce(const Entry& entry);
ContactDef readContact(const Entry& entry);
MediumDef readMedium(const Entry& entry);
DragDef readDrag(const Entry& entry);

/// None where it is false.
std::optional<BuoyancyDef> readBuoyancy(const Entry& entry);

std::vector<ThrusterDef> readThrusters(const Entry& entry);
std::vector<RotorDef> readRotors(const Entry& entry);
std::vector<WheelDef> readWheels(const Entry& entry);
std::vector<ImuDef> readImus(const Entry& entry);
CommandDef readCommand(const Entry& entry);

/// The value of `shape`.
SolidGeometry readGeometry(const Entry& entry);

/// The value of `collision`.
std::vector<CollisionDef> readCollision(const Entry& entry);

/// The value of `scale` of a mesh: one number > 0, or three other than 0.
Vector3d readMeshScale(const Entry& value);

/// The value of `mesh` within a shape; reads the file.
MeshDef readMeshDef(const Entry& entry);

/// The same where only its convex hull counts.
HullDef readHullDef(const Entry& entry);

/// The corners of a mesh file (meshCorners); each is found once. Throws as that.
HullCorners cornersOf(ReadContext& context, const std::string& path, const Vector3d& scale,
                      MeshSolid solid);

/// A body made of links of a URDF file.
struct LinkedBody {
  LinkDef def;
  std::vector<PointDef> points;  ///< the frames of the links; none for a link alone
};

/// What is read of a URDF file beside what every body needs.
struct LinkChoice {
  bool balance = false;  ///< moments that break the triangle inequality are raised to meet it
  bool touches = false;  ///< by the <collision> elements
};

/// The value of `urdf`; reads the file.
LinkedBody readLink(const Entry& entry, const LinkChoice& choice);

/// What the body is made of, from the keys that say so; refuses keys, or a lack of them, that do
/// not say it once. entry: the mapping of the body.
void readComposition(const Entry& entry, BodyDef& body);

}  // namespace rigid_body_sim
