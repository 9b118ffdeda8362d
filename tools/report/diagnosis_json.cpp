#include "tools/report/diagnosis_json.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>

#include <nlohmann/json.hpp>

#include "tools/report/diagnosis_text.hpp"

namespace farrier::report {
namespace {

using Json = nlohmann::ordered_json;
using diagnosis::Diagnosis;

const char* name_of(plant::EffectId id) { return plant::effect_info(id).name; }

Json json_of(const ShownEffect& effect) {
  Json parameters = Json::array();
  for (const ShownEffect::Number& number : effect.numbers) {
    parameters.push_back({{"name", number.name}, {"value", number.value}, {"unit", number.unit}});
  }
  const ShownEffect::Number& first = effect.numbers[0];
  return {{"name", effect.info->name},
          {"parameter", first.name},
          {"value", first.value},
          {"unit", first.unit},
          {"low", effect.low},
          {"high", effect.high},
          {"confidence", effect.confidence},
          {"share", effect.share},
          {"parameters", std::move(parameters)}};
}

Json json_of(const diagnosis::Experiment& experiment) {
  return {{"one", name_of(experiment.one)},
          {"other", name_of(experiment.other)},
          {"excitation", experiment.excitation},
          {"amplitude_A", experiment.amplitude_A},
          {"frequency_Hz", experiment.frequency_Hz},
          {"duration_s", experiment.duration_s},
          {"difference", experiment.difference},
          {"text", experiment_text(experiment)}};
}

Json json_of(const diagnosis::ChannelReport& channel, const DiagnosisResult& result) {
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

}  // namespace

std::string diagnosis_json(const DiagnosisResult& result, const Outcome& outcome) {
  const Diagnosis& d = result.diagnosis;
  const diagnosis::Judgement& judgement = d.judgement;
  const bool bad = judgement.verdict == diagnosis::Verdict::kBadData;
  Json common = Json::parse(to_json(outcome));
  Json json{{"command", outcome.command},
            {"verdict", diagnosis::to_string(judgement.verdict)},
            {"robot", result.robot.name},
            {"joint", result.joint.name},
            {"recording", result.recording}};
  for (const char* list : {"effects", "alternatives", "experiment", "experiments", "not_judged"}) {
    json[list] = Json::array();
  }
  for (const diagnosis::NamedEffect& effect : judgement.effects) {
    json["effects"].push_back(json_of(shown(effect, result.joint)));
  }
  for (const auto& [one, other] : judgement.alternatives) {
    json["alternatives"].push_back(Json::array({name_of(one), name_of(other)}));
  }
  for (const diagnosis::Experiment& experiment : d.experiments) {
    json["experiments"].push_back(json_of(experiment));
  }
  json["experiment"] = d.experiments.empty() ? Json(nullptr) : json_of(d.experiments.front());
  for (const plant::EffectId id : judgement.not_judged) {
    json["not_judged"].push_back(name_of(id));
  }
  json["held_out"] = nullptr;
  if (!d.channels.empty() && !bad) {
    json["held_out"] = {{"nrmse_before", d.nrmse_before},
                        {"nrmse_after", d.nrmse_after},
                        {"low", d.ratio_low},
                        {"high", d.ratio_high}};
  }
  json["control"] = nullptr;
  if (result.control) {
    json["control"] = {{"effect", result.control->effect},
                       {"old_nrmse", result.control->old_nrmse},
                       {"new_nrmse", result.control->new_nrmse}};
  }
  json["extended_model"] = result.extended_model.empty() ? Json(nullptr) : Json(result.extended_model);
  json["channels"] = Json::array();
  for (const diagnosis::ChannelReport& channel : d.channels) {
    json["channels"].push_back(json_of(channel, result));
  }
  json["remarks"] = d.remarks;
  if (bad) {
    json["findings"] = Json::array();
    for (const diagnosis::Finding& finding : result.findings) {
      json["findings"].push_back({{"what", finding.what}, {"row", finding.row}, {"text", finding.text}});
    }
  }
  json["figures"] = std::move(common["figures"]);
  json["run"] = std::move(common["run"]);
  constexpr int kIndent = 2;
  // Names of files may be no UTF-8: replaced rather than thrown about. Numbers that are not finite become null.
  return json.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Done> write_diagnosis_json(const std::string& path, const DiagnosisResult& result, const Outcome& outcome) {
  std::ofstream file(path);
  file << diagnosis_json(result, outcome) << std::flush;
  if (!file) {
    return Error{"cannot write the diagnosis to " + path + ": " + std::strerror(errno)};
  }
  return Done{};
}

}  // namespace farrier::report
