#include "estimation/sliding_dft.hpp"

#include <algorithm>
#include <cmath>

#include "core/portable_math.hpp"

namespace farrier::estimation {

SlidingDft::SlidingDft(int window)
    : window_(static_cast<std::size_t>(window)),
      cosine_(window_.size()),
      sine_(window_.size()),
      sum_(window_.size() / 2 - 1),
      fresh_(sum_.size()) {
  for (std::size_t n = 0; n < window_.size(); ++n) {
    const double turns = static_cast<double>(n) / static_cast<double>(window_.size());
    cosine_[n] = portable::cos_of_turns(turns);
    sine_[n] = portable::sin_of_turns(turns);
  }
}

// S_k[n] = S_k[n-1] + (x[n] - x[n-N]) exp(-2 pi i k n / N), Duda (2010), the sum before it is turned back.
void SlidingDft::take(double sample) noexcept {
  const std::size_t length = window_.size();
  const double change = sample - window_[next_];
  window_[next_] = sample;
  std::size_t turn = 0;  // k n modulo N
  for (std::size_t bin = 0; bin < sum_.size(); ++bin) {
    turn += next_;
    turn -= turn >= length ? length : 0;
    sum_[bin].real += change * cosine_[turn];
    sum_[bin].imaginary -= change * sine_[turn];
    fresh_[bin].real += sample * cosine_[turn];
    fresh_[bin].imaginary -= sample * sine_[turn];
  }
  if (++next_ == length) {
    next_ = 0;
    full_ = true;
    sum_.swap(fresh_);
    std::fill(fresh_.begin(), fresh_.end(), Bin{});
  }
}

void SlidingDft::reset() noexcept {
  std::fill(window_.begin(), window_.end(), 0.0);
  std::fill(sum_.begin(), sum_.end(), Bin{});
  std::fill(fresh_.begin(), fresh_.end(), Bin{});
  next_ = 0;
  full_ = false;
}

double SlidingDft::power(int k) const noexcept {
  const Bin& bin = sum_[static_cast<std::size_t>(k - 1)];
  return bin.real * bin.real + bin.imaginary * bin.imaginary;
}

}  // namespace farrier::estimation
