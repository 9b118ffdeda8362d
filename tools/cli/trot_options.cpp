#include "tools/cli/trot_options.hpp"

#include <filesystem>

namespace farrier::cli {
namespace {

const std::map<std::string, DdsChoice> kDds{{"cyclone", DdsChoice::kCyclone},
                                            {"fast", DdsChoice::kFast},
                                            {"mixed", DdsChoice::kMixed},
                                            {"inproc", DdsChoice::kInproc}};
const std::map<std::string, bus::ClockKind> kClocks{{"lockstep", bus::ClockKind::kLockstep},
                                                    {"realtime", bus::ClockKind::kRealtime}};
const std::map<std::string, lab::Grouping> kNodes{{"per-leg", lab::Grouping::kPerLeg},
                                                  {"per-joint", lab::Grouping::kPerJoint},
                                                  {"one", lab::Grouping::kOne}};

template <class Value>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Value& value,
                        const std::map<std::string, Value>& choices, const std::string& text) {
  std::string names;
  for (const auto& [choice, ignored] : choices) {
    names += (names.empty() ? "" : "|") + choice;
  }
  return app
      .add_option_function<std::string>(name, [&value, &choices](const std::string& given) { value = choices.at(given); },
                                        text)
      ->check(CLI::IsMember(&choices))
      ->type_name(names);
}

}  // namespace

void declare(CLI::App& app, TrotOptions& o) {
  o.robot_path = shipped_robot("hyq.yaml");
  app.add_option("--robot", o.robot_path, "robot file")->type_name("<file>")->capture_default_str();
  add_choice(app, "--dds", o.dds, kDds,
             "vendor; mixed: sim_bridge and estimator_service on Cyclone, the rest on Fast; inproc: one process")
      ->default_str("cyclone");
  add_choice(app, "--clock", o.clock, kClocks, "lock-step (repeatable) or real time")->default_str("lockstep");
  add_choice(app, "--nodes", o.nodes, kNodes, "joints per joint_node process")->default_str("per-leg");
  app.add_option("--duration", o.duration_s, "simulated seconds")
      ->check(CLI::Range(0.1, 3600.0))
      ->type_name("<s>")
      ->capture_default_str();
  app.add_option("--gait", o.gait, "gait, instead of the robot file's")->check(CLI::IsMember({"trot", "stand"}))->type_name("trot|stand");
  app.add_option("--frequency", o.frequency_Hz, "strides per second, instead of the robot file's")
      ->check(CLI::Range(0.1, 10.0))
      ->type_name("<Hz>");
  app.add_option("--seed", o.seed, "seed of sensor noise and touchdown times")->type_name("<n>")->capture_default_str();
  app.add_option("--out", o.out, "directory for the report, the trace and the logs")->type_name("<dir>")->capture_default_str();
  app.add_option("--trace", o.trace_path, "write the trace here instead of trace.csv in --out")->type_name("<file>");
  app.add_option("--json", o.json_path, "write the figures here instead of figures.json in --out")->type_name("<file>");
}

std::string build_directory() {
  // <build>/tools/cli/farrier
  return std::filesystem::canonical("/proc/self/exe").parent_path().parent_path().parent_path().string();
}

std::string shipped_robot(const std::string& name) {
  return (std::filesystem::path(FARRIER_ROBOTS) / name).lexically_normal().string();
}

}  // namespace farrier::cli
