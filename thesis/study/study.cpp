#include "thesis/study/study.hpp"

#include <cmath>
#include <cstdio>

#include "config/problem.hpp"

namespace farrier::thesis {

const char* to_string(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::kHolds: return "holds";
    case Verdict::kRefuted: return "refuted";
    case Verdict::kFails: return "fails";
  }
  return "";
}

namespace {

bool related(Relation relation, double value, double bound) noexcept {
  switch (relation) {
    case Relation::kAtMost: return value <= bound;
    case Relation::kBelow: return value < bound;
    case Relation::kAtLeast: return value >= bound;
  }
  return false;
}

}  // namespace

Verdict judge(const ClaimSpec& claim, double value) noexcept {
  if (!std::isfinite(value)) {
    return Verdict::kFails;
  }
  if (related(claim.relation, value, claim.bound)) {
    return Verdict::kHolds;
  }
  const auto& refutation = claim.refutation;
  return refutation && value >= refutation->at_least && value <= refutation->at_most ? Verdict::kRefuted
                                                                                     : Verdict::kFails;
}

Error stopped() { return Error{"the study was stopped before its end"}; }

bool keep_going(const StudyContext& context, double share) { return !context.progress || context.progress(share); }

Result<robot::Robot> load(const StudyContext& context, const std::string& file) {
  auto loaded = robot::load_robot(context.robots + "/" + file);
  if (!loaded) {
    return Error{config::to_string(loaded.error())};
  }
  return std::move(loaded).value();
}

std::string text_of(const char* format, double value) {
  char text[96];
  std::snprintf(text, sizeof text, format, value);
  return text;
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
