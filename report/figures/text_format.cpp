#include "report/figures/text_format.hpp"

#include <algorithm>
#include <cmath>

#include "core/number_as.hpp"

namespace farrier::report {

std::string short_number(double value) {
  if (!std::isfinite(value)) {
    return "-";
  }
  constexpr double kLongestWhole = 1e15;
  const bool whole = value == std::floor(value) && std::abs(value) < kLongestWhole;
  return number_as(whole ? "%.0f" : "%.4g", value);
}

std::string value_with_unit(const Figure& figure) {
  const std::string_view unit = figure.spec->unit;
  return short_number(figure.value) + (unit == "1" ? "" : " " + std::string(unit));
}

std::string bound_text(const Figure& figure) {
  return figure.bound ? std::string(to_string(figure.spec->relation)) + " " + short_number(*figure.bound) : "";
}

std::vector<std::string> joints_of(const Figures& figures) {
  std::vector<std::string> joints;
  for (const Figure& figure : figures.all()) {
    if (const auto names = match("trot.<joint>.stance_nrmse", figure.name)) {
      joints.emplace_back(names->front());
    }
  }
  return joints;
}

std::vector<std::string> reasons_to_fail(const Figures& figures, const std::vector<std::string>& failures) {
  std::vector<std::string> reasons = failures;
  for (const Figure& figure : figures.all()) {
    if (!figure.holds()) {
      reasons.push_back(figure.name + " " + value_with_unit(figure) + ", must be " + bound_text(figure));
    }
  }
  return reasons;
}

std::vector<std::string> topic_texts(const ProcessInfo& process) {
  std::vector<std::string> texts;
  for (const TopicCount& topic : process.topics) {
    if (topic.sent > 0) {
      texts.push_back(topic.topic + " " + std::to_string(topic.sent) + " out");
    }
    if (topic.received + topic.lost > 0) {
      texts.push_back(topic.topic + " " + std::to_string(topic.received) + " in" +
                      (topic.lost > 0 ? " (" + std::to_string(topic.lost) + " lost)" : ""));
    }
  }
  return texts;
}

std::string aligned(const std::vector<std::vector<std::string>>& rows, const std::string& indent) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], row[i].size());
    }
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line = indent;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i] + std::string(widths[i] - row[i].size() + 2, ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

}  // namespace farrier::report
