#include "diagnosis/judge/remainder.hpp"

#include <cmath>

#include "diagnosis/data/sample_statistics.hpp"

namespace farrier::diagnosis {

double visible_beside_noise(double share) noexcept {
  const double kept = 1.0 - share;
  return std::sqrt(1.0 / (kept * kept) - 1.0);
}

std::array<Remainder, kChannels> remainder(const Bench& bench, const Hypothesis& hypothesis,
                                           const ExpectedResiduals& expected_residuals) {
  std::array<Remainder, kChannels> left{};
  const auto expected = expected_residuals(hypothesis);
  const double warm = 2.0 * bench.options().warm_up_s / bench.simulator().period_s();
  for (std::size_t c = 0; c < kChannels; ++c) {
    if (bench.fit_data().judged[c]) {
      const double count = static_cast<double>(bench.simulator().size()) - warm;
      left[c].rms = std::sqrt(hypothesis.total(c) / count);
      left[c].expected = expected[c];
      left[c].nrmse = left[c].rms / standard_deviation(bench.simulator().measured(static_cast<Channel>(c)));
    }
  }
  return left;
}

}  // namespace farrier::diagnosis
