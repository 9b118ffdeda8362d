#include "thesis/study/study.hpp"

#include <cmath>

#include "config/problem.hpp"

namespace farrier::thesis {

Error stopped() { return Error{"the study was stopped before its end"}; }

bool keep_going(const StudyContext& context, double share) { return !context.progress || context.progress(share); }

Result<robot::Robot> load(const StudyContext& context, const std::string& file) {
  auto loaded = robot::load_robot(context.robots + "/" + file);
  if (!loaded) {
    return Error{config::to_string(loaded.error())};
  }
  return std::move(loaded).value();
}

std::vector<double> linear_space(double low, double high, std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = low + (high - low) * static_cast<double>(i) / static_cast<double>(count - 1);
  }
  return values;
}

std::vector<double> log_space(double low, double high, std::size_t count) {
  std::vector<double> values = linear_space(std::log(low), std::log(high), count);
  for (double& value : values) {
    value = std::exp(value);
  }
  return values;
}

}  // namespace farrier::thesis
