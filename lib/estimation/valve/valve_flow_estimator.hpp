#pragma once

// Gain, overlap and leakage of a joint's valve, from the oil side of the load cell:
//
//   i_v ──▶ ValveDynamics ──▶ parts of the flow ──▶ Rls ──▶ estimate()
//   x, v, F_s ──▶ flow ─────────────────────────────▲

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <limits>

#include "core/result.hpp"
#include "estimation/estimator.hpp"
#include "estimation/estimator_params.hpp"
#include "estimation/prediction_errors.hpp"
#include "estimation/rls.hpp"
#include "estimation/valve/chamber_oil.hpp"
#include "estimation/valve/oscillation_monitor.hpp"
#include "plant/load_pressure.hpp"
#include "plant/terms/valve_dynamics.hpp"

namespace farrier::estimation {

/// Knowledge of a joint's valve before any sample.
struct KnownValve {
  double leakage = 0.0;                ///< between the chambers, m^3/s/Pa; >= 0
  double overlap_A = 0.0;              ///< >= 0
  plant::ValveDynamics<double> spool;  ///< as the data sheet has it
};

/// Least squares on the equation of the load pressure, Hubacher (2014), (3.22) to (3.33), with the overlap d and the
/// leakage c of the flow law in it.
///
///   A_p v + F_h' / (A_p k) = K_v / sqrt(1 + alpha^3) root(drop) (u - d sign u) - c p_c
///
/// Here k is the rate of the load pressure per flow, and p_c is plant::leakage_pressure_Pa(). The left side is
/// measured. Everything on the right side is known but K_v, K_v d and c, which are linear in it. The drop depends on
/// the force that the piston's damping takes; what that has grown by is a fourth parameter, linearised, which is not
/// told. A fifth is the oil's compressibility over the nominal one, less one, times F_h' / (A_p k). No load is in it:
/// other joints and contacts may do what they will behind the cell (docs/decisions/0077-valve-flow.md). One estimate
/// serves both phases, for the valve does not know them. A valve that is shut teaches nothing, nor does one whose
/// chambers are not in steady flow (ChamberOil). The samples begin where the port is open by least_opening beyond the
/// overlap.
///
/// Flow errors beyond the usual ones mean that the valve has changed, and it is estimated from the start, with what is known
/// of the damping and the oil. If it lets more through than expected, or if the force loop oscillates (OscillationMonitor),
/// it counts as stronger by gain_uncertainty at once: the flag kCountsAsStronger is set until there are min_samples again.
/// A law for a weaker valve than there is may be unstable. If the loop oscillates again and the valve is the same, the oil
/// counts as stiffer: the loop's gain goes with the valve's and with the bulk modulus.
///
/// The load of the prior is kept, and the linear model follows from it with the estimated gain.
class ValveFlowEstimator final : public Estimator {
 public:
  /// Uses valve_flow (absent: its defaults) and min_samples of `params`; a gate is refused. The loads are those of swing
  /// and stance. Refuses settings out of range, actuators and loads that no machine has, naming each.
  static Result<ValveFlowEstimator> create(const EstimatorParams& params, const JointScales& scales,
                                           const plant::ActuatorParams& actuator,
                                           const std::array<plant::LoadParams, 2>& loads, const KnownValve& known);

  /// Takes one tick; `current_A` is the one that was sent. After a gap the spool is taken to rest at the sent current.
  void take(const JointSample& sample) noexcept override;

  /// Valve and leakage, with the load of the phase of the last sample. Its validity is 1 less the relative standard error
  /// of the gain over kUselessGainError.
  ModelEstimate estimate() const noexcept override;

  std::unique_ptr<Estimator> clone() const override { return std::make_unique<ValveFlowEstimator>(*this); }

 private:
  static constexpr int kParameters = 5;
  using Parameters = Eigen::Matrix<double, kParameters, 1>;
  static constexpr int kGainPart = 0, kOverlapPart = 1, kLeakagePart = 2, kCompressibilityPart = 4;  // 3: damping
  static constexpr int kValveParts = 3;                 ///< gain, overlap and leakage come first
  static constexpr double kLeastCompressibility = 0.5;  ///< over the nominal one
  static constexpr double kLeastGain = 0.05;            ///< share of the nominal gain; a smaller one is no valve's
  /// Shares of the open valve's flow: the flow, its parts for a unit of each parameter, and the sizes of what compression
  /// takes of it and of what a wrong supply pressure does to it.
  using Terms = Eigen::Matrix<double, kParameters + 3, 1>;

  ValveFlowEstimator(const EstimatorParams& params, const ValveFlowParams& own, const JointScales& scales,
                     const plant::ActuatorParams& actuator, const std::array<plant::LoadParams, 2>& loads,
                     const KnownValve& known, const Rls<kParameters>& regression) noexcept;

  Terms terms(const Eigen::Vector3d& state, double opening_A) const noexcept;
  void take_opening(const Eigen::Vector3d& state, double opening_A) noexcept;
  plant::OperatingPoint point_of(const Eigen::Vector3d& state) const noexcept;
  void interrupt() noexcept;
  void smooth(const Terms& now) noexcept;
  void learn() noexcept;
  void watch(const JointSample& sample) noexcept;
  void count_as_stronger() noexcept;
  void count_as_stiffer() noexcept;
  void begin_from(const Rls<kParameters>::Parameters& parameters) noexcept;
  /// Gain over the nominal one, overlap as a share of full current, leakage as a share, damping and compressibility beyond
  /// the nominal ones as shares of those.
  Parameters linear_parts() const noexcept;
  Parameters parameters() const noexcept;
  Parameters standard_errors() const noexcept;
  /// Compressibility of the oil over the nominal one: held after a change of the valve, until enough samples tell it from that.
  double compressibility() const noexcept;

  EstimatorParams params_;
  ValveFlowParams own_;
  JointScales scales_;
  plant::ActuatorParams actuator_;
  plant::ActuatorParams supplied_;  ///< the same at the supply's measured pressure
  double supply_error_;             ///< share of that pressure
  std::array<plant::LoadParams, 2> loads_;
  double open_flow_m3_s_;  ///< nominal, at supply pressure
  Parameters prior_;       ///< of the linear parameters: gain, gain times overlap, leakage, damping, compressibility
  Parameters deviation_;   ///< their standard deviations before the first sample
  plant::ValveDynamics<double> spool_;
  Rls<kParameters> regression_;
  PredictionErrors errors_;
  ChamberOil oil_;
  Terms smooth_ = Terms::Zero();
  double smoothed_ticks_ = 0.0;
  double sign_ = 0.0;  ///< of the opening, of which the smoothed terms are
  Eigen::Vector3d last_state_ = Eigen::Vector3d::Zero();
  std::array<double, 3> currents_{};  ///< newest first
  int currents_known_ = 0;
  Tick last_tick_ = kNoTick;
  int phase_ = 0;
  std::uint32_t sample_flags_ = 0;
  OscillationMonitor loop_;
  double since_alarm_s_ = std::numeric_limits<double>::infinity();  ///< of an oscillating loop
  double alarm_gain_ = std::numeric_limits<double>::quiet_NaN();    ///< of the valve when the loop oscillated last
  double held_compressibility_ = 1.0;                               ///< at the last change of the valve
  double surplus_ = 0.0;   ///< unexpected flow towards the opening, summed over about 50 samples
  bool stronger_ = false;  ///< the valve counts as stronger, and no estimate has been valid since
};

/// Relative standard error of the gain at which an estimate has no value any more.
inline constexpr double kUselessGainError = 0.5;

}  // namespace farrier::estimation
