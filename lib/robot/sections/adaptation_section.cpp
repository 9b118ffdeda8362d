#include "robot/sections/adaptation_section.hpp"

#include <optional>
#include <string>

#include "robot/sections/method_sections.hpp"

namespace farrier::robot {

using config::Default;
using config::Option;
using config::Visitor;
using estimation::EstimationMethod;
using estimation::GateKind;

namespace {

constexpr Option<GateKind> kGates[] = {{"none", GateKind::kNone}, {"pe", GateKind::kPe}, {"fft", GateKind::kFft}};

/// A group that belongs to one choice of `key`, which is called `choice` or as the group is: there with its defaults when
/// chosen, refused when another one is.
template <class Group>
void group_of(Visitor& v, const char* name, std::optional<Group>& group, bool chosen, const char* key,
              const char* sentence, const char* choice = nullptr) {
  if (chosen && !group.has_value()) {
    group.emplace();
  }
  v.group(name, group, sentence);
  v.check(chosen || !group.has_value(), name,
          std::string("is not used: give ") + key + ": " + (choice != nullptr ? choice : name) + ", or leave " + name +
              " out");
}

config::Option<UpdateMethod> option(UpdateMethod method) noexcept { return {to_string(method), method}; }

const config::Option<UpdateMethod> kMethods[] = {option(UpdateMethod::kLimits), option(UpdateMethod::kSmallError),
                                                 option(UpdateMethod::kWhiteError),
                                                 option(UpdateMethod::kDistinctPoles)};

}  // namespace

const char* to_string(UpdateMethod method) noexcept {
  switch (method) {
    case UpdateMethod::kLimits:
      return "limits";
    case UpdateMethod::kSmallError:
      return "small_error";
    case UpdateMethod::kWhiteError:
      return "white_error";
    case UpdateMethod::kDistinctPoles:
      return "distinct_poles";
  }
  return "unknown method";
}

void declare(Visitor& v, EstimatorSection& section) {
  const EstimatorParams d;
  EstimatorParams& e = section.params;
  v.here(section.place);
  v.choice<EstimationMethod>("method", e.method, estimation::kEstimationMethods, Default{d.method},
                             "What learns the model: docs/estimators.md compares the methods.");
  v.choice<GateKind>("gate", e.gate, kGates, Default{d.gate},
                     "Which samples may teach: all, those of a window that excites (9.4), or with frequencies (9.5).");
  if (e.forgets_evenly()) {
    v.number("forgetting_factor", e.forgetting_factor, {0.5, 1}, Default{d.forgetting_factor},
             "Weight of a sample against the next one's, lambda (6.21); 1 forgets nothing. Not for aff and kalman.");
  }
  if (e.regresses()) {
    v.flag("bias", e.bias, Default{d.bias}, "A constant in the regressor, for forces that no state explains.");
    v.flag("position", e.position, Default{d.position}, "The position in the regressor; a load spring needs it.");
    v.number("operating_point_time_constant_s", e.operating_point_time_constant_s, {1e-6, 10},
             Default{d.operating_point_time_constant_s}, "Of the moving mean of states and input that is subtracted.");
    v.integer("operating_point_order", e.operating_point_order, {0, 4}, Default{d.operating_point_order},
              "How often the moving mean is subtracted; 0 subtracts the home pose once and for all.");
    v.number(
        "full_weight_norm", e.full_weight_norm, {1e-9, 1e6}, Default{d.full_weight_norm},
        "Norm of the normalised regressor up to which a sample has full weight; larger ones are scaled down to it.");
    v.number("model_error", e.model_error, {0, 1}, Default{d.model_error},
             "RMS error per tick of what a linear model leaves out, in normalised velocity and force. Standard errors "
             "and misfit count it beside the sensors' noise.");
    v.number(
        "innovation_forgetting", e.innovation_forgetting, {0, 0.9999}, Default{d.innovation_forgetting},
        "Of the variance of prediction errors, by which measured states are corrected before they are regressed on.");
    v.number("initial_covariance", e.initial_covariance, {1e-6, 1e12}, Default{d.initial_covariance},
             "Of every parameter at the start, in normalised units.");
    if (e.limits_covariance()) {
      v.number("covariance_limit", e.covariance_limit, {1e-6, 1e40}, Default{d.covariance_limit},
               "Largest trace of the covariance; beyond it nothing is forgotten (6.23); 1e40: no limit. Not for vdf "
               "and sift.");
    }
    v.number("regressor_min", e.regressor_min, {0, 10}, Default{d.regressor_min},
             "Norm of the normalised regressor below which a sample says nothing (6.24).");
  }
  const bool by_phase = e.method != EstimationMethod::kValveFlow;
  if (by_phase) {
    v.integer("blank_ticks", e.blank_ticks, {0, 10000}, Default{d.blank_ticks},
              "No samples are taken this long after a joint's switch of phase. Not for valve_flow.");
  }
  v.integer("min_samples", e.min_samples, {1, 1000000}, Default{d.min_samples},
            "Samples of a phase before its first estimate.");
  if (e.regresses()) {
    v.number("stability_limit", e.stability_limit, {0.01, 0.999999}, Default{d.stability_limit},
             "Modulus to which an unstable pole of an estimate is mapped (8.1.1). Not for greybox and valve_flow.");
  }
  if (by_phase) {
    v.flag("phase_memory", e.phase_memory, Default{d.phase_memory},
           "Whether what is known of each phase is kept apart. Not for valve_flow.");
  }
  group_of(v, "aff", e.aff, e.method == EstimationMethod::kAff, "method",
           "Adaptive forgetting of each row (9.1)-(9.3).");
  group_of(v, "kalman", e.kalman, e.method == EstimationMethod::kKalman, "method",
           "Parameters as a random walk (B.17).");
  group_of(v, "vdf", e.vdf, e.method == EstimationMethod::kVdf, "method",
           "Variable-direction forgetting (Goel, Bruce, Bernstein 2020).");
  group_of(v, "sift", e.sift, e.method == EstimationMethod::kSift, "method",
           "Forgetting in the subspace of information (Lai and Bernstein 2024).");
  group_of(v, "grey_box", e.grey_box, e.method == EstimationMethod::kGreyBox, "method",
           "What the joint's own equations are fitted with; not used by other methods.", "greybox");
  group_of(v, "valve_flow", e.valve_flow, e.method == EstimationMethod::kValveFlow, "method",
           "What gain, overlap and leakage of a valve are fitted with; not used by other methods.", "valve_flow");
  v.check(e.regresses() || e.gate == GateKind::kNone, "gate",
          "is for regressions: greybox and valve_flow need gate: none");
  group_of(v, "pe", e.pe, e.gate == GateKind::kPe, "gate", "Persistence of excitation, (9.4) corrected.");
  group_of(v, "fft", e.fft, e.gate == GateKind::kFft, "gate", "Frequencies of the signals, (9.5).");
  v.check(!e.limits_covariance() || e.covariance_limit > e.columns() * e.initial_covariance, "covariance_limit",
          "must be above the trace at the start: " + std::to_string(e.columns()) + " times initial_covariance");
}

void declare(Visitor& v, UpdateLogicSection& section) {
  const UpdateLogicParams d;
  UpdateLogicParams& u = section.params;
  v.here(section.place);
  v.choice<UpdateMethod>("method", u.method, kMethods, Default{d.method},
                         "What makes an estimate lead to new gains: the thesis's (a) to (d), in that order.");
  v.number("pole_distance_min", u.pole_distance_min, {0, 2}, Default{d.pole_distance_min},
           "Distance in the z-plane from the poles the acting gains are designed for that pays a redesign.");
  v.number("gain_ratio_min", u.gain_ratio_min, {1, 1000}, Default{d.gain_ratio_min},
           "Ratio of the valve's gain to the one they are designed for, or its inverse, that pays one as well.");
  v.number("pole_spread_max", u.pole_spread_max, {0, 2}, Default{d.pole_spread_max},
           "Distance in the z-plane over which the poles of a converged estimate may move.");
  v.integer("converged_ticks", u.converged_ticks, {1, 100000}, Default{d.converged_ticks},
            "How long they must stay within it, or what the method asks for must hold; a multiple of "
            "estimate_period_ticks.");
  v.number("prediction_error_max", u.prediction_error_max, {0, 1000}, Default{d.prediction_error_max},
           "Methods small_error and white_error: RMS error of force predictions over what the sensors' noise "
           "explains.");
  v.number("whiteness_min", u.whiteness_min, {0, 1}, Default{d.whiteness_min},
           "Method white_error: probability that white errors are at least as correlated as the estimate's.");
  v.number("state_gain_max", u.state_gain_max, {0, 1e6}, Default{d.state_gain_max},
           "Method limits: largest norm of the normalised gains on position, velocity and force.");
  v.number("integral_gain_max", u.integral_gain_max, {0, 1e6}, Default{d.integral_gain_max},
           "Method limits: largest normalised integral gain, without its factor.");
  v.number("feed_forward_max", u.feed_forward_max, {0, 1e6}, Default{d.feed_forward_max},
           "Method limits: largest normalised feed-forward.");
  v.number("state_gain_rate_max_1_s", u.state_gain_rate_max_1_s, {0, 1e6}, Default{d.state_gain_rate_max_1_s},
           "Method limits: relative change of those gains from one estimate to the next, over the time between.");
  v.number("integral_gain_rate_max_1_s", u.integral_gain_rate_max_1_s, {0, 1e6}, Default{d.integral_gain_rate_max_1_s},
           "Method limits: the same of the integral gain.");
  v.number("feed_forward_rate_max_1_s", u.feed_forward_rate_max_1_s, {0, 1e6}, Default{d.feed_forward_rate_max_1_s},
           "Method limits: the same of the feed-forward.");
  v.number("validity_min", u.validity_min, {0, 1}, Default{d.validity_min}, "Least validity of an estimate.");
  v.number("model_uncertainty", u.model_uncertainty, {0, 1}, Default{d.model_uncertainty},
           "Relative uncertainty of the stored model; new gains must be stable on it, moved that far to the estimate.");
  v.number("uncertainty_growth_1_s", u.uncertainty_growth_1_s, {0, 1e6}, Default{d.uncertainty_growth_1_s},
           "Its growth while valid, converged estimates ask for gains that it does not allow.");
  v.number("error_sigmas", u.error_sigmas, {0, 10}, Default{d.error_sigmas},
           "Standard errors of the valve's gain within which new gains must be stable.");
  v.number("disk_margin_min", u.disk_margin_min, {0, 2}, Default{d.disk_margin_min},
           "Least disk margin of new gains around the model they are for.");
  v.number("delay_margin_min_s", u.delay_margin_min_s, {0, 1}, Default{d.delay_margin_min_s},
           "Least delay that loop must bear on top of its own.");
  v.number("physics_change_min", u.physics_change_min, {0, 1}, Default{d.physics_change_min},
           "Controllers of kind flow_inversion: share of any of the joint's physics by which an estimate must differ.");
  v.integer("gain_lead_ticks", u.gain_lead_ticks, {2, 1000}, Default{d.gain_lead_ticks},
            "Ticks from the issue of gains to their effect; covers the transport.");
  v.check(u.pole_spread_max <= u.pole_distance_min, "pole_spread_max",
          "must not be above pole_distance_min: what counts as still must not count as moved");
}

}  // namespace farrier::robot
