#pragma once

#include <cstddef>
#include <vector>

namespace farrier::estimation {

/// Discrete Fourier transform of the last N samples of a signal, updated by a sample in O(N). Samples that enter and
/// leave the window are modulated to each frequency and added. The sum therefore has no pole and no phase to drift
/// (Duda 2010, "Accurate, guaranteed stable, sliding discrete Fourier transform", IEEE Signal Processing Magazine
/// 27(6)). A second sum restarts with every N samples and replaces the first each time it is complete. Rounding and the
/// trace of a huge sample therefore last for 2 N samples at most.
class SlidingDft {
 public:
  /// `window` samples, even, at least 4. Allocates here and nowhere else.
  explicit SlidingDft(int window);

  void take(double sample) noexcept;

  void reset() noexcept;

  /// True if the window has been filled.
  bool full() const noexcept { return full_; }

  /// Frequencies of bins 1 .. N/2 - 1; bin k is k / (N T).
  int bins() const noexcept { return static_cast<int>(sum_.size()); }

  /// |sum_n x[n] exp(-2 pi i k n / N)|^2 over the window, of bin `k`, 1 .. bins(); missing samples are 0.
  double power(int k) const noexcept;

 private:
  struct Bin {
    double real = 0.0, imaginary = 0.0;
  };

  std::vector<double> window_;
  std::vector<double> cosine_, sine_;  // of 2 pi n / N
  std::vector<Bin> sum_, fresh_;       // of bin k at k - 1
  std::size_t next_ = 0;               // place in the window, and time modulo N
  bool full_ = false;
};

}  // namespace farrier::estimation
