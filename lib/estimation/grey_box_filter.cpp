#include "estimation/grey_box_filter.hpp"

#include <algorithm>
#include <cmath>

#include "plant/oil.hpp"

namespace farrier::estimation {
namespace {

// Mean surprise is 3, its variance 6. The sum that signals a change of load falls by 3 a tick in normal operation.
constexpr double kSurpriseAllowed = 6.0;
// After a change the unknowns are unsettled, so surprises are ignored for this long.
constexpr int kRestTicks = 5;
// Steps of ln m_l and ln d_l: below the first the correction is linear enough; the second is the longest accepted step.
constexpr double kSettledStep = 0.1;
constexpr double kLongestStep = 1.0;
// ln of the largest distance of mass and damping from the restart values: a factor of 150.
constexpr double kFarthest = 5.0;
// Chamber pressures are not measured: their standard deviation at the start, share of the supply pressure.
constexpr double kPressureUnknown = 0.05;

/// y = P x. Plain loops: they become vector code, and compile in no time.
void multiply(const GreyBoxCovariance& p, const double* x, double* y) noexcept {
  constexpr int n = kGreyBoxStates;
  for (int i = 0; i < n; ++i) {
    y[i] = 0.0;
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      y[i] += p.data()[n * j + i] * x[j];
    }
  }
}

double dot(const double* x, const double* y) noexcept {
  double sum = 0.0;
  for (int i = 0; i < kGreyBoxStates; ++i) {
    sum += x[i] * y[i];
  }
  return sum;
}

/// Scalar measurement `error = row . (state - mean) + noise` (Bucy and Joseph 1968): P <- (I - K h^T) P (I - K h^T)^T +
/// K r K^T, which holds for any gain, so also for one that leaves the unknowns alone. In two steps, A = P - K (P h)^T
/// and A - (A h) K^T + K r K^T, so that the result stays positive with rounding.
void correct(GreyBoxCovariance& covariance, Gradient& mean, const Gradient& row, double error, double variance,
             bool learn) noexcept {
  constexpr int n = kGreyBoxStates;
  Gradient along, rest;
  multiply(covariance, row.data(), along.data());
  const double expected = dot(row.data(), along.data()) + variance;
  const int corrected = learn ? n : kMotions;
  double gain[n] = {};
  for (int i = 0; i < corrected; ++i) {
    gain[i] = along.data()[i] / expected;
  }
  const double left = error - dot(row.data(), mean.data());
  double* p = covariance.data();
  for (int j = 0; j < n; ++j) {
    mean.data()[j] += gain[j] * left;
    for (int i = 0; i < n; ++i) {
      p[n * j + i] -= gain[i] * along.data()[j];
    }
  }
  multiply(covariance, row.data(), rest.data());
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      p[n * j + i] += (variance * gain[i] - rest.data()[i]) * gain[j];
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < j; ++i) {
      p[n * j + i] = p[n * i + j] = 0.5 * (p[n * j + i] + p[n * i + j]);
    }
  }
}

}  // namespace

struct GreyBoxFilter::Prediction {
  GreyBoxModel::Passage passage;
  GreyBoxModel::Force force;
  GreyBoxCovariance covariance;
};

GreyBoxFilter::GreyBoxFilter(const GreyBoxModel& model, const GreyBoxNoise& noise, const GreyBoxRestart& restart,
                             const Unknowns& unknowns, const Unknowns& variance, double period_s) noexcept
    : model_(model),
      noise_(noise),
      restart_(restart),
      first_unknowns_(unknowns),
      first_variance_(variance),
      period_s_(period_s),
      unknowns_(unknowns) {
  covariance_.setZero();
  covariance_.diagonal().tail<kUnknowns>() = variance;
}

void GreyBoxFilter::anchor(const Eigen::Vector3d& measured) noexcept {
  motion_ = model_.at_rest(measured);
  covariance_.topRows<kMotions>().setZero();
  covariance_.leftCols<kMotions>().setZero();
  const double pressure = kPressureUnknown * model_.actuator().supply_pressure_Pa;
  covariance_.diagonal().head<kMotions>() << noise_.sensor_variance(0), noise_.sensor_variance(1), pressure * pressure,
      pressure * pressure;
  surplus_ = 0.0;
}

GreyBoxFilter::Prediction GreyBoxFilter::predict(const Unknowns& about, double current_A, bool learn) const noexcept {
  Prediction out{model_.pass(motion_, about, current_A, period_s_), {}, covariance_};
  const Sensitivity& by = out.passage.by;
  out.force = model_.load_cell_force(out.passage.motion, about);

  // P <- Phi P Phi^T + Q, Phi = [by^T; 0 I]
  constexpr int n = kGreyBoxStates;
  double* p = out.covariance.data();
  for (int j = 0; j < kMotions; ++j) {
    double along[n];
    multiply(covariance_, by.data() + n * j, along);
    for (int i = 0; i <= j; ++i) {
      p[n * j + i] = p[n * i + j] = dot(by.data() + n * i, along);
    }
    for (int i = kMotions; i < n; ++i) {
      p[n * j + i] = p[n * i + j] = along[i];
    }
  }

  const double T = period_s_;
  const bool loose = out.passage.bent || !learn;
  // A force held over the tick moves velocity by F T / m and position by half as much times T.
  const double velocity =
      noise_.force_variance * std::pow(T * out.passage.inverse_mass, 2) + (loose ? noise_.bent_velocity_variance : 0.0);
  out.covariance(0, 0) += 0.25 * T * T * velocity;
  out.covariance(0, 1) += 0.5 * T * velocity;
  out.covariance(1, 0) += 0.5 * T * velocity;
  out.covariance(1, 1) += velocity;
  // A flow of K_v |i_v| sqrt(p_s) that is wrong by flow_error, over a tick.
  const plant::ActuatorParams& act = model_.actuator();
  const double flow = noise_.flow_error * act.valve_gain * std::min(std::abs(current_A), act.valve_current_max_A) *
                      std::sqrt(act.supply_pressure_Pa) * act.bulk_modulus_Pa * T;
  const double x = std::clamp(motion_(0), 0.0, act.stroke);
  const double least = loose ? noise_.bent_pressure_variance : 0.0;
  const auto [volume_a, volume_b] = plant::chamber_volumes(act, x);
  out.covariance(2, 2) += least + std::pow(flow / volume_a, 2);
  out.covariance(3, 3) += least + std::pow(flow / volume_b, 2);
  return out;
}

double GreyBoxFilter::surprise_of(const Prediction& p, const Eigen::Vector3d& error) const noexcept {
  // e^T (H P H^T + R)^-1 e, H = [1 0 ..; 0 1 ..; force.by^T], by Cholesky of the 3 x 3 matrix.
  Gradient along;
  multiply(p.covariance, p.force.by.data(), along.data());
  Eigen::Matrix3d s;
  s.topLeftCorner<2, 2>() = p.covariance.topLeftCorner<2, 2>();
  s(0, 2) = s(2, 0) = along(0);
  s(1, 2) = s(2, 1) = along(1);
  s(2, 2) = dot(p.force.by.data(), along.data());
  s.diagonal() += noise_.sensor_variance;
  const double l00 = std::sqrt(s(0, 0));
  const double l10 = s(1, 0) / l00, l20 = s(2, 0) / l00;
  const double l11 = std::sqrt(s(1, 1) - l10 * l10);
  const double l21 = (s(2, 1) - l20 * l10) / l11;
  const double l22 = std::sqrt(s(2, 2) - l20 * l20 - l21 * l21);
  const double z0 = error(0) / l00;
  const double z1 = (error(1) - l10 * z0) / l11;
  const double z2 = (error(2) - l20 * z0 - l21 * z1) / l22;
  return z0 * z0 + z1 * z1 + z2 * z2;
}

void GreyBoxFilter::load_changed() noexcept {
  for (const auto& [place, variance] :
       {std::pair{kMass, restart_.mass_variance}, std::pair{kDamping, restart_.damping_variance}}) {
    if (variance > 0.0) {
      unknowns_(place) = restart_.unknowns(place);
      covariance_.row(kMotions + place).setZero();
      covariance_.col(kMotions + place).setZero();
      covariance_(kMotions + place, kMotions + place) = variance;
    }
  }
  surplus_ = 0.0;
  ticks_since_change_ = 0;
}

void GreyBoxFilter::keep_within_bounds() noexcept {
  for (const int place : {kMass, kDamping}) {
    unknowns_(place) =
        std::clamp(unknowns_(place), restart_.unknowns(place) - kFarthest, restart_.unknowns(place) + kFarthest);
  }
  for (const int place : {kCoulomb, kStiffness, kLeakage}) {
    unknowns_(place) = std::max(unknowns_(place), 0.0);
  }
  const plant::ActuatorParams& act = model_.actuator();
  for (const int place : {2, 3}) {  // a void of a tenth of its chamber; twice the supply pressure
    motion_(place) = std::clamp(motion_(place), -0.1 * act.bulk_modulus_Pa, 2.0 * act.supply_pressure_Pa);
  }
}

void GreyBoxFilter::begin_anew(const Eigen::Vector3d& measured) noexcept {
  unknowns_ = first_unknowns_;
  covariance_.setZero();
  covariance_.diagonal().tail<kUnknowns>() = first_variance_;
  ticks_since_change_ = 0;
  anchor(measured);
}

// Iterated extended Kalman filter (Jazwinski 1970, 8.3). The prediction is repeated about the corrected unknowns until
// the correction of mass and damping is small. A mass that is wrong by a factor of a hundred is beyond any first order.
GreyBoxFilter::Outcome GreyBoxFilter::step(const Eigen::Vector3d& measured, double current_A, bool learn) noexcept {
  covariance_.diagonal().tail<kUnknowns>() += noise_.drift_variance;
  ++ticks_since_change_;
  Outcome outcome = Outcome::kTaken;
  Unknowns about = unknowns_;
  Motion motion = motion_;
  Unknowns unknowns = unknowns_;
  GreyBoxCovariance covariance = covariance_;
  for (int pass = 0; pass < kMostPasses; ++pass) {
    Prediction p = predict(about, current_A, learn);
    const bool learns = learn && !p.passage.bent;
    const Eigen::Vector3d error(measured(0) - p.passage.motion(0), measured(1) - p.passage.motion(1),
                                measured(2) - p.force.value);
    if (pass == 0) {
      surprise_ = surprise_of(p, error);
      if (ticks_since_change_ <= kRestTicks || !learn) {
        surplus_ = 0.0;
      } else if (learns) {
        surplus_ = std::max(0.0, surplus_ + surprise_ - kSurpriseAllowed);
      }
      if (surplus_ > restart_.threshold) {
        // This tick began under the old load and may have ended under the new one: it teaches neither.
        load_changed();
        about = unknowns = unknowns_;
        outcome = Outcome::kChanged;
        learn = false;
        continue;
      }
    }
    // Means relative to where the model was taken: the unknowns of before, and the motion they lead to.
    Gradient mean;
    mean.tail<kUnknowns>() = unknowns_ - about;
    mean.head<kMotions>() = p.passage.by.bottomRows<kUnknowns>().transpose() * mean.tail<kUnknowns>();
    Gradient row = Gradient::Zero();
    row(0) = 1.0;
    correct(p.covariance, mean, row, error(0), noise_.sensor_variance(0), learns);
    row(0) = 0.0;
    row(1) = 1.0;
    correct(p.covariance, mean, row, error(1), noise_.sensor_variance(1), learns);
    correct(p.covariance, mean, p.force.by, error(2), noise_.sensor_variance(2), learns);

    Unknowns move = mean.tail<kUnknowns>();
    const double largest = std::max(std::abs(move(kMass)), std::abs(move(kDamping)));
    for (const int place : {kMass, kDamping}) {
      move(place) = std::clamp(move(place), -kLongestStep, kLongestStep);
    }
    motion = p.passage.motion + mean.head<kMotions>();
    unknowns = about + move;
    covariance = p.covariance;
    if (!learns || !(largest > kSettledStep)) {
      break;
    }
    about = unknowns;
    for (const int place : {kMass, kDamping}) {
      about(place) =
          std::clamp(about(place), restart_.unknowns(place) - kFarthest, restart_.unknowns(place) + kFarthest);
    }
  }
  if (!motion.allFinite() || !unknowns.allFinite() || !covariance.allFinite() ||
      !(covariance.diagonal().array() >= 0).all()) {
    begin_anew(measured);
    return Outcome::kRepaired;
  }
  motion_ = motion;
  unknowns_ = unknowns;
  covariance_ = covariance;
  keep_within_bounds();
  return outcome;
}

GreyBoxFilter::Load GreyBoxFilter::load() const noexcept {
  return {unknowns_.head<5>(), covariance_.block<5, 5>(kMotions, kMotions)};
}

void GreyBoxFilter::set_load(const Load& load) noexcept {
  unknowns_.head<5>() = load.unknowns;
  covariance_.middleRows<5>(kMotions).setZero();
  covariance_.middleCols<5>(kMotions).setZero();
  covariance_.block<5, 5>(kMotions, kMotions) = load.covariance;
  surplus_ = 0.0;
}

}  // namespace farrier::estimation
