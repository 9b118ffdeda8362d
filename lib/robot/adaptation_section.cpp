#include "robot/adaptation_section.hpp"

#include <string>

namespace farrier::robot {

using config::Default;
using config::Visitor;

void declare(Visitor& v, EstimatorSection& section) {
  const EstimatorParams d;
  EstimatorParams& e = section.params;
  v.here(section.place);
  v.number("forgetting_factor", e.forgetting_factor, {0.5, 1}, Default{d.forgetting_factor},
           "Weight of a sample against the next one's, lambda (6.21); 1 forgets nothing.");
  v.flag("bias", e.bias, Default{d.bias}, "A constant in the regressor, for forces that no state explains.");
  v.flag("position", e.position, Default{d.position}, "The position in the regressor; a load spring needs it.");
  v.number("operating_point_time_constant_s", e.operating_point_time_constant_s, {0, 10},
           Default{d.operating_point_time_constant_s},
           "Of the moving average of states and input that is subtracted; 0 subtracts the home pose.");
  v.number("initial_covariance", e.initial_covariance, {1e-6, 1e12}, Default{d.initial_covariance},
           "Of every parameter at the start, in normalised units.");
  v.number("covariance_limit", e.covariance_limit, {1e-6, 1e15}, Default{d.covariance_limit},
           "Largest trace of the covariance; beyond it nothing is forgotten (6.23).");
  v.number("regressor_min", e.regressor_min, {0, 10}, Default{d.regressor_min},
           "Norm of the normalised regressor below which a sample says nothing (6.24).");
  v.integer("blank_ticks", e.blank_ticks, {0, 10000}, Default{d.blank_ticks},
            "No samples are taken this long before and after a planned switch of phase.");
  v.number("stability_limit", e.stability_limit, {0.01, 0.999999}, Default{d.stability_limit},
           "Modulus to which an unstable pole of an estimate is mapped (8.1.1).");
  v.flag("phase_memory", e.phase_memory, Default{d.phase_memory}, "Whether what is known of each phase is kept apart.");
  v.check(e.covariance_limit > e.columns() * e.initial_covariance, "covariance_limit",
          "must be above the trace at the start: " + std::to_string(e.columns()) + " times initial_covariance");
}

void declare(Visitor& v, UpdateLogicSection& section) {
  const UpdateLogicParams d;
  UpdateLogicParams& u = section.params;
  v.here(section.place);
  v.number("pole_distance_min", u.pole_distance_min, {0, 2}, Default{d.pole_distance_min},
           "Distance in the z-plane from the poles the acting gains are designed for that pays a redesign.");
  v.number("pole_spread_max", u.pole_spread_max, {0, 2}, Default{d.pole_spread_max},
           "Distance in the z-plane over which the poles of a converged estimate may move.");
  v.integer("converged_ticks", u.converged_ticks, {1, 100000}, Default{d.converged_ticks},
            "How long they must stay within it; a multiple of estimate_period_ticks.");
  v.number("validity_min", u.validity_min, {0, 1}, Default{d.validity_min}, "Least validity of an estimate.");
  v.number("model_uncertainty", u.model_uncertainty, {0, 1}, Default{d.model_uncertainty},
           "Relative uncertainty of the stored model, on which new gains must be stable as well.");
  v.number("error_sigmas", u.error_sigmas, {0, 10}, Default{d.error_sigmas},
           "Standard errors of the estimate within which new gains must be stable.");
  v.integer("gain_lead_ticks", u.gain_lead_ticks, {2, 1000}, Default{d.gain_lead_ticks},
            "Ticks from the issue of gains to their effect; covers the transport.");
  v.integer("refractory_ticks", u.refractory_ticks, {0, 1000000}, Default{d.refractory_ticks},
            "Ticks from one issue of gains for a joint's phase to the next.");
  v.check(u.pole_spread_max <= u.pole_distance_min, "pole_spread_max",
          "must not be above pole_distance_min: what counts as still must not count as moved");
  v.check(u.refractory_ticks >= u.gain_lead_ticks, "refractory_ticks",
          "must not be below gain_lead_ticks: gains would be replaced before they act");
}

}  // namespace farrier::robot
