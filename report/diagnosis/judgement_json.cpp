#include "report/diagnosis/judgement_json.hpp"

#include <utility>

#include "core/replace_file.hpp"

namespace farrier::report {

Json json_of(const ShownEffect::Number& number) {
  return {{"name", number.name}, {"value", number.value}, {"unit", number.unit}};
}

Json json_of(const ShownEffect& effect) {
  Json parameters = Json::array();
  for (const ShownEffect::Number& number : effect.numbers) {
    parameters.push_back(json_of(number));
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

Json json_of(const diagnosis::ErrorRatio& error) {
  return {{"nrmse_before", error.before}, {"nrmse_after", error.after}, {"low", error.low}, {"high", error.high}};
}

Json json_of(std::span<const diagnosis::Finding> findings) {
  Json list = Json::array();
  for (const diagnosis::Finding& finding : findings) {
    list.push_back({{"what", finding.what}, {"row", finding.row}, {"text", finding.text}});
  }
  return list;
}

void add_judgement(Json& json, const diagnosis::Judgement& judgement, std::span<const ShownEffect> effects) {
  const auto name_of = [](plant::EffectId id) { return plant::effect_info(id).name; };
  for (const ShownEffect& effect : effects) {
    json["effects"].push_back(json_of(effect));
  }
  for (const auto& [one, other] : judgement.alternatives) {
    json["alternatives"].push_back(Json::array({name_of(one), name_of(other)}));
  }
  for (const plant::EffectId id : judgement.not_judged) {
    json["not_judged"].push_back(name_of(id));
  }
}

std::string text_of(const Json& json) {
  constexpr int kIndent = 2;
  // Names of files may be no UTF-8: replaced rather than thrown about. Numbers that are not finite become null.
  return json.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Done> write_diagnosis_text(const std::string& path, const std::string& text) {
  return replace_file(path, text);
}

}  // namespace farrier::report
