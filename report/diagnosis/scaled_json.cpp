#include "report/diagnosis/scaled_json.hpp"

#include <utility>

#include "report/diagnosis/judgement_json.hpp"

namespace farrier::report {
namespace {

void add_diagnosis(Json& json, const diagnosis::ScaledDiagnosis& d) {
  add_judgement(json, d.judgement, shown_effects(d));
  json["held_out"] = json_of(d.error);
  json["model"] = {{"gain_before", d.gain_before},
                   {"drift_before", d.drift_before},
                   {"gain_after", d.gain_after},
                   {"drift_after", d.drift_after}};
  for (const diagnosis::EffectAlone& alone : d.alone) {
    const plant::EffectInfo& info = plant::effect_info(alone.id);
    const ShownEffect::Number number = shown(info.parameters[0], alone.fitted[0], d.scales, Units::kScaled);
    json["candidates"].push_back({{"name", info.name},
                                  {"parameter", number.name},
                                  {"value", number.value},
                                  {"unit", number.unit},
                                  {"fit_percent", alone.fit_percent},
                                  {"accepted", alone.accepted}});
  }
  json["remarks"] = d.remarks;
}

}  // namespace

std::string scaled_json(const ScaledResult& result, const Outcome& outcome) {
  Json common = Json::parse(to_json(outcome));
  Json json{{"command", outcome.command},
            {"verdict", diagnosis::to_string(result.verdict())},
            {"units", "scaled"},
            {"robot", nullptr},
            {"joint", nullptr},
            {"recording", result.recording}};
  for (const char* list : {"effects", "alternatives", "experiments", "not_judged", "channels", "candidates",
                           "remarks"}) {
    json[list] = Json::array();
  }
  for (const char* none : {"experiment", "held_out", "model", "control", "extended_model"}) {
    json[none] = nullptr;
  }
  if (result.diagnosis != nullptr) {
    add_diagnosis(json, *result.diagnosis);
  } else {
    json["findings"] = json_of(result.findings);
  }
  json["figures"] = std::move(common["figures"]);
  json["run"] = std::move(common["run"]);
  return text_of(json);
}

Result<Done> write_scaled_json(const std::string& path, const ScaledResult& result, const Outcome& outcome) {
  return write_diagnosis_text(path, scaled_json(result, outcome));
}

}  // namespace farrier::report
