#include "world/scene_file.hpp"

#include <cmath>

#include "config/reader.hpp"
#include "core/noise.hpp"

namespace farrier::world {
namespace {

using config::Defaults;
using config::kInitial;
using config::Range;
using config::Visitor;

constexpr Range kPlace_m{-1e3, 1e3};
constexpr Range kSize_m{1e-3, 1e3};
constexpr Range kAngle_rad{-3.2, 3.2};
constexpr Range kTime_s{0, 1e5};
constexpr std::size_t kLongestName = 15;
constexpr std::size_t kMostBoxes = 2000;
// A lower block is none: its edge would be a contact without a step.
constexpr double kLowestBlock_m = 1e-3;

void declare_body(Visitor& v, std::string& body) {
  v.name("body", body, kLongestName, config::Default{"trunk"}, "Body that it acts on: the trunk.");
  v.check(body == "trunk", "body", body + " is no body that it can act on: give trunk");
}

std::string line_of(const config::Place& place) {
  const config::Problem here = place.problem("", "");
  return here.file + ":" + std::to_string(here.line);
}

body::Box standing_box(const std::string& name, const config::Place& place, const Eigen::Vector3d& base_m,
                       const Eigen::Vector3d& size_m) {
  body::Box box;
  box.name = name;
  box.origin = line_of(place);
  box.centre_m = base_m + 0.5 * size_m.z() * Eigen::Vector3d::UnitZ();
  box.half_extents_m = 0.5 * size_m;
  return box;
}

void add_box(const std::string& name, const BoxSection& from, body::Scene& scene) {
  body::Box box =
      standing_box(name, from.place, {from.x_m, from.y_m, from.base_z_m}, {from.length_m, from.width_m, from.height_m});
  box.attitude = body::attitude_of(from.roll_rad, from.pitch_rad, from.yaw_rad);
  scene.boxes.push_back(box);
}

void add_stairs(const std::string& name, const StairsSection& from, body::Scene& scene) {
  for (int step = 0; step < from.steps; ++step) {
    scene.boxes.push_back(standing_box(name + "/" + std::to_string(step), from.place,
                                       {from.x_m + (step + 0.5) * from.run_m, from.y_m, 0.0},
                                       {from.run_m, from.width_m, (step + 1) * from.rise_m}));
  }
}

int blocks_along(double extent_m, double size_m) { return static_cast<int>(std::lround(extent_m / size_m)); }

void add_blocks(const std::string& name, const BlocksSection& from, body::Scene& scene) {
  const NoiseStream heights(static_cast<std::uint64_t>(from.seed), name, "height");
  const int along = blocks_along(from.length_m, from.size_m);
  const int across = blocks_along(from.width_m, from.size_m);
  for (int i = 0; i < along * across; ++i) {
    const int row = i / across;
    const int column = i % across;
    const double height_m = from.height_m * heights.uniform(i);
    if (height_m >= kLowestBlock_m) {
      const Eigen::Vector3d base_m(from.x_m + (row + 0.5) * from.size_m, from.y_m + (column + 0.5) * from.size_m, 0.0);
      scene.boxes.push_back(
          standing_box(name + "/" + std::to_string(i), from.place, base_m, {from.size_m, from.size_m, height_m}));
    }
  }
}

body::Scene scene_of(const SceneFile& file) {
  body::Scene scene;
  scene.friction = file.friction;
  scene.ground = body::attitude_of(file.ground.roll_rad, file.ground.pitch_rad, 0.0);
  for (const auto& [name, box] : file.boxes) {
    add_box(name, box, scene);
  }
  for (const auto& [name, stairs] : file.stairs) {
    add_stairs(name, stairs, scene);
  }
  for (const auto& [name, blocks] : file.blocks) {
    add_blocks(name, blocks, scene);
  }
  for (const auto& [name, push] : file.pushes) {
    scene.pushes.push_back(
        {name, push.start_s, push.duration_s, {push.impulse_x_Ns, push.impulse_y_Ns, push.impulse_z_Ns}});
  }
  for (const auto& [name, payload] : file.payloads) {
    scene.payloads.push_back({name, payload.start_s, payload.mass_kg, {payload.x_m, payload.y_m, payload.z_m}});
  }
  for (const auto& [name, supply] : file.supply) {
    scene.supply_changes.push_back(
        {name, supply.start_s, supply.pump_flow_m3_s, supply.accumulator_volume_m3, line_of(supply.place)});
  }
  for (const auto& [name, actuator] : file.actuators) {
    scene.actuator_changes.push_back({.name = name,
                                      .joint = actuator.joint,
                                      .start_s = actuator.start_s,
                                      .duration_s = actuator.duration_s,
                                      .valve_gain = actuator.valve_gain_factor,
                                      .bulk_modulus = actuator.bulk_modulus_factor,
                                      .viscosity = actuator.viscosity_factor,
                                      .seal_friction = actuator.seal_friction_factor,
                                      .leakage_m3_s_Pa = actuator.leakage_m3_s_Pa,
                                      .overlap_A = actuator.overlap_A,
                                      .stuck_A = actuator.stuck_A,
                                      .origin = line_of(actuator.place)});
  }
  return scene;
}

Result<body::Scene, config::Problems> checked(const Result<SceneFile, config::Problems>& file) {
  if (!file) {
    return file.error();
  }
  body::Scene scene = scene_of(file.value());
  const config::Place& place = file.value().place;
  if (scene.boxes.size() > kMostBoxes) {
    return config::Problems{place.problem("", "has " + std::to_string(scene.boxes.size()) +
                                                  " boxes and blocks: give at most " + std::to_string(kMostBoxes))};
  }
  if (const auto good = body::validate(scene); !good) {
    return config::Problems{place.problem("", good.error().message)};
  }
  return scene;
}

}  // namespace

void declare(Visitor& v, GroundSection& g) {
  v.number("roll_rad", g.roll_rad, {-1.5, 1.5}, kInitial, "Slope across; positive: the left side is higher.");
  v.number("pitch_rad", g.pitch_rad, {-1.5, 1.5}, kInitial, "Slope along; positive: downhill forward.");
}

void declare(Visitor& v, BoxSection& b) {
  v.here(b.place);
  v.number("x_m", b.x_m, kPlace_m, "Middle of the box.");
  v.number("y_m", b.y_m, kPlace_m, kInitial, "Middle of the box.");
  v.number("base_z_m", b.base_z_m, kPlace_m, kInitial, "Lower face of the box before it is turned.");
  v.number("length_m", b.length_m, kSize_m, "Extent along x.");
  v.number("width_m", b.width_m, kSize_m, "Extent along y.");
  v.number("height_m", b.height_m, kSize_m, "Extent along z.");
  v.number("roll_rad", b.roll_rad, kAngle_rad, kInitial, "Turn about x through its middle, after pitch and yaw.");
  v.number("pitch_rad", b.pitch_rad, kAngle_rad, kInitial, "Turn about y, after yaw.");
  v.number("yaw_rad", b.yaw_rad, kAngle_rad, kInitial, "Turn about z.");
}

void declare(Visitor& v, StairsSection& s) {
  v.here(s.place);
  v.number("x_m", s.x_m, kPlace_m, "First edge.");
  v.number("y_m", s.y_m, kPlace_m, kInitial, "Middle of the edges.");
  v.number("width_m", s.width_m, kSize_m, kInitial, "Length of the edges.");
  v.number("rise_m", s.rise_m, kSize_m, "Height of a step.");
  v.number("run_m", s.run_m, kSize_m, "Depth of a step.");
  v.integer("steps", s.steps, {1, 1000}, "Number of steps.");
}

void declare(Visitor& v, BlocksSection& b) {
  v.here(b.place);
  v.number("x_m", b.x_m, kPlace_m, "Corner of the field with the least x.");
  v.number("y_m", b.y_m, kPlace_m, "Corner of the field with the least y.");
  v.number("length_m", b.length_m, kSize_m, "Extent along x, rounded to whole blocks.");
  v.number("width_m", b.width_m, kSize_m, "Extent along y, rounded to whole blocks.");
  v.number("size_m", b.size_m, {0.05, 1e3}, kInitial, "Side of a block.");
  v.number("height_m", b.height_m, kSize_m, "Heights are uniform between zero and this.");
  v.integer("seed", b.seed, {0, 1e9}, kInitial, "Seed of the heights.");
  v.check(b.length_m / b.size_m * (b.width_m / b.size_m) <= static_cast<double>(kMostBoxes), "size_m",
          "makes more than " + std::to_string(kMostBoxes) + " blocks: give larger ones or a smaller field");
}

void declare(Visitor& v, PushSection& p) {
  declare_body(v, p.body);
  v.number("start_s", p.start_s, kTime_s, "Begin of the push.");
  v.number("duration_s", p.duration_s, {1e-3, 1e3}, kInitial, "Time over which the force is constant.");
  v.number("impulse_x_Ns", p.impulse_x_Ns, {-1e5, 1e5}, kInitial, "Force times duration, along the world's x.");
  v.number("impulse_y_Ns", p.impulse_y_Ns, {-1e5, 1e5}, kInitial, "Along the world's y.");
  v.number("impulse_z_Ns", p.impulse_z_Ns, {-1e5, 1e5}, kInitial, "Along the world's z.");
}

void declare(Visitor& v, PayloadSection& p) {
  declare_body(v, p.body);
  v.number("start_s", p.start_s, kTime_s, kInitial, "Time from which the payload is there.");
  v.number("mass_kg", p.mass_kg, {1e-3, 1e4}, "Mass, at a point.");
  v.number("x_m", p.x_m, {-10, 10}, kInitial, "Place in the trunk's frame, forward.");
  v.number("y_m", p.y_m, {-10, 10}, kInitial, "To the left.");
  v.number("z_m", p.z_m, {-10, 10}, kInitial, "Above.");
}

void declare(Visitor& v, SupplySection& s) {
  v.here(s.place);
  v.number("start_s", s.start_s, kTime_s, "Time from which the supply is so.");
  v.number("pump_flow_m3_s", s.pump_flow_m3_s, {0, 1}, "Flow of the pump; 0: it stops. Absent: as before.");
  v.number("accumulator_volume_m3", s.accumulator_volume_m3, {0, 1},
           "Volume of the accumulator's gas at its precharge; 0: there is none. Absent: as before.");
  v.check(s.pump_flow_m3_s || s.accumulator_volume_m3, "pump_flow_m3_s",
          "is missing, and so is accumulator_volume_m3: give at least one of them");
}

void declare(Visitor& v, ActuatorSection& a) {
  v.here(a.place);
  v.name("joint", a.joint, kLongestName, config::Default{""}, "Joint whose actuator it is. Absent: all joints.");
  v.number("start_s", a.start_s, kTime_s, kInitial, "Time at which the change begins.");
  v.number("duration_s", a.duration_s, kTime_s, kInitial, "Time over which it grows evenly; 0: at once.");
  v.number("valve_gain_factor", a.valve_gain_factor, {0.01, 10}, "On the valve's gain. Absent: as before.");
  v.number("bulk_modulus_factor", a.bulk_modulus_factor, {0.01, 10}, "On the oil's bulk modulus. Absent: as before.");
  v.number("viscosity_factor", a.viscosity_factor, {0, 100}, "On the piston's viscous friction. Absent: as before.");
  v.number("seal_friction_factor", a.seal_friction_factor, {0, 100}, "On the friction of seals. Absent: as before.");
  v.number("leakage_m3_s_Pa", a.leakage_m3_s_Pa, {0, 1e-9},
           "Leakage between the chambers, beside the robot file's. Absent: as before.");
  v.number("overlap_A", a.overlap_A, {0, 1}, "Overlap of the valve, in place of the robot file's. Absent: as before.");
  v.number("stuck_A", a.stuck_A, {-1, 1},
           "Current for which the spool stays open, whatever is sent; 0: shut. Absent: it follows.");
}

void declare(Visitor& v, SceneFile& f) {
  v.here(f.place);
  v.number("friction", f.friction, {0, 10}, kInitial, "Coulomb friction of feet on everything.");
  v.group("ground", f.ground, Defaults{}, "Slope of the plane through the world's origin.");
  v.groups("boxes", f.boxes, kLongestName, Defaults{}, "Boxes that stand still.");
  v.groups("stairs", f.stairs, kLongestName, Defaults{}, "Flights of steps.");
  v.groups("blocks", f.blocks, kLongestName, Defaults{}, "Fields of random blocks.");
  v.groups("pushes", f.pushes, kLongestName, Defaults{}, "Forces on the trunk's centre of mass.");
  v.groups("payloads", f.payloads, kLongestName, Defaults{}, "Masses that are put on the trunk.");
  v.groups("supply", f.supply, kLongestName, Defaults{}, "Faults of the supply of hydraulic actuators.");
  v.groups("actuators", f.actuators, kLongestName, Defaults{}, "Wear, heat and faults of hydraulic actuators.");
}

Result<body::Scene, config::Problems> load_scene(const std::string& path) {
  return checked(config::read_file<SceneFile>(path));
}

Result<body::Scene, config::Problems> load_scene_text(const std::string& text, const std::string& file) {
  return checked(config::read_text<SceneFile>(text, file));
}

}  // namespace farrier::world
