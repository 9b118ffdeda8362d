#include "estimation/excitation_gate.hpp"

#include <Eigen/Cholesky>

#include <cmath>

#include "control/numerics/symmetric_eigen.hpp"

namespace farrier::estimation {
namespace {

constexpr int kShortestWindow = 8;
constexpr int kLongestPersistence = 4096;
constexpr int kLongestSpectrum = 1024;  // a tick works on every frequency
constexpr int kLeastColumns = 3;

bool positive_definite(const Eigen::Matrix4d& m) noexcept {
  return m.allFinite() && Eigen::LLT<Eigen::Matrix4d>(m).info() == Eigen::Success;
}

}  // namespace

PersistenceGate::PersistenceGate(const PersistenceParams& params, int columns)
    : params_(params),
      columns_(columns),
      window_(static_cast<std::size_t>(params.window_ticks), Eigen::Vector4d::Zero()) {}

void PersistenceGate::observe(const Eigen::Vector4d& signal) noexcept {
  Eigen::Vector4d h = signal;
  h.head(4 - columns_).setZero();
  Eigen::Vector4d& oldest = window_[next_];
  gram_ += h * h.transpose() - oldest * oldest.transpose();
  fresh_ += h * h.transpose();
  oldest = h;
  if (++next_ == window_.size()) {
    next_ = 0;
    full_ = true;
    gram_ = fresh_;  // rounding of what has left is gone
    fresh_.setZero();
  }
}

void PersistenceGate::reset() noexcept {
  std::fill(window_.begin(), window_.end(), Eigen::Vector4d::Zero());
  gram_.setZero();
  fresh_.setZero();
  next_ = 0;
  full_ = false;
}

// (9.4) corrected
bool PersistenceGate::open() const noexcept {
  if (!full_) {
    return false;
  }
  Eigen::Matrix4d above = gram_;
  above.diagonal().array() -= params_.information_min;
  above.diagonal().head(4 - columns_).setOnes();  // no column of the regressor
  Eigen::Matrix4d below = -gram_;
  below.diagonal().array() += params_.information_max;
  return positive_definite(above) && positive_definite(below);
}

Eigen::Vector2d PersistenceGate::singular_values() const noexcept {
  const control::SymmetricEigen<4> eigen = control::symmetric_eigen<4>(gram_);
  // A column that is not there has the eigenvalue 0, which comes first.
  return {std::abs(eigen.values(4 - columns_)), std::abs(eigen.values(3))};
}

SpectrumGate::SpectrumGate(const SpectrumParams& params, int columns)
    : params_(params), dfts_(static_cast<std::size_t>(columns), SlidingDft(params.window_ticks)) {}

void SpectrumGate::observe(const Eigen::Vector4d& signal) noexcept {
  auto column = signal.size() - static_cast<Eigen::Index>(dfts_.size());
  for (SlidingDft& dft : dfts_) {
    dft.take(signal(column++));
  }
}

void SpectrumGate::reset() noexcept {
  for (SlidingDft& dft : dfts_) {
    dft.reset();
  }
}

// A sine of amplitude M on a bin has |S_k| = M N / 2.
int SpectrumGate::frequencies() const noexcept {
  const double least = 0.5 * params_.magnitude_min * params_.window_ticks;
  int count = 0;
  for (const SlidingDft& dft : dfts_) {
    for (int k = 1; k <= dft.bins(); ++k) {
      count += dft.power(k) > least * least ? 1 : 0;
    }
  }
  return count;
}

Result<ExcitationGate> ExcitationGate::create(const EstimatorParams& params) {
  switch (params.gate) {
    case GateKind::kNone: break;
    case GateKind::kPe: {
      const PersistenceParams pe = params.pe.value_or(PersistenceParams{});
      if (pe.window_ticks < kShortestWindow || pe.window_ticks > kLongestPersistence) {
        return Error{"pe.window_ticks must be 8 to 4096"};
      }
      if (!(pe.information_min >= 0.0 && pe.information_min < pe.information_max && std::isfinite(pe.information_max))) {
        return Error{"pe.information_min must not be negative, pe.information_max above it and finite"};
      }
      return ExcitationGate(PersistenceGate(pe, params.position ? 4 : kLeastColumns));
    }
    case GateKind::kFft: {
      const SpectrumParams fft = params.fft.value_or(SpectrumParams{});
      if (fft.window_ticks < kShortestWindow || fft.window_ticks > kLongestSpectrum || fft.window_ticks % 2 != 0) {
        return Error{"fft.window_ticks must be even, 8 to 1024"};
      }
      if (!(fft.magnitude_min > 0.0 && std::isfinite(fft.magnitude_min))) {
        return Error{"fft.magnitude_min must be positive"};
      }
      if (fft.frequencies_min < 0 || fft.frequencies_min >= kLeastColumns * (fft.window_ticks / 2 - 1)) {
        return Error{"fft.frequencies_min must be below the number of frequencies, 3 (fft.window_ticks / 2 - 1)"};
      }
      return ExcitationGate(SpectrumGate(fft, params.position ? 4 : kLeastColumns));
    }
  }
  return ExcitationGate(std::monostate{});
}

void ExcitationGate::observe(const Eigen::Vector4d& signal) noexcept {
  if (auto* pe = std::get_if<PersistenceGate>(&kind_)) {
    pe->observe(signal);
  } else if (auto* fft = std::get_if<SpectrumGate>(&kind_)) {
    fft->observe(signal);
  }
}

void ExcitationGate::reset() noexcept {
  if (auto* pe = std::get_if<PersistenceGate>(&kind_)) {
    pe->reset();
  } else if (auto* fft = std::get_if<SpectrumGate>(&kind_)) {
    fft->reset();
  }
}

bool ExcitationGate::open() const noexcept {
  if (const auto* pe = std::get_if<PersistenceGate>(&kind_)) {
    return pe->open();
  }
  const auto* fft = std::get_if<SpectrumGate>(&kind_);
  return fft == nullptr || fft->open();
}

}  // namespace farrier::estimation
