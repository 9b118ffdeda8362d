#include "trials/blind/score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/wilson.hpp"

namespace farrier::blind {
namespace {

template <class Of, class If>
double share(const std::vector<Outcome>& outcomes, Of of, If holds) {
  std::size_t all = 0;
  std::size_t good = 0;
  for (const Outcome& outcome : outcomes) {
    if (outcome.refused.empty() && of(outcome)) {
      ++all;
      good += holds(outcome) ? 1 : 0;
    }
  }
  return all > 0 ? static_cast<double>(good) / static_cast<double>(all) : std::numeric_limits<double>::quiet_NaN();
}

bool counts(const Outcome& outcome) { return outcome.plan.kind == Kind::kEffect && outcome.detectable > kDetectable; }

/// Not a number of none.
double median(std::vector<double> values) {
  if (values.empty()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Share of the names in trials of sets that are of no hidden effect.
double wrong_names(const std::vector<Outcome>& outcomes) {
  std::size_t all = 0;
  std::size_t wrong = 0;
  for (const Outcome& outcome : outcomes) {
    for (const Named& named : outcome.named) {
      all += outcome.plan.kind == Kind::kSet ? 1 : 0;
      wrong += outcome.plan.kind == Kind::kSet && !hides(outcome, named.name) ? 1 : 0;
    }
  }
  return all > 0 ? static_cast<double>(wrong) / static_cast<double>(all) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

bool hides(const Outcome& outcome, const std::string& name) {
  return std::ranges::any_of(outcome.plan.plan.hidden, [&](const truth::Hidden& h) { return h.name == name; });
}

double size_error(const plant::Parameter& parameter, double value, double truth, const plant::Scales& scales) {
  // A frequency's or a saturation's neutral value is infinite: there the distance is that of the inverses.
  if (parameter.reciprocal) {
    return std::abs(truth / value - 1.0);
  }
  const double neutral = scales.value(parameter, scales.neutral(parameter));
  return std::abs(value - truth) / std::abs(truth - neutral);
}

bool first_alone(const Outcome& outcome) {
  if (outcome.named.empty() || !hides(outcome, outcome.named.front().name)) {
    return false;
  }
  return std::ranges::none_of(outcome.alternatives,
                              [&](const auto& pair) { return pair.first == outcome.named.front().name; });
}

bool named_or_in_pair(const Outcome& outcome) {
  if (outcome.named.empty()) {
    return false;
  }
  const std::string& first = outcome.named.front().name;
  const auto rivals =
      std::ranges::count_if(outcome.alternatives, [&](const auto& pair) { return pair.first == first; });
  return hides(outcome, first) || (rivals == 1 && std::ranges::any_of(outcome.alternatives, [&](const auto& pair) {
                                     return pair.first == first && hides(outcome, pair.second);
                                   }));
}

bool separable_set(const Outcome& outcome) {
  return outcome.plan.kind == Kind::kSet && outcome.refused.empty() && outcome.inseparable.empty();
}

bool all_named(const Outcome& outcome) {
  return std::ranges::all_of(outcome.plan.plan.hidden, [&](const truth::Hidden& hidden) {
    return std::ranges::any_of(outcome.named, [&](const Named& named) { return named.name == hidden.name; });
  });
}

bool confidently_wrong(const Outcome& outcome) {
  return std::ranges::any_of(
      outcome.named, [&](const Named& named) { return named.confidence > kConfident && !hides(outcome, named.name); });
}

Score score(const std::vector<Outcome>& outcomes) {
  Score s;
  s.trials = outcomes.size();
  s.counted = static_cast<std::size_t>(std::ranges::count_if(outcomes, counts));
  const auto of_kind = [](Kind kind) { return [kind](const Outcome& o) { return o.plan.kind == kind; }; };
  const auto detectable = [](Kind kind) {
    return [kind](const Outcome& o) { return o.plan.kind == kind && o.detectable > kDetectable; };
  };
  s.named = share(outcomes, counts, named_or_in_pair);
  s.first_alone = share(outcomes, counts, first_alone);
  s.within_tolerance = share(
      outcomes, [](const Outcome& o) { return counts(o) && first_alone(o); },
      [](const Outcome& o) { return o.parameter_error <= kParameterTolerance; });
  s.false_alarms =
      share(outcomes, of_kind(Kind::kNone), [](const Outcome& o) { return o.verdict != diagnosis::Verdict::kNone; });
  s.outside_unknown = share(outcomes, detectable(Kind::kOutside),
                            [](const Outcome& o) { return o.verdict == diagnosis::Verdict::kUnknown; });
  s.outside_admitted = share(outcomes, detectable(Kind::kOutside), [](const Outcome& o) {
    return o.verdict == diagnosis::Verdict::kUnknown || o.verdict == diagnosis::Verdict::kCannotSeparate;
  });
  for (std::size_t size = 2; size <= kLargestSet; ++size) {
    const auto of_size = [size](const Outcome& o) { return o.plan.plan.hidden.size() == size; };
    s.sets_named[size] = share(
        outcomes, [&](const Outcome& o) { return detectable(Kind::kSet)(o) && of_size(o); }, all_named);
    const auto separable = [&](const Outcome& o) { return separable_set(o) && of_size(o); };
    s.separable[size] = static_cast<std::size_t>(std::ranges::count_if(outcomes, separable));
    s.separable_named[size] = share(outcomes, separable, all_named);
  }
  s.set_names_wrong = wrong_names(outcomes);
  std::vector<double> seconds;
  std::vector<double> sizes;
  for (const Outcome& outcome : outcomes) {
    if (outcome.refused.empty()) {
      seconds.push_back(outcome.cpu_s);
    }
    for (const Named& named : outcome.named) {
      if (named.size_error) {
        sizes.push_back(*named.size_error);
      }
    }
  }
  s.median_s = median(std::move(seconds));
  s.median_size_error = median(std::move(sizes));
  s.confidently_wrong = share(
      outcomes, [](const Outcome&) { return true; }, confidently_wrong);
  std::vector<double> gains;
  for (const Outcome& outcome : outcomes) {
    if ((counts(outcome) || detectable(Kind::kSet)(outcome)) && outcome.error_after > 0.0) {
      gains.push_back(outcome.error_before / outcome.error_after);
    }
  }
  s.median_gain = gains.empty() ? 0.0 : median(std::move(gains));
  std::vector<double> control;
  for (const Outcome& outcome : outcomes) {
    if (outcome.control) {
      control.push_back(outcome.control->old_nrmse / outcome.control->new_nrmse);
    }
  }
  s.controlled = control.size();
  s.control_gain = median(std::move(control));
  return s;
}

Alarms alarms_of(const std::vector<Outcome>& outcomes, std::size_t joints) {
  struct Robot {
    std::size_t joints = 0, alarms = 0;
  };
  std::map<std::uint64_t, Robot> robots;
  std::vector<double> seconds;
  Alarms alarms;
  for (const Outcome& outcome : outcomes) {
    if (outcome.refused.empty()) {
      Robot& robot = robots[(outcome.plan.plan.seed - outcome.plan.joint) / joints];
      ++robot.joints;
      robot.alarms += outcome.verdict != diagnosis::Verdict::kNone ? 1 : 0;
      seconds.push_back(outcome.cpu_s);
    }
  }
  for (const auto& [number, robot] : robots) {
    alarms.robots += robot.joints == joints ? 1 : 0;
    alarms.joints += robot.joints;
    alarms.alarms += robot.alarms > 0 ? 1 : 0;
    alarms.joint_alarms += robot.alarms;
  }
  alarms.rate_high = wilson_interval(alarms.alarms, alarms.robots).high;
  alarms.median_s = median(std::move(seconds));
  return alarms;
}

std::map<std::string, Score> score_by_effect(const std::vector<Outcome>& outcomes) {
  std::map<std::string, std::vector<Outcome>> by_name;
  for (const Outcome& outcome : outcomes) {
    if (outcome.plan.kind == Kind::kEffect) {
      by_name[outcome.plan.plan.hidden.front().name].push_back(outcome);
    }
  }
  std::map<std::string, Score> scores;
  for (const auto& [name, mine] : by_name) {
    scores[name] = score(mine);
  }
  return scores;
}

}  // namespace farrier::blind
