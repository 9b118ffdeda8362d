#include "plant/supply.hpp"

#include <algorithm>
#include <cmath>

#include "core/portable_math.hpp"
#include "plant/refusals.hpp"

namespace farrier::plant {

Result<Done> validate(const SupplyParams& p) {
  Refusals refusals("supply");
  refusals.not_negative("return_pressure_Pa", p.return_pressure_Pa);
  refusals.require(p.relief_pressure_Pa > p.return_pressure_Pa, "relief_pressure_Pa", p.relief_pressure_Pa,
                   "> return_pressure_Pa");
  refusals.not_negative("pump_flow_m3_s", p.pump_flow_m3_s);
  refusals.not_negative("accumulator_volume_m3", p.accumulator_volume_m3);
  refusals.require(p.accumulator_volume_m3 == 0.0 || p.precharge_Pa > 0.0, "precharge_Pa", p.precharge_Pa,
                   "> 0 with an accumulator");
  refusals.require(p.polytropic_exponent > 1.0, "polytropic_exponent", p.polytropic_exponent, "> 1");
  refusals.positive("compliance_m3_Pa", p.compliance_m3_Pa);
  refusals.not_negative("null_leakage_m3_s_Pa", p.null_leakage_m3_s_Pa);
  return refusals.verdict();
}

Result<Supply> Supply::create(const SupplyParams& params) {
  FARRIER_TRY(validate(params));
  return Supply(params);
}

Supply::Supply(const SupplyParams& params) noexcept
    : params_(params), pressure_Pa_(params.relief_pressure_Pa), volume_m3_(volume_m3(pressure_Pa_)) {}

bool Supply::holds_oil(double pressure_Pa) const noexcept {
  return params_.accumulator_volume_m3 > 0.0 && pressure_Pa > params_.precharge_Pa;
}

double Supply::gas_share(double pressure_Pa) const noexcept {
  return holds_oil(pressure_Pa) ? portable::pow(params_.precharge_Pa / pressure_Pa, 1.0 / params_.polytropic_exponent)
                                : 1.0;
}

double Supply::volume_m3(double pressure_Pa) const noexcept {
  return params_.compliance_m3_Pa * pressure_Pa + params_.accumulator_volume_m3 * (1.0 - gas_share(pressure_Pa));
}

double Supply::compliance_m3_Pa(double pressure_Pa) const noexcept {
  const double gas = holds_oil(pressure_Pa) ? params_.accumulator_volume_m3 * gas_share(pressure_Pa) /
                                                  (params_.polytropic_exponent * pressure_Pa)
                                            : 0.0;
  return params_.compliance_m3_Pa + gas;
}

// Newton from the present pressure. The volume bends at the precharge, so that an iteration is bounded by the precharge
// when it would pass it.
double Supply::pressure_at(double volume) const noexcept {
  constexpr int kIterations = 6;
  constexpr double kClose = 1e-12;  // of the volume
  const double bend_Pa = params_.precharge_Pa;
  if (params_.accumulator_volume_m3 == 0.0 || volume <= params_.compliance_m3_Pa * bend_Pa) {
    return std::max(0.0, volume / params_.compliance_m3_Pa);
  }
  double pressure = std::max(pressure_Pa_, bend_Pa * (1.0 + 1e-9));
  for (int i = 0; i < kIterations; ++i) {
    const double missing = volume - volume_m3(pressure);
    pressure = std::max(pressure + missing / compliance_m3_Pa(pressure), bend_Pa * (1.0 + 1e-9));
    if (std::abs(missing) <= kClose * volume) {
      break;
    }
  }
  return pressure;
}

double Supply::stored_J() const noexcept {
  const double hoses = 0.5 * params_.compliance_m3_Pa * pressure_Pa_ * pressure_Pa_;
  if (!holds_oil(pressure_Pa_)) {
    return hoses;
  }
  // The integral of p dV: p_0 V_0 / (n - 1) ((p / p_0)^(1 - 1/n) - 1).
  const double compressed = pressure_Pa_ / params_.precharge_Pa * gas_share(pressure_Pa_);
  return hoses + params_.precharge_Pa * params_.accumulator_volume_m3 / (params_.polytropic_exponent - 1.0) *
                     (compressed - 1.0);
}

void Supply::advance(double drawn_m3, double step_s) noexcept {
  const double before_Pa = pressure_Pa_;
  const double pumped = params_.pump_flow_m3_s * step_s;
  const double leaked = params_.null_leakage_m3_s_Pa * std::max(0.0, before_Pa - params_.return_pressure_Pa) * step_s;
  flow_m3_s_ = drawn_m3 / step_s;
  volume_m3_ = std::max(0.0, volume_m3_ + pumped - drawn_m3 - leaked);
  const double most = volume_m3(params_.relief_pressure_Pa);
  const double spilled = std::max(0.0, volume_m3_ - most);
  volume_m3_ -= spilled;
  pressure_Pa_ = spilled > 0.0 ? params_.relief_pressure_Pa : pressure_at(volume_m3_);
  const double mean_Pa = 0.5 * (before_Pa + pressure_Pa_);
  account_.pump_J += mean_Pa * pumped;
  account_.actuators_J += before_Pa * drawn_m3;
  account_.relief_J += params_.relief_pressure_Pa * spilled;
  account_.leakage_J += mean_Pa * leaked;
  account_.pump_m3 += pumped;
  account_.actuators_m3 += drawn_m3;
  account_.relief_m3 += spilled;
  account_.leakage_m3 += leaked;
}

void Supply::set_accumulator_volume(double volume_m3) noexcept {
  const double before_J = stored_J();
  params_.accumulator_volume_m3 = volume_m3;
  volume_m3_ = this->volume_m3(pressure_Pa_);
  account_.removed_J += before_J - stored_J();
}

}  // namespace farrier::plant
