#include "report/diagnosis/told_text.hpp"

#include <algorithm>

#include "report/diagnosis/diagnosis_text.hpp"
#include "report/diagnosis/judgement_json.hpp"
#include "report/figures/text_format.hpp"
#include "robot/joint_scales.hpp"

namespace farrier::report {
namespace told_text {
namespace {

std::vector<ShownEffect::Number> shown_numbers(plant::EffectId id, const std::vector<double>& size,
                                               const robot::Joint& joint) {
  return shown(diagnosis::NamedEffect{id, size, 0.0, 1.0, 1.0}, joint).numbers;
}

/// The first number of an effect that just shows.
ShownEffect::Number smallest_of(const diagnosis::EffectVisibility& effect, const robot::Joint& joint) {
  std::vector<double> size = effect.size;
  size[0] = effect.shows_from;
  return shown_numbers(effect.id, size, joint).front();
}

std::string text_of(const ShownEffect::Number& number) {
  return number.name + " " + short_number(number.value) + (number.unit == "1" ? "" : " " + number.unit);
}

std::string column_of(diagnosis::Channel channel, const robot::Joint& joint) {
  if (channel == diagnosis::Channel::kVelocitySensor) {
    return joint.rotary ? "velocity_rad_s" : "velocity_m_s";
  }
  return channel == diagnosis::Channel::kForce ? "valve_current_A" : "force_N";
}

std::string remedy_of(const diagnosis::Inseparable& pair, const robot::Joint& joint) {
  return pair.column       ? "the column " + column_of(*pair.column, joint) + " would"
         : pair.experiment ? experiment_text(*pair.experiment)
         : joint.electric  ? "no experiment is planned for electric joints"
                           : "no sine and no steps of the current that were tried would";
}

std::string names_of(const std::vector<plant::EffectId>& ids) {
  std::string text;
  for (const plant::EffectId id : ids) {
    text += (text.empty() ? "" : ", ") + std::string(effect_name(id));
  }
  return text;
}

}  // namespace
}  // namespace told_text

std::string told_console(const ToldResult& result) {
  using namespace told_text;
  const diagnosis::WhatCanBeTold& told = result.told;
  std::string text =
      "joint " + result.joint.name + " of " + result.robot.name + ", recording " + result.recording + "\n";
  std::vector<std::vector<std::string>> rows{{"effect", "of this size", "changes", "shows from", "could be taken for"}};
  std::vector<plant::EffectId> hidden;
  for (const diagnosis::EffectVisibility& effect : told.effects) {
    if (!effect.shows) {
      hidden.push_back(effect.id);
      continue;
    }
    std::vector<plant::EffectId> rivals;
    std::ranges::transform(effect.rivals, std::back_inserter(rivals), &diagnosis::LikeEffect::id);
    rows.push_back({effect_name(effect.id), text_of(shown_numbers(effect.id, effect.size, result.joint).front()),
                    short_number(effect.change), short_number(smallest_of(effect, result.joint).value),
                    rivals.empty() ? "none" : names_of(rivals)});
  }
  text +=
      aligned(rows) + "changes: largest rms change of a channel over its sensors' noise, after the model's constants\n";
  for (const diagnosis::Inseparable& pair : told.pairs) {
    text += std::string("not told apart: ") + effect_name(pair.one) + " and " + effect_name(pair.other) + "; " +
            remedy_of(pair, result.joint) + "\n";
  }
  if (!hidden.empty()) {
    text += "too small at their usual sizes: " + names_of(hidden) + "\n";
  }
  if (!told.other_columns.empty()) {
    text += "not in the recorded columns: " + names_of(told.other_columns) + "\n";
  }
  return text;
}

std::string told_json(const ToldResult& result) {
  using namespace told_text;
  Json json{{"command", "diagnose"},         {"robot", result.robot.name}, {"joint", result.joint.name},
            {"recording", result.recording}, {"effects", Json::array()},   {"pairs", Json::array()},
            {"other_columns", Json::array()}};
  for (const diagnosis::EffectVisibility& effect : result.told.effects) {
    Json one{{"name", effect_name(effect.id)},
             {"size", Json::array()},
             {"change", effect.change},
             {"shows", effect.shows},
             {"shows_from", json_of(smallest_of(effect, result.joint))}};
    for (const ShownEffect::Number& number : shown_numbers(effect.id, effect.size, result.joint)) {
      one["size"].push_back(json_of(number));
    }
    one["taken_for"] = Json::array();
    for (const diagnosis::LikeEffect& rival : effect.rivals) {
      one["taken_for"].push_back({{"name", effect_name(rival.id)}, {"left", rival.left}});
    }
    json["effects"].push_back(std::move(one));
  }
  for (const diagnosis::Inseparable& pair : result.told.pairs) {
    json["pairs"].push_back(
        {{"one", effect_name(pair.one)},
         {"other", effect_name(pair.other)},
         {"left", pair.left},
         {"column", pair.column ? Json(column_of(*pair.column, result.joint)) : Json(nullptr)},
         {"experiment", pair.experiment ? Json(experiment_text(*pair.experiment)) : Json(nullptr)}});
  }
  for (const plant::EffectId id : result.told.other_columns) {
    json["other_columns"].push_back(effect_name(id));
  }
  return report::text_of(json);
}

}  // namespace farrier::report
