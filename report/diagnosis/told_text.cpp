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

std::string remedy_of(const diagnosis::Remedy& remedy, const robot::Joint& joint) {
  return remedy.column       ? "the column " + column_of(*remedy.column, joint) + " would"
         : remedy.experiment ? experiment_text(*remedy.experiment)
                             : no_experiment_text();
}

void add_remedy(Json& json, const diagnosis::Remedy& remedy, const robot::Joint& joint) {
  json["column"] = remedy.column ? Json(column_of(*remedy.column, joint)) : Json(nullptr);
  json["experiment"] = remedy.experiment ? Json(experiment_text(*remedy.experiment)) : Json(nullptr);
}

std::string names_of(const std::vector<plant::EffectId>& ids) {
  std::string text;
  for (const plant::EffectId id : ids) {
    text += (text.empty() ? "" : ", ") + std::string(effect_name(id));
  }
  return text;
}

std::vector<plant::EffectId> rivals_of(const diagnosis::EffectVisibility& effect) {
  std::vector<plant::EffectId> rivals;
  std::ranges::transform(effect.rivals, std::back_inserter(rivals), &diagnosis::LikeEffect::id);
  return rivals;
}

std::string size_text(const diagnosis::EffectVisibility& effect, const robot::Joint& joint) {
  return effect.size.empty() ? "" : text_of(shown_numbers(effect.id, effect.size, joint).front());
}

/// Why a member of a set is not told from the others and the rest.
std::string reason_of(const diagnosis::MemberVisibility& member, const robot::Joint& joint) {
  return !member.recorded             ? "no recorded column shows it"
         : member.beside.size.empty() ? "this recording cannot show it"
         : !member.hidden_by.empty()  ? "hidden by " + names_of(member.hidden_by)
         : !member.beside.shows       ? "too small: it would show from " + text_of(smallest_of(member.beside, joint))
                                      : "could be taken for " + names_of(rivals_of(member.beside));
}

bool all_separable(const std::vector<diagnosis::ToldMember>& set) {
  return std::ranges::all_of(set, [](const diagnosis::ToldMember& one) { return one.seen.separable(); });
}

std::string set_text(const ToldResult& result) {
  std::vector<std::vector<std::string>> rows{{"effect", "of this size", "changes", "deviations", "told"}};
  std::string remedies;
  for (const auto& [seen, remedy] : result.set) {
    rows.push_back({effect_name(seen.beside.id), size_text(seen.beside, result.joint), short_number(seen.beside.change),
                    short_number(seen.beside.deviations), seen.separable() ? "yes" : "no"});
    if (!seen.separable()) {
      remedies += std::string("not told: ") + effect_name(seen.beside.id) + ", " + reason_of(seen, result.joint) +
                  "; " + remedy_of(remedy, result.joint) + "\n";
    }
  }
  return aligned(rows) +
         "changes: largest rms change of a channel over its sensors' noise, after the constants and the other effects\n"
         "deviations: expected of a fit, by which the effect lies outside its neutral band\n" +
         remedies +
         (all_separable(result.set) ? "this recording can separate the set\n"
                                    : "this recording cannot separate the set\n");
}

Json effect_json(const diagnosis::EffectVisibility& effect, const robot::Joint& joint) {
  Json one{{"name", effect_name(effect.id)},
           {"size", Json::array()},
           {"change", effect.change},
           {"shows", effect.shows},
           {"shows_from", effect.size.empty() ? Json(nullptr) : json_of(smallest_of(effect, joint))},
           {"taken_for", Json::array()}};
  if (!effect.size.empty()) {
    for (const ShownEffect::Number& number : shown_numbers(effect.id, effect.size, joint)) {
      one["size"].push_back(json_of(number));
    }
  }
  for (const diagnosis::LikeEffect& rival : effect.rivals) {
    one["taken_for"].push_back({{"name", effect_name(rival.id)}, {"left", rival.left}});
  }
  return one;
}

void add_set(Json& json, const ToldResult& result) {
  json["separable"] = all_separable(result.set);
  json["set"] = Json::array();
  for (const auto& [seen, remedy] : result.set) {
    Json one = effect_json(seen.beside, result.joint);
    one["deviations"] = seen.beside.deviations;
    one["separable"] = seen.separable();
    one["hidden_by"] = Json::array();
    for (const plant::EffectId id : seen.hidden_by) {
      one["hidden_by"].push_back(effect_name(id));
    }
    add_remedy(one, remedy, result.joint);
    json["set"].push_back(std::move(one));
  }
}

}  // namespace
}  // namespace told_text

std::string told_console(const ToldResult& result) {
  using namespace told_text;
  const diagnosis::WhatCanBeTold& told = result.told;
  std::string text =
      "joint " + result.joint.name + " of " + result.robot.name + ", recording " + result.recording + "\n";
  if (!result.set.empty()) {
    return text + set_text(result);
  }
  std::vector<std::vector<std::string>> rows{{"effect", "of this size", "changes", "shows from", "could be taken for"}};
  std::vector<plant::EffectId> hidden;
  for (const diagnosis::EffectVisibility& effect : told.effects) {
    if (!effect.shows) {
      hidden.push_back(effect.id);
      continue;
    }
    const std::vector<plant::EffectId> rivals = rivals_of(effect);
    rows.push_back({effect_name(effect.id), size_text(effect, result.joint), short_number(effect.change),
                    short_number(smallest_of(effect, result.joint).value), rivals.empty() ? "none" : names_of(rivals)});
  }
  text +=
      aligned(rows) + "changes: largest rms change of a channel over its sensors' noise, after the model's constants\n";
  for (const diagnosis::Inseparable& pair : told.pairs) {
    text += std::string("not told apart: ") + effect_name(pair.one) + " and " + effect_name(pair.other) + "; " +
            remedy_of(pair.remedy, result.joint) + "\n";
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
  Json json{{"command", "diagnose"},
            {"robot", result.robot.name},
            {"joint", result.joint.name},
            {"recording", result.recording}};
  if (!result.set.empty()) {
    add_set(json, result);
    return report::text_of(json);
  }
  json["effects"] = Json::array();
  json["pairs"] = Json::array();
  json["other_columns"] = Json::array();
  for (const diagnosis::EffectVisibility& effect : result.told.effects) {
    json["effects"].push_back(effect_json(effect, result.joint));
  }
  for (const diagnosis::Inseparable& pair : result.told.pairs) {
    Json one{{"one", effect_name(pair.one)}, {"other", effect_name(pair.other)}, {"left", pair.left}};
    add_remedy(one, pair.remedy, result.joint);
    json["pairs"].push_back(std::move(one));
  }
  for (const plant::EffectId id : result.told.other_columns) {
    json["other_columns"].push_back(effect_name(id));
  }
  return report::text_of(json);
}

}  // namespace farrier::report
