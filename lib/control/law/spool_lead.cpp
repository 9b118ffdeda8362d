#include "control/law/spool_lead.hpp"

#include <algorithm>
#include <cmath>

namespace farrier::control {
namespace {

constexpr double kPlaceStep = 0.01;
constexpr double kSlowestPlace = 0.95;

}  // namespace

SpoolLead::SpoolLead(double natural_frequency_rad_s, double damping, double current_max_A, double period_s) noexcept
    : current_max_A_(current_max_A), spool_(natural_frequency_rad_s, damping, period_s) {
  // e+ = A e - B (c - asked), A = [by_error by_rate], B = by_error's and rate's part of a current.
  const double a = spool_.by_error()[0], b = spool_.by_rate()[0], c = spool_.by_error()[1], d = spool_.by_rate()[1];
  const std::array<double, 2> input{1.0 - a, -c};
  const double determinant = input[0] * (c * input[0] + d * input[1]) - input[1] * (a * input[0] + b * input[1]);
  for (double place = 0.0; place < kSlowestPlace && determinant != 0.0; place += kPlaceStep) {
    // phi(A) = (A - place)^2; K = [0 1] [B AB]^-1 phi(A).
    const double p = a - place, q = d - place;
    const std::array<double, 4> phi{p * p + b * c, b * (p + q), c * (p + q), q * q + b * c};
    const std::array<double, 2> row{-input[1] / determinant, input[0] / determinant};
    gain_ = {row[0] * phi[0] + row[1] * phi[2], row[0] * phi[1] + row[1] * phi[3]};
    if (1.0 + gain_[0] <= kMostLead) {
      acts_ = gain_[0] > 0.0;
      break;
    }
  }
  lag_ticks_ = find_lag_ticks();
}

double SpoolLead::take(double asked_A) noexcept {
  if (current_max_A_ == 0.0) {
    return asked_A;
  }
  const double current_A = current_for(asked_A);
  spool_.move(current_A);
  return current_A;
}

double SpoolLead::current_for(double asked_A) const noexcept {
  const double lead_A = acts_ ? gain_[0] * (asked_A - spool_.opening_A()) - gain_[1] * spool_.rate_A() : 0.0;
  return std::clamp(asked_A + lead_A, -current_max_A_, current_max_A_);
}

// Sum over a step's response of what is missing.
double SpoolLead::find_lag_ticks() const noexcept {
  constexpr int kLongest = 400;
  SpoolLead spool = *this;
  spool.current_max_A_ = 1e9;
  double missing = 0.0;
  for (int k = 0; k < kLongest; ++k) {
    missing += 1.0 - spool.spool_.move(spool.current_for(1.0));
  }
  return missing;
}

}  // namespace farrier::control
