#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <rigid_body_sim/dynamics/contact.hpp>
#include <rigid_body_sim/dynamics/drag.hpp>
#include <rigid_body_sim/mass/particles.hpp>
#include <rigid_body_sim/mass/shapes.hpp>
#include <rigid_body_sim/scene/actuator_def.hpp>
#include <rigid_body_sim/scene/imu_def.hpp>
#include <rigid_body_sim/scene/visual.hpp>

namespace rigid_body_sim {

/// What a scene file says, in the body frames that its user knows. `line` is where an entry stands
/// in the file, 0 in a scene made by a program.

/// Velocity of the origin of a body frame, and of its axes.
struct TwistDef {
  bool in_body_axes = false;            ///< both vectors; else in world axes
  Vector3d linear = Vector3d::Zero();   ///< [m/s]
  Vector3d angular = Vector3d::Zero();  ///< [rad/s]
  bool names_linear = false;            ///< whether the file has the key `linear`
  int line = 0;
};

/// A frame F fixed to a body, named `<body>/<point>`.
struct PointDef {
  std::string name;
  Vector3d position = Vector3d::Zero();               ///< [m] of its origin, in the body frame
  Quaterniond orientation = Quaterniond::Identity();  ///< q_BF, unit
  int line = 0;
};

/// A point of a body that stays where it starts; the body turns about it without friction.
struct PivotDef {
  Vector3d point = Vector3d::Zero();  ///< [m] in the body frame
  int line = 0;
};

/// How a body is drawn; it has no part in the motion.
struct VisualDef {
  std::string mesh;                                   ///< URL; empty: what the body is made of
  Vector3d scale = Vector3d::Ones();                  ///< > 0, along the axes of the mesh file
  Vector3d position = Vector3d::Zero();               ///< [m] of the mesh, in the body frame
  Quaterniond orientation = Quaterniond::Identity();  ///< of the mesh, in the body frame, unit
  std::optional<Color> color;                         ///< none: as the viewer likes
};

/// Which solid a mesh stands for: what its closed surface encloses, its convex hull, or its
/// oriented bounding box.
enum class MeshSolid { kSurface, kHull, kBox };

/// Corners [m] of a convex hull, none of them between others. Shared by the bodies that have them.
using HullCorners = std::shared_ptr<const std::vector<Vector3d>>;

/// The solid of a triangle mesh, in the axes of its file: its integrals, from which mass properties
/// follow. The triangles themselves are not kept.
struct MeshDef {
  std::string url;                    ///< of the file: package:// as in the scene, else file://
  Vector3d scale = Vector3d::Ones();  ///< of the axes of the file; none is 0
  MeshSolid solid = MeshSolid::kSurface;
  double volume = 0;    ///< [m³] > 0, of the scaled mesh
  MassProperties unit;  ///< of one kilogram of it
  HullCorners corners;  ///< of its convex hull; null in a scene without contact
};

using SolidGeometry = std::variant<Shape, MeshDef>;

/// A homogeneous solid, in the frame of its geometry.
struct SolidDef {
  SolidGeometry geometry;
  double mass = 0;  ///< [kg] > 0
};

/// A part with a frame S of its own, placed in the body frame.
struct PartDef {
  std::variant<MassProperties, SolidDef> content;     ///< given properties or a solid, in S
  Vector3d position = Vector3d::Zero();               ///< [m] of the origin of S
  Quaterniond orientation = Quaterniond::Identity();  ///< q_BS, unit
  int line = 0;
};

/// The convex hull of a mesh, in the axes of its file.
struct HullDef {
  std::string url;                    ///< of the file, as in MeshDef
  Vector3d scale = Vector3d::Ones();  ///< of the axes of the file; none is 0
  HullCorners corners;                ///< [m] of the scaled mesh
};

/// A solid that touches, placed in the body frame.
struct CollisionDef {
  std::variant<Shape, HullDef> geometry;
  Vector3d position = Vector3d::Zero();               ///< [m] of the origin of its own frame S
  Quaterniond orientation = Quaterniond::Identity();  ///< q_BS, unit
};

/// A link of a URDF file, alone or with those that hang on it by fixed joints. The body frame is
/// that of the link.
struct LinkDef {
  MassProperties mass;  ///< of their <inertial> elements, summed
  std::vector<Visual> visuals;
  std::vector<CollisionDef> collision;  ///< their <collision> elements, in a scene with contact
};

/// A half-space, solid below the plane z = 0 of the body frame and free above it. It has no mass
/// and never moves.
struct PlaneDef {};

/// What a body is made of, in the body frame: given mass properties, a solid, the sum of parts,
/// particles at rest, a URDF link, or a half-space.
using CompositionDef =
    std::variant<MassProperties, SolidDef, std::vector<PartDef>, Particles, LinkDef, PlaneDef>;

/// See MediumDrag for the law, and Drag for the one of a medium that is not named.
struct DragDef : Drag::Coefficients {
  Vector3d linear_axes = Vector3d::Zero();     ///< [N s/m] >= 0, along the axes of the body frame
  Vector3d quadratic_axes = Vector3d::Zero();  ///< [N s²/m²] likewise
  Vector3d angular_axes = Vector3d::Zero();    ///< [N m s] likewise
  std::optional<Vector3d> center;              ///< [m] in the body frame; none: the centre of mass

  bool hasAxes() const {
    return !linear_axes.isZero(0) || !quadratic_axes.isZero(0) || !angular_axes.isZero(0);
  }
  bool any() const { return Drag::Coefficients::any() || hasAxes(); }
};

/// See Buoyancy for the law.
struct BuoyancyDef {
  std::optional<double> volume;    ///< [m³] > 0; none: of what the body is made of
  std::optional<Vector3d> center;  ///< [m] in the body frame; none: the centre of mass. With volume
  int line = 0;
};

struct BodyDef {
  std::string name;
  std::string frame;  ///< in tf; empty: the name
  CompositionDef composition;
  Vector3d position = Vector3d::Zero();               ///< [m] of its origin, in the world
  Quaterniond orientation = Quaterniond::Identity();  ///< q_WB, unit
  TwistDef twist;
  std::optional<PivotDef> pivot;
  DragDef drag;
  std::optional<BuoyancyDef> buoyancy;
  std::vector<PointDef> points;
  bool fixed = false;   ///< it never moves
  bool absent = false;  ///< takes no part until it comes in; see Simulation::setPresent
  VisualDef visual;
  ActuatorDefs actuators;
  std::vector<ImuDef> imus;
  std::optional<std::vector<CollisionDef>> collision;  ///< none: what it is made of touches

  int line = 0;              ///< of its name
  int composition_line = 0;  ///< of the key that says what it is made of
};

/// The tf frame of a body.
inline const std::string& frameOf(const BodyDef& body) {
  return body.frame.empty() ? body.name : body.frame;
}

/// A wrench by the names of its frames.
struct WrenchDef {
  std::string body;                    ///< the body acted on
  std::string frame;                   ///< axes of force and torque
  std::string point_frame;             ///< frame of point; empty: the body
  Vector3d point = Vector3d::Zero();   ///< [m] where the force acts
  Vector3d force = Vector3d::Zero();   ///< [N] at point
  Vector3d torque = Vector3d::Zero();  ///< [N m] a free couple
  double start = 0;                    ///< [s] since the start of the simulation
  double duration = 0;                 ///< [s] > 0; infinite: for ever
  int line = 0;
};

/// Where a spring or a tether ends: at a point of a body or of the world.
struct SpringEndDef {
  std::string body;                   ///< empty: the world
  Vector3d point = Vector3d::Zero();  ///< [m] in the body frame, or in the world
  int line = 0;
};

/// See Spring for the law.
struct SpringDef {
  SpringEndDef from, to;
  double stiffness = 0;    ///< [N/m] >= 0
  double damping = 0;      ///< [N s/m] >= 0
  double rest_length = 0;  ///< [m] >= 0
};

/// See Tether for the law.
struct TetherDef {
  SpringEndDef from, to;
  double stiffness = 0;  ///< [N/m] > 0
  double damping = 0;    ///< [N s/m] >= 0
  double length = 0;     ///< [m] > 0
};

/// See CentralGravity for the law; it acts on every body that moves.
struct CentralGravityDef {
  Vector3d center = Vector3d::Zero();  ///< [m]
  double mu = 0;                       ///< [m³/s²] > 0
  bool gradient = false;
};

/// Contact of two bodies; see contactWithHalfSpace and contactOfBalls for the law.
struct ContactDef {
  std::string body;
  std::string other;  ///< empty: every other body that has a shape
  ContactParameters parameters;
};

using ForceLawDef = std::variant<SpringDef, TetherDef, CentralGravityDef, ContactDef>;

struct ForceDef {
  ForceLawDef law;
  int line = 0;
};

/// What is around all bodies.
struct MediumDef {
  double density = 0;                    ///< [kg/m³] >= 0
  Vector3d velocity = Vector3d::Zero();  ///< [m/s] at the start
};

struct Scene {
  std::string source = "scene";  ///< file name, for messages
  std::string world_frame = "world";
  std::optional<Vector3d> gravity;  ///< [m/s²] none: no gravity
  std::optional<MediumDef> medium;  ///< none: at rest, without density
  double time_step = 0;             ///< [s] > 0
  std::string integrator = "auto";  ///< a name of the catalogue
  int integrator_line = 0;
  double tolerance = 1e-9;        ///< with auto; see SolverOptions
  bool tolerance_stated = false;  ///< whether the scene names it
  double horizon = 10;            ///< [s] also how long `simulate` runs
  int threads = 1;                ///< see SolverOptions
  std::string fingerprint;        ///< of all that the file says but threads; see World
  std::vector<BodyDef> bodies;
  std::vector<ForceDef> forces;
  std::vector<WrenchDef> wrenches;
  std::vector<CommandDef> commands;
  std::vector<std::string> files;    ///< absolute, that the scene names; of those in packages that
                                     ///< are for a viewer alone, nothing is known
  std::vector<std::string> notices;  ///< what the reader changed or doubts; for the user to see
};

}  // namespace rigid_body_sim
