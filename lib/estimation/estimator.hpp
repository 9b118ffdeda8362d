#pragma once

// The common interface of a joint's estimators: the rest of the loop knows no other type.

#include <Eigen/Core>

#include <cstdint>
#include <memory>

#include "core/choice.hpp"
#include "core/result.hpp"
#include "core/time.hpp"
#include "plant/joint_physics.hpp"

namespace farrier::estimation {

/// Divisors of (3.52), (3.53), and prior knowledge of the joint. Position relative to home.
struct JointScales {
  Eigen::Vector3d state;         ///< position, velocity, force: m, m/s, N or rad, rad/s, Nm; > 0
  double current_A = 0;          ///< > 0
  Eigen::Vector3d sensor_noise;  ///< standard deviations, in the units of `state`; >= 0
  double home_position = 0;      ///< m or rad
  double period_s = 0;           ///< > 0
  int input_delay_ticks = 0;     ///< ticks from a command's sample to the plant, 0..2
};

/// Refuses scales out of range with a sentence that names them.
Result<Done> validate(const JointScales& scales);

/// One tick of one joint.
struct JointSample {
  Tick tick = kNoTick;
  Eigen::Vector3d state;          ///< position, velocity, force as measured
  double current_A = 0;           ///< commanded, acts from this tick on
  int phase = 0;                  ///< 0 or 1: the phase whose gains acted
  double force_error = 0;         ///< reference less measured force, N or Nm; 0 if unknown
  double supply_pressure_Pa = 0;  ///< as measured; 0 if unknown
};

/// Reasons for an estimate's state; bits of JointModelEstimate::flags. Hubacher (2014), Table F.1 shares the names.
enum class EstimateFlag : std::uint32_t {
  kNotYetSet = 1u << 0,           ///< too few samples of this phase so far
  kRegressorTooSmall = 1u << 1,   ///< the last sample was left out (6.24)
  kCovarianceRepaired = 1u << 2,  ///< the covariance was beyond repair and was reset
  kSampleRefused = 1u << 3,       ///< the last sample was not finite, or beyond 1e40 normalised
  kMappedToStable = 1u << 4,      ///< a pole beyond the limit was put on it
  kEigenvalueError = 1u << 5,     ///< the poles could not be mapped
  kBlanked = 1u << 6,             ///< a switch of phase is too recent
  kNotPhysical = 1u << 7,         ///< opening the valve would lower the force, or a force brake the load
  kMisfit = 1u << 8,              ///< errors of force predictions exceed kMisfitFree times those from noise
  kNotExciting = 1u << 9,         ///< the gate was closed: the last sample was left out (9.4), (9.5)
  kForgettingAtLimit = 1u << 10,  ///< the covariance at its bound: the last sample was not forgotten for in full
  kInstrumentRefused = 1u << 11,  ///< the last sample was taken with the regressor for its instrument (B.18)
  kCountsAsStronger = 1u << 12,   ///< the valve has become stronger, and counts as such until it is estimated again
};

/// Every flag, by its name in reports.
inline constexpr Option<EstimateFlag> kEstimateFlags[] = {{"not yet set", EstimateFlag::kNotYetSet},
                                                          {"regressor too small", EstimateFlag::kRegressorTooSmall},
                                                          {"covariance repaired", EstimateFlag::kCovarianceRepaired},
                                                          {"sample refused", EstimateFlag::kSampleRefused},
                                                          {"mapped to stable", EstimateFlag::kMappedToStable},
                                                          {"eigenvalues", EstimateFlag::kEigenvalueError},
                                                          {"blanked", EstimateFlag::kBlanked},
                                                          {"not physical", EstimateFlag::kNotPhysical},
                                                          {"misfit", EstimateFlag::kMisfit},
                                                          {"not exciting", EstimateFlag::kNotExciting},
                                                          {"forgetting at limit", EstimateFlag::kForgettingAtLimit},
                                                          {"instrument refused", EstimateFlag::kInstrumentRefused},
                                                          {"counts as stronger", EstimateFlag::kCountsAsStronger}};

constexpr std::uint32_t bit(EstimateFlag flag) noexcept { return static_cast<std::uint32_t>(flag); }

/// Normalised signals beyond this are refused, because their square would not be finite.
inline constexpr double kLargestSignal = 1e40;

/// x[k+1] = A x[k] + B u[k] + c for the washout's output, SI, position relative to home.
struct ModelEstimate {
  Eigen::Matrix3d a = Eigen::Matrix3d::Identity();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  Eigen::Vector3d c = Eigen::Vector3d::Zero();
  Eigen::Matrix3d a_error = Eigen::Matrix3d::Zero();  ///< standard errors
  Eigen::Vector3d b_error = Eigen::Vector3d::Zero();  ///< of the force row: with the contribution of misfit,
                                                      ///< kMisfitError
  double validity = 0;  ///< 0..1; 0 when a flag forbids use: 1 - (larger standard error of a pole) / kUselessPoleError
  double excitation = 0;        ///< lower bound of the information matrix's smallest eigenvalue, 1 / trace(P)
  double prediction_error = 0;  ///< RMS error of force predictions over that from noise and model_error; 0: neither
  double whiteness = 1;         ///< of these errors, PredictionErrors::whiteness(), 0..1
  std::uint32_t samples = 0;
  std::uint32_t flags = 0;  ///< EstimateFlag
  int phase = 0;
  bool has_physics = false;  ///< the estimator knows the joint's structure: the next two are set
  plant::JointPhysics physics{};
  plant::JointPhysics physics_error{};  ///< standard errors; 0 for values taken as known
};

/// Estimates one joint's dynamics from its measurements and commands. No clock, no I/O, no allocation after creation.
class Estimator {
 public:
  virtual ~Estimator() = default;

  /// Takes one tick. Samples that are not finite or out of range change no estimate and set kSampleRefused.
  virtual void take(const JointSample& sample) noexcept = 0;

  /// Estimate for the phase of the last sample.
  virtual ModelEstimate estimate() const noexcept = 0;

  /// A copy with the same knowledge, which learns independently from now on.
  virtual std::unique_ptr<Estimator> clone() const = 0;
};

}  // namespace farrier::estimation
