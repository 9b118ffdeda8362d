#include "report/diagnosis/diagnosis_json.hpp"

#include "diagnosis/data/trace_recording.hpp"
#include "report/diagnosis/diagnosis_text.hpp"
#include "report/diagnosis/judgement_json.hpp"

namespace farrier::report {
namespace {

using diagnosis::Diagnosis;

Json experiment_json(const diagnosis::Experiment& experiment) {
  const bool electric = experiment.amplitude_Nm > 0.0;
  return {{"one", effect_name(experiment.one)},
          {"other", effect_name(experiment.other)},
          {"excitation", experiment.excitation},
          {"amplitude_A", experiment.amplitude_A},
          {"frequency_Hz", experiment.frequency_Hz},
          {"duration_s", experiment.duration_s},
          {"amplitude_Nm", electric ? Json(experiment.amplitude_Nm) : Json(nullptr)},
          {"hold_stiffness_Nm_rad", electric ? Json(experiment.hold.stiffness) : Json(nullptr)},
          {"hold_damping_Nms_rad", electric ? Json(experiment.hold.damping) : Json(nullptr)},
          {"difference", experiment.difference},
          {"text", experiment_text(experiment)}};
}

Json channel_json(const diagnosis::ChannelReport& channel, const DiagnosisResult& result) {
  const diagnosis::Remainder& left = result.diagnosis.judgement.left[static_cast<std::size_t>(channel.channel)];
  Json dependences = Json::array();
  for (const diagnosis::Dependence& one : channel.dependences) {
    dependences.push_back({{"driver", one.driver},
                           {"explained", one.explained},
                           {"shape", shape_of(one)},
                           {"from", one.from},
                           {"mean", one.mean},
                           {"deviation", one.deviation}});
  }
  return {{"name", channel.name},
          {"unit", unit_of(channel.channel, result.joint)},
          {"dependences", std::move(dependences)},
          {"left", {{"rms", left.rms}, {"expected", left.expected}, {"nrmse", left.nrmse}}}};
}

Json wiring_json(const diagnosis::WiringAnswer& answer) {
  return {{"what", diagnosis::to_string(answer.fault.kind)},
          {"columns", answer.columns},
          {"amount", answer.fault.amount},
          {"joint", answer.fault.joint.empty() ? Json(nullptr) : Json(answer.fault.joint)},
          {"confidence", answer.confidence},
          {"left", answer.left}};
}

}  // namespace

std::string diagnosis_json(const DiagnosisResult& result, const Outcome& outcome) {
  const Diagnosis& d = result.diagnosis;
  const diagnosis::Judgement& judgement = d.judgement;
  const bool bad = is_refused(result);
  Json common = Json::parse(to_json(outcome));
  Json json{{"command", outcome.command},
            {"verdict", diagnosis::to_string(judgement.verdict)},
            {"robot", result.robot.name},
            {"joint", result.joint.name},
            {"recording", result.recording}};
  for (const char* list : {"effects", "alternatives", "experiment", "experiments", "not_judged"}) {
    json[list] = Json::array();
  }
  std::vector<ShownEffect> effects;
  for (const diagnosis::NamedEffect& effect : judgement.effects) {
    effects.push_back(shown(effect, result.joint));
  }
  add_judgement(json, judgement, effects);
  for (const diagnosis::Experiment& experiment : d.experiments) {
    json["experiments"].push_back(experiment_json(experiment));
  }
  json["experiment"] = d.experiments.empty() ? Json(nullptr) : experiment_json(d.experiments.front());
  json["held_out"] = d.channels.empty() || bad ? Json(nullptr) : json_of(error_of(d));
  json["control"] = nullptr;
  if (result.control) {
    json["control"] = {{"effect", result.control->effect},
                       {"old_nrmse", result.control->old_nrmse},
                       {"new_nrmse", result.control->new_nrmse}};
  }
  json["extended_model"] = result.model.path.empty() ? Json(nullptr) : Json(result.model.path);
  json["extended_model_held_out"] = result.model.error ? json_of(*result.model.error) : Json(nullptr);
  json["extended_model_lacks"] = result.model.left_out;
  json["channels"] = Json::array();
  for (const diagnosis::ChannelReport& channel : d.channels) {
    json["channels"].push_back(channel_json(channel, result));
  }
  json["remarks"] = d.remarks;
  if (bad) {
    json["findings"] = json_of(result.findings);
  }
  if (!result.wiring.empty()) {
    json["wiring"] = Json::array();
    for (const diagnosis::WiringAnswer& answer : result.wiring) {
      json["wiring"].push_back(wiring_json(answer));
    }
  }
  json["figures"] = std::move(common["figures"]);
  json["run"] = std::move(common["run"]);
  return text_of(json);
}

Result<Done> write_diagnosis_json(const std::string& path, const DiagnosisResult& result, const Outcome& outcome) {
  return write_diagnosis_text(path, diagnosis_json(result, outcome));
}

}  // namespace farrier::report
