#pragma once

#include <rigid_body_sim/scene/scene.hpp>

#include "scene/readers/entry.hpp"

namespace rigid_body_sim {

BodyDef readBody(const Entry& entry);
WrenchDef readWrench(const Entry& entry);
ForceDef readForce(const Entry& entry);
Drag readDrag(const Entry& entry);

/// The value of `shape`: fills in either the shape or the mesh.
void readSolid(const Entry& entry, SolidDef& solid);

/// The value of `mesh` within a shape; reads the file.
MeshDef readMeshDef(const Entry& entry);

/// The value of `urdf`; reads the file.
LinkDef readLink(const Entry& entry);

Matrix3d readInertia(const Entry& entry);
std::vector<PartDef> readParts(const Entry& entry);
Particles readParticles(const Entry& entry);

/// Refuses keys of a body, or a lack of them, that do not say once what it is made of. Returns the
/// line of the key that does.
int checkMatter(const Entry& entry, const BodyDef& body);

/// A shape needs either mass or density. entry: the mapping that holds the three.
void checkSolid(const Entry& entry, const SolidDef& solid);

}  // namespace rigid_body_sim
