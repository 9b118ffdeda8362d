#include "report/diagnosis/wiring_picture.hpp"

#include <algorithm>
#include <vector>

#include "report/diagnosis/diagnosis_pictures.hpp"

namespace farrier::report {
namespace {

using diagnosis::LawOverTime;
using diagnosis::WiringLaw;

constexpr std::size_t kMostPoints = 4000;

/// Words of a law: its left side with its unit, the columns of its right side, and their verb.
struct Words {
  std::string left, unit, right, say;
};

Words words_of(WiringLaw law, bool rotary) {
  const std::string force = rotary ? "torque" : "force";
  switch (law) {
    case WiringLaw::kKinematics:
      return {"velocity", rotary ? "rad/s" : "m/s", "the position", "says"};
    case WiringLaw::kLoadByPosition:
      return {force, rotary ? "Nm" : "N", "the position", "says"};
    case WiringLaw::kLoadByVelocity:
      return {force, rotary ? "Nm" : "N", "the velocity", "says"};
    case WiringLaw::kActuatorByPosition:
      return {"current", "A", force + " and position", "say"};
    case WiringLaw::kActuatorByVelocity:
      return {"current", "A", force + " and velocity", "say"};
    case WiringLaw::kCell:
    case WiringLaw::kLevels:
      break;
  }
  return {force, rotary ? "Nm" : "N", "the pressures", "say"};
}

Panel panel_of(const LawOverTime& sides, const WorstWindow& window, const Words& words, const std::string& title) {
  Series left{.label = words.left + " as measured"};
  Series right{.label = "by " + words.right, .style = Style::kDashed, .colour = 2};
  const std::size_t end = std::min(window.begin + window.size, sides.time_s.size());
  const std::size_t stride = 1 + window.size / kMostPoints;
  for (std::size_t i = window.begin; i < end; i += stride) {
    left.add(sides.time_s[i], sides.left[i]);
    right.add(sides.time_s[i], sides.right[i]);
  }
  return {.title = title,
          .x_label = "time / s",
          .y_label = words.left + " / " + words.unit,
          .series = {std::move(left), std::move(right)},
          .x_range = Range{sides.time_s[window.begin], sides.time_s[end - 1]}};
}

}  // namespace

std::string add_wiring_picture(Drawing& drawing, const diagnosis::WiringEvidence& evidence, const robot::Joint& joint) {
  const LawOverTime& recorded = evidence.recorded;
  if (recorded.time_s.size() < 2) {
    return "";
  }
  const double period_s = recorded.time_s[1] - recorded.time_s[0];
  const WorstWindow window = worst_second(recorded.left, recorded.right, period_s);
  const Words words = words_of(evidence.law, joint.rotary);
  std::vector<Panel> panels{panel_of(recorded, window, words, "as recorded")};
  if (!evidence.mended.time_s.empty()) {
    panels.push_back(panel_of(evidence.mended, window, words, "with the fault undone"));
    for (Series& series : panels.back().series) {
      series.label.clear();
    }
  }
  const double height_px = panels.size() > 1 ? 520.0 : 280.0;
  return drawing.add("wiring", {.panels = std::move(panels), .key = Key::kAbove, .height_px = height_px});
}

std::string wiring_caption(const diagnosis::WiringEvidence& evidence, const robot::Joint& joint) {
  const Words words = words_of(evidence.law, joint.rotary);
  const std::string first =
      words.left + " as measured, and as " + words.right + " " + words.say + " by a law of the joint";
  return evidence.mended.time_s.empty()
             ? first + ", with its numbers as near to the measurement as effects can bring them"
             : first + "; below with the fault undone";
}

}  // namespace farrier::report
