#include "trials/blind/outcomes_file.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "report/figures/kept_lines.hpp"

namespace farrier::blind {
namespace {

using nlohmann::json;

/// JSON has no infinity: a number that is not finite becomes text.
json number(double value) { return std::isfinite(value) ? json(value) : json(std::to_string(value)); }

double number_of(const json& value) {
  return value.is_string() ? std::stod(value.get<std::string>()) : value.get<double>();
}

json to_json(const Outcome& outcome) {
  json line{{"detectable", number(outcome.detectable)},
            {"verdict", static_cast<int>(outcome.verdict)},
            {"parameter_error", number(outcome.parameter_error)},
            {"error_before", number(outcome.error_before)},
            {"error_after", number(outcome.error_after)},
            {"cpu_s", outcome.cpu_s},
            {"answers", json::array()},
            {"inseparable", outcome.inseparable},
            {"named", json::array()},
            {"alternatives", json::array()}};
  for (const truth::Answer& answer : outcome.answers) {
    line["answers"].push_back({{"name", answer.name}, {"value", number(answer.value)}});
  }
  for (const Named& named : outcome.named) {
    json one{{"name", named.name},
             {"value", number(named.value)},
             {"confidence", number(named.confidence)},
             {"deviation", number(named.deviation)},
             {"fit_deviation", number(named.fit_deviation)},
             {"distance", number(named.distance)},
             {"evidence", json::array()}};
    for (const double value : diagnosis::numbers_of(named.evidence)) {
      one["evidence"].push_back(number(value));
    }
    if (named.fit_error) {
      one["fit_error"] = number(*named.fit_error);
      one["size_error"] = number(*named.size_error);
    }
    line["named"].push_back(std::move(one));
  }
  for (const auto& [one, other] : outcome.alternatives) {
    line["alternatives"].push_back({one, other});
  }
  if (outcome.control) {
    line["control"] = {{"old_nrmse", number(outcome.control->old_nrmse)},
                       {"new_nrmse", number(outcome.control->new_nrmse)}};
  }
  return line;
}

Outcome outcome_of(const json& line, const TrialPlan& plan) {
  Outcome outcome;
  outcome.plan = plan;
  outcome.detectable = number_of(line.at("detectable"));
  outcome.verdict = static_cast<diagnosis::Verdict>(line.at("verdict").get<int>());
  outcome.parameter_error = number_of(line.at("parameter_error"));
  outcome.error_before = number_of(line.at("error_before"));
  outcome.error_after = number_of(line.at("error_after"));
  outcome.cpu_s = line.at("cpu_s");
  outcome.inseparable = line.at("inseparable");
  for (const json& answer : line.at("answers")) {
    outcome.answers.push_back({answer.at("name"), number_of(answer.at("value"))});
  }
  for (const json& named : line.at("named")) {
    Named one{named.at("name"), number_of(named.at("value")), number_of(named.at("confidence"))};
    one.deviation = number_of(named.at("deviation"));
    one.fit_deviation = number_of(named.at("fit_deviation"));
    one.distance = number_of(named.at("distance"));
    std::array<double, diagnosis::kEvidences> evidence{};
    for (std::size_t i = 0; i < evidence.size(); ++i) {
      evidence[i] = number_of(named.at("evidence").at(i));
    }
    one.evidence = diagnosis::evidence_of(evidence);
    if (named.contains("fit_error")) {
      one.fit_error = number_of(named["fit_error"]);
      one.size_error = number_of(named["size_error"]);
    }
    outcome.named.push_back(std::move(one));
  }
  for (const json& pair : line.at("alternatives")) {
    outcome.alternatives.emplace_back(pair.at(0), pair.at(1));
  }
  if (line.contains("control")) {
    const json& control = line["control"];
    outcome.control = trials::TrackingGain{number_of(control.at("old_nrmse")), number_of(control.at("new_nrmse"))};
  }
  return outcome;
}

}  // namespace

Result<Done> append_outcome(const std::string& path, const std::string& origin, std::size_t index,
                            const Outcome& outcome) {
  json line = to_json(outcome);
  line["trial"] = index;
  return report::append_kept(path, origin, std::move(line));
}

std::map<std::size_t, Outcome> read_outcomes(const std::string& path, const std::string& origin,
                                             const std::vector<TrialPlan>& plans) {
  std::map<std::size_t, Outcome> outcomes;
  for (const json& line : report::read_kept(path, origin)) {
    try {
      const std::size_t index = line.at("trial");
      outcomes.insert_or_assign(index, outcome_of(line, plans.at(index)));
    } catch (const std::exception&) {  // no outcome of these plans: the trial is made again
    }
  }
  return outcomes;
}

}  // namespace farrier::blind
