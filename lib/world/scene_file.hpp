#pragma once

// The scene file, deploy/scenes/*.yaml: the ground and what happens to the robot on it, as data.

#include <optional>
#include <string>

#include "body/scene/scene.hpp"
#include "config/visitor.hpp"

namespace farrier::world {

/// A plane through the world's origin.
struct GroundSection {
  double roll_rad = 0.0;
  double pitch_rad = 0.0;
};

struct BoxSection {
  double x_m = 0.0, y_m = 0.0;  ///< of the middle
  double base_z_m = 0.0;        ///< of the lower face
  double length_m = 0.0, width_m = 0.0, height_m = 0.0;
  double roll_rad = 0.0, pitch_rad = 0.0, yaw_rad = 0.0;
  config::Place place;
};

/// Steps that rise along x.
struct StairsSection {
  double x_m = 0.0, y_m = 0.0;  ///< of the first edge's middle
  double width_m = 2.0;
  double rise_m = 0.0, run_m = 0.0;
  int steps = 1;
  config::Place place;
};

/// A field of square blocks with random heights.
struct BlocksSection {
  double x_m = 0.0, y_m = 0.0;  ///< of the corner with the least x and y
  double length_m = 0.0, width_m = 0.0;
  double size_m = 0.3;
  double height_m = 0.0;
  int seed = 1;
  config::Place place;
};

struct PushSection {
  std::string body = "trunk";
  double start_s = 0.0, duration_s = 0.1;
  double impulse_x_Ns = 0.0, impulse_y_Ns = 0.0, impulse_z_Ns = 0.0;
};

struct PayloadSection {
  std::string body = "trunk";
  double start_s = 0.0;
  double mass_kg = 0.0;
  double x_m = 0.0, y_m = 0.0, z_m = 0.0;
};

/// A fault of the supply of hydraulic actuators. Absent values stay as they are.
struct SupplySection {
  double start_s = 0.0;
  std::optional<double> pump_flow_m3_s, accumulator_volume_m3;
  config::Place place;
};

struct ActuatorSection {
  std::string joint;
  double start_s = 0.0, duration_s = 0.0;
  std::optional<double> valve_gain_factor, bulk_modulus_factor, viscosity_factor, seal_friction_factor;
  std::optional<double> leakage_m3_s_Pa, overlap_A, stuck_A;
  config::Place place;
};

struct SceneFile {
  double friction = 0.8;
  GroundSection ground;
  config::Named<BoxSection> boxes;
  config::Named<StairsSection> stairs;
  config::Named<BlocksSection> blocks;
  config::Named<PushSection> pushes;
  config::Named<PayloadSection> payloads;
  config::Named<SupplySection> supply;
  config::Named<ActuatorSection> actuators;
  config::Place place;
};

void declare(config::Visitor& v, GroundSection& ground);
void declare(config::Visitor& v, BoxSection& box);
void declare(config::Visitor& v, StairsSection& stairs);
void declare(config::Visitor& v, BlocksSection& blocks);
void declare(config::Visitor& v, PushSection& push);
void declare(config::Visitor& v, PayloadSection& payload);
void declare(config::Visitor& v, SupplySection& supply);
void declare(config::Visitor& v, ActuatorSection& actuator);
void declare(config::Visitor& v, SceneFile& file);

/// Loads and checks a scene file. Refuses with every mistake in it, each with its line and remedy.
Result<body::Scene, config::Problems> load_scene(const std::string& path);

/// The same, from text; `file` names it in problems.
Result<body::Scene, config::Problems> load_scene_text(const std::string& text, const std::string& file);

}  // namespace farrier::world
