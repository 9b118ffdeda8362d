#include "cli/diagnose/diagnose_tell.hpp"

#include <algorithm>
#include <cstdio>

#include "cli/base/command.hpp"
#include "core/text.hpp"
#include "diagnosis/judge/joint_bench.hpp"
#include "diagnosis/separability/what_can_be_told.hpp"
#include "report/diagnosis/judgement_json.hpp"
#include "report/diagnosis/told_text.hpp"

namespace farrier::cli {

Result<std::vector<plant::EffectId>> asked_set(const std::vector<std::string>& names, const robot::Joint& joint) {
  const std::vector<plant::EffectId> known = diagnosis::can_be_asked(joint);
  std::vector<plant::EffectId> set;
  for (const std::string& name : names) {
    const plant::EffectId id = plant::find_nameable(name);
    if (std::ranges::find(known, id) == known.end()) {
      std::vector<std::string> can;
      std::ranges::transform(known, std::back_inserter(can), [](auto one) { return plant::effect_info(one).name; });
      return Error{"--set: " +
                   (id == plant::kNameableCount
                        ? "no effect is called '" + name + "'"
                        : "joint " + joint.name + " cannot have '" + name + "', or its file has it already") +
                   "; give effects of " + join(can, ", ")};
    }
    if (std::ranges::find(set, id) != set.end()) {
      return Error{"--set: '" + name + "' stands twice; name it once"};
    }
    set.push_back(id);
  }
  return set;
}

int tell(const diagnosis::Recording& recording, const robot::Robot& robot, const robot::Joint& joint,
         const std::vector<plant::EffectId>& set, const DiagnoseOptions& o, const std::string& json_path) {
  if (!diagnosis::JointBench::is_excited(recording, diagnosis::JointBench::noise_of(recording, joint))) {
    return refuse("diagnose",
                  "neither position nor force rises above ten times its sensor's noise: record a joint that moves");
  }
  report::ToldResult result{.robot = robot, .joint = joint, .recording = o.recording};
  if (set.empty()) {
    result.told = with_options(
        o.threads, [&](const auto& options) { return diagnosis::what_can_be_told(recording, joint, options); });
  } else {
    result.set = with_options(
        o.threads, [&](const auto& options) { return diagnosis::what_can_be_told(recording, joint, set, options); });
  }
  if (!json_path.empty()) {
    if (const auto written = report::write_diagnosis_text(json_path, report::told_json(result)); !written) {
      return fail("diagnose", written.error().message);
    }
  }
  std::fputs(report::told_console(result).c_str(), stdout);
  return kPassed;
}

}  // namespace farrier::cli
