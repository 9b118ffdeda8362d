#pragma once

// Decides if a joint's present motion is worth learning from (Hubacher 2014, 9.1.2). For any estimator.

#include <Eigen/Core>

#include <variant>
#include <vector>

#include "core/result.hpp"
#include "estimation/estimator_params.hpp"
#include "estimation/sliding_dft.hpp"

namespace farrier::estimation {

/// Persistence of excitation: alpha I <= G <= beta I, G = sum h h' over the window (Hubacher 2014, (9.4), corrected: the
/// printed h'h is not the Gram matrix of the parameters). Closed until the window is full.
class PersistenceGate {
 public:
  /// The last `columns` of a signal are the regressor: 3, or 4 with the position.
  PersistenceGate(const PersistenceParams& params, int columns);

  void observe(const Eigen::Vector4d& signal) noexcept;
  void reset() noexcept;

  /// By two Cholesky factorisations, of G - alpha I and beta I - G: no singular value is computed.
  bool open() const noexcept;

  /// Smallest and largest singular value of G, Fig. 9.6.
  Eigen::Vector2d singular_values() const noexcept;

 private:
  PersistenceParams params_;
  int columns_;
  std::vector<Eigen::Vector4d> window_;  // zero in columns outside the regressor
  Eigen::Matrix4d gram_ = Eigen::Matrix4d::Zero();
  Eigen::Matrix4d fresh_ = Eigen::Matrix4d::Zero();  // of the samples since the window began at its first place
  std::size_t next_ = 0;
  bool full_ = false;
};

/// Frequencies of the signals: open while more than f_min of them, counted over all signals, have an amplitude above
/// M_min. Hubacher (2014), (9.5), whose Y is the "input measurement vector". The printed sum over the window is left
/// out: it counts the same window repeatedly. Closed until the window is full.
class SpectrumGate {
 public:
  /// Uses the last `columns` of a signal: 3, or 4 with the position.
  SpectrumGate(const SpectrumParams& params, int columns);

  void observe(const Eigen::Vector4d& signal) noexcept;
  void reset() noexcept;
  bool open() const noexcept { return dfts_.front().full() && frequencies() > params_.frequencies_min; }

  /// Number of the N/2 - 1 frequencies of each signal with an amplitude above M_min, Fig. 9.7.
  int frequencies() const noexcept;

 private:
  SpectrumParams params_;
  std::vector<SlidingDft> dfts_;
};

/// The gate of the parameters, or none, which is always open.
class ExcitationGate {
 public:
  /// Refuses settings out of range by name.
  static Result<ExcitationGate> create(const EstimatorParams& params);

  /// Takes one tick's position, velocity, force and current, normalised; |signal| <= 1e40. Ticks must be consecutive:
  /// after a gap, call reset() first.
  void observe(const Eigen::Vector4d& signal) noexcept;

  void reset() noexcept;

  /// True if the last tick may teach.
  bool open() const noexcept;

 private:
  using Kind = std::variant<std::monostate, PersistenceGate, SpectrumGate>;
  explicit ExcitationGate(Kind kind) : kind_(std::move(kind)) {}

  Kind kind_;
};

}  // namespace farrier::estimation
