#pragma once

#include <cmath>

#include "plant/actuator.hpp"
#include "plant/end_stop.hpp"
#include "plant/oil.hpp"

namespace farrier::plant {

/// Valve and oil held over a step.
struct OpenValve {
  double flow_gain;  ///< K_v |u|, m^3/s/sqrt(Pa)
  double port_a_Pa;  ///< pressure the valve connects to chamber a
  double port_b_Pa;  ///< and to chamber b
};

/// Rates of both compressions, Pa/s.
struct CompressionRates {
  double a_Pa_s, b_Pa_s;
};

/// Left of the load cell: current, motion and supply give the flows, the rates of the chambers' pressures and the force
/// on the piston. Hubacher (2014), (2.8) to (2.15), with flow both ways through every orifice, voids and end stops.
/// Forces in N or Nm, positions in m or rad. Uses no function but sqrt.
class ActuatorEquations {
 public:
  explicit ActuatorEquations(const ActuatorParams& actuator) noexcept
      : params_(actuator),
        inverse_bulk_modulus_(1.0 / actuator.bulk_modulus_Pa),
        smallest_volume_m3_(kSmallestVolumeShare * actuator.line_volume_m3),
        inverse_stop_ramp_(1000.0 / actuator.stroke) {}

  OpenValve hold(double valve_current_A) const noexcept {
    const auto ports = port_pressures(valve_current_A > 0.0, params_.supply_pressure_Pa, params_.return_pressure_Pa);
    return {params_.valve_gain * std::abs(valve_current_A), ports.a_Pa, ports.b_Pa};
  }

  /// (2.14), (2.15): both chambers' flows counted inward, into the chambers or the lines before them.
  ChamberFeed valve_flow(double p_a, double p_b, const OpenValve& valve) const noexcept {
    const double drop_a = valve.port_a_Pa - p_a;
    const double drop_b = valve.port_b_Pa - p_b;
    return {valve.flow_gain * drop_a, orifice_divisor(drop_a, params_.laminar_pressure_Pa), valve.flow_gain * drop_b,
            orifice_divisor(drop_b, params_.laminar_pressure_Pa)};
  }

  /// Volumes of the chambers with their parts of the lines; a quarter of line_volume_m3 at least.
  ChamberVolumes<double> volumes(double position) const noexcept {
    return at_least(smallest_volume_m3_, chamber_volumes(params_, position));
  }

  /// (2.10), (2.11) with voids, for the chambers' pressures and their feed.
  CompressionRates compression_rates(double position, double velocity, double compression_a_Pa, double compression_b_Pa,
                                     double p_a, double p_b, const ChamberFeed& feed) const noexcept {
    const auto [v_a, v_b] = volumes(position);
    const double filled_a = filled_share(compression_a_Pa, p_a, inverse_bulk_modulus_);
    const double filled_b = filled_share(compression_b_Pa, p_b, inverse_bulk_modulus_);
    const double growth_a = params_.area_a * velocity * filled_a - feed.past_a;
    const double growth_b = -params_.area_b * velocity * filled_b - feed.past_b;
    return {pressure_rate(params_.bulk_modulus_Pa, v_a, feed.flow_a, feed.root_a, growth_a),
            pressure_rate(params_.bulk_modulus_Pa, v_b, feed.flow_b, feed.root_b, growth_b)};
  }

  /// Force of the end stops on the piston: only pushes inward, never returns more than it took.
  double stop_force(double position, double velocity) const noexcept {
    if (position < 0.0) {
      return stop_push(-position, -velocity);
    }
    const double beyond = position - params_.stroke;
    return beyond > 0.0 ? -stop_push(beyond, velocity) : 0.0;
  }

  const ActuatorParams& params() const noexcept { return params_; }

 private:
  double stop_push(double depth, double approach_speed) const noexcept {
    // engaged over the first thousandth of the stroke
    return plant::stop_push(depth, approach_speed, depth * inverse_stop_ramp_, params_.stop_stiffness,
                            params_.stop_damping);
  }

  ActuatorParams params_;
  double inverse_bulk_modulus_;
  double smallest_volume_m3_;
  double inverse_stop_ramp_;
};

}  // namespace farrier::plant
