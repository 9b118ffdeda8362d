#include "trials/body/push_limit.hpp"

#include <algorithm>
#include <cmath>

#include "config/visitor.hpp"

namespace farrier::trials {
namespace {

const int kLargestSteps = static_cast<int>(std::lround(PushLimitSearch::kLargest_Ns / PushLimitSearch::kResolution_Ns));

}  // namespace

PushLimitSearch::PushLimitSearch(const robot::Robot& robot) : robot_(robot) {}

int PushLimitSearch::Interval::next() const noexcept { return half ? (fewer + *half) / 2 : kLargestSteps; }

double PushLimitSearch::impulse_Ns(int steps) const { return scaled_impulse_Ns(robot_, steps * kResolution_Ns); }

std::vector<TrotCase> PushLimitSearch::next() const {
  std::vector<TrotCase> cases;
  for (std::size_t side = 0; side < sides_.size(); ++side) {
    for (int phase = 0; phase < kPushPhases && !sides_[side].ended(); ++phase) {
      const double impulse = impulse_Ns(sides_[side].next());
      cases.push_back(push_case(robot_, kTrial, kPushSides[side], impulse, phase));
      cases.back().name = config::number_text(impulse) + " Ns " + cases.back().name;
    }
  }
  return cases;
}

void PushLimitSearch::take(std::span<const TrotRow> rows) {
  const std::vector<TrotCase> cases = next();
  std::array<int, kPushSides.size()> falls{};
  std::size_t number = 0;
  for (std::size_t side = 0; side < sides_.size(); ++side) {
    if (sides_[side].ended()) {
      continue;
    }
    for (int phase = 0; phase < kPushPhases; ++phase) {
      const std::string& name = cases[number++].name;
      const auto row =
          std::ranges::find_if(rows, [&name](const TrotRow& one) { return one.trial == kTrial && one.name == name; });
      const bool stood = row != rows.end() && row->failure.empty() && !row->figures.fell_s;
      falls[side] += stood ? 0 : 1;
    }
    const int tested = sides_[side].next();
    if (2 * falls[side] >= kPushPhases) {
      sides_[side].half = tested;
    } else {
      sides_[side].fewer = tested;
    }
  }
}

std::vector<PushLimit> PushLimitSearch::limits() const {
  std::vector<PushLimit> limits;
  for (std::size_t side = 0; side < sides_.size(); ++side) {
    const Interval& of = sides_[side];
    limits.push_back(
        {kPushSides[side].name, impulse_Ns(of.fewer), of.half ? std::optional(impulse_Ns(*of.half)) : std::nullopt});
  }
  return limits;
}

}  // namespace farrier::trials
