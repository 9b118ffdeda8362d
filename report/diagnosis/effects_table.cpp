#include "report/diagnosis/effects_table.hpp"

#include <string_view>

#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

using plant::Scale;

const char* text_of(Scale scale) {
  switch (scale) {
    case Scale::kOne:
    case Scale::kSecond:
    case Scale::kRate:
      return "";
    case Scale::kCurrent:
      return "largest current";
    case Scale::kForce:
      return "full push";
    case Scale::kLength:
      return "stroke";
    case Scale::kSpeed:
      return "full speed";
    case Scale::kLeakage:
      return "full flow / supply pressure";
    case Scale::kDroop:
      return "supply pressure / full flow";
    case Scale::kMass:
      return "the model's";
    case Scale::kDamping:
      return "the model's, or 0.01 full push / full speed";
    case Scale::kStiffness:
      return "the model's, or 0.2 full push / stroke";
    case Scale::kCubic:
      return "stiffness / stroke^2";
  }
  return "";
}

std::string both(std::string_view linear, std::string_view rotary, std::string_view quote) {
  const std::string one = std::string(quote) + std::string(linear) + std::string(quote);
  return linear == rotary ? one : one + ", " + std::string(quote) + std::string(rotary) + std::string(quote);
}

std::string range_text(const plant::Parameter& p) {
  const plant::ParameterRange ends = p.multiples();
  const std::string_view scale = text_of(p.scale);
  return short_number(ends.low) + " to " + short_number(ends.high) +
         (scale.empty() ? "" : " times " + std::string(scale));
}

}  // namespace

const char* place_of(plant::Side side) noexcept {
  switch (side) {
    case plant::Side::kValveAndOil:
      return "valve and oil";
    case plant::Side::kLoad:
      return "load";
    case plant::Side::kForceSensor:
      return "force sensor";
    case plant::Side::kVelocitySensor:
      return "velocity sensor";
  }
  return "";
}

std::string effects_table_markdown() {
  std::string table = "| effect | place | parameter | unit | range | meaning |\n|---|---|---|---|---|---|\n";
  for (plant::EffectId id = 0; id < plant::kEffectCount; ++id) {
    const plant::EffectInfo& info = plant::effect_info(id);
    for (const plant::Parameter& p : info.parameters) {
      const bool first = &p == info.parameters.data();
      table += "| " + (first ? "`" + std::string(info.name) + "`" : std::string()) + " | " +
               (first ? place_of(info.side) : "") + " | " + both(p.name, p.rotary_name, "`") + " | " +
               both(p.unit, p.rotary_unit, "") + " | " + range_text(p) + " | " +
               (first ? std::string(info.meaning) + " " : std::string()) + p.meaning + " |\n";
    }
  }
  return table;
}

}  // namespace farrier::report
