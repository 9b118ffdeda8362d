#include "report/figures/outcome.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "core/replace_file.hpp"

namespace farrier::report {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_of(const Figure& figure) {
  Json json{{"name", figure.name}, {"value", number(figure.value)}, {"unit", figure.spec->unit}};
  if (figure.bound) {
    json["relation"] = to_string(figure.spec->relation);
    json["bound"] = *figure.bound;
    json["holds"] = figure.holds();
  }
  return json;
}

Json json_of(const Claim& claim) {
  Json by_seed = Json::array();
  for (const double value : claim.values) {
    by_seed.push_back(number(value));
  }
  Json json{{"id", claim.id},
            {"figure", claim.figure},
            {"section", claim.section},
            {"sentence", claim.sentence},
            {"claim", claim.claim},
            {"kind", claim.kind},
            {"measured",
             {{"name", claim.name},
              {"value", number(claim.value)},
              {"worst", number(claim.worst)},
              {"by_seed", std::move(by_seed)},
              {"unit", claim.unit},
              {"relation", to_string(claim.relation)},
              {"bound", claim.bound}}},
            {"verdict", claim.verdict},
            {"reason", claim.reason}};
  if (claim.condition) {
    json["condition"] = {{"name", claim.condition->name},
                         {"meaning", claim.condition->meaning},
                         {"source", claim.condition->source},
                         {"value", number(claim.condition->value)},
                         {"worst", number(claim.condition->worst)}};
  }
  if (!claim.tried.empty()) {
    json["tried"] = claim.tried;
  }
  return json;
}

/// Counts of claims by kind and verdict.
Json totals_of(const std::vector<Claim>& claims) {
  Json totals = Json::object();
  for (const Claim& claim : claims) {
    Json& count = totals[claim.kind][claim.verdict];
    count = count.is_null() ? 1 : count.get<int>() + 1;
  }
  return totals;
}

Json json_of(const ProcessInfo& process) {
  Json topics = Json::array();
  for (const TopicCount& topic : process.topics) {
    topics.push_back(
        {{"topic", topic.topic}, {"sent", topic.sent}, {"received", topic.received}, {"lost", topic.lost}});
  }
  Json json{{"name", process.name},
            {"number", process.number},
            {"pid", process.pid},
            {"vendor", process.vendor},
            {"missed_periods", process.missed_periods},
            {"topics", std::move(topics)}};
  if (process.growth) {
    json["growth"] = {{"memory_KiB", process.growth->memory_KiB},
                      {"threads", process.growth->threads},
                      {"descriptors", process.growth->descriptors}};
  }
  return json;
}

Json poles_of(const std::array<double, 3>& re, const std::array<double, 3>& im) {
  Json poles = Json::array();
  for (std::size_t i = 0; i < re.size(); ++i) {
    poles.push_back({re[i], im[i]});  // null where not finite
  }
  return poles;
}

Json json_of(const DecisionInfo& info) {
  const signals::JointUpdateDecision& decision = info.decision;
  return {{"tick", decision.tick},
          {"joint", info.joint},
          {"phase", signals::to_string(decision.phase)},
          {"verdict", signals::to_string(decision.verdict)},
          {"generation", decision.generation},
          {"validity", decision.validity},
          {"excitation", decision.excitation},
          {"prediction_error", decision.prediction_error},
          {"whiteness", decision.whiteness},
          {"pole_distance", decision.pole_distance},
          {"pole_spread", decision.pole_spread},
          {"poles", poles_of(decision.poles_re, decision.poles_im)},
          {"designed_poles", poles_of(decision.designed_poles_re, decision.designed_poles_im)},
          {"estimated_radius", decision.estimated_radius},
          {"stored_radius", decision.stored_radius},
          {"disk_margin", decision.disk_margin},
          {"delay_margin_s", decision.delay_margin_s},
          {"dwell_ticks", decision.dwell_ticks}};
}

Json json_of(const RunInfo& run) {
  Json processes = Json::array();
  Json decisions = Json::array();
  for (const DecisionInfo& decision : run.decisions) {
    decisions.push_back(json_of(decision));
  }
  for (const ProcessInfo& process : run.processes) {
    processes.push_back(json_of(process));
  }
  return {{"version", run.version},
          {"git_revision", run.git_revision},
          {"configuration", run.configuration},
          {"configuration_hash", run.configuration_hash},
          {"seed", run.seed},
          {"machine",
           {{"cpu_model", run.machine.cpu_model},
            {"cores", run.machine.cores},
            {"kernel", run.machine.kernel},
            {"memory_bytes", run.machine.memory_bytes}}},
          {"processes", std::move(processes)},
          {"decisions", std::move(decisions)}};
}

}  // namespace

std::string to_json(const Outcome& outcome) {
  Json json{{"command", outcome.command}, {"verdict", outcome.verdict()}};
  if (!outcome.failures.empty()) {
    json["failures"] = outcome.failures;
  }
  if (!outcome.warnings.empty()) {
    json["warnings"] = outcome.warnings;
  }
  json["figures"] = Json::array();
  for (const Figure& figure : outcome.figures.all()) {
    json["figures"].push_back(json_of(figure));
  }
  if (!outcome.claims.empty()) {
    json["totals"] = totals_of(outcome.claims);
  }
  for (const Claim& claim : outcome.claims) {
    json["claims"].push_back(json_of(claim));
  }
  json["run"] = json_of(outcome.run);
  constexpr int kIndent = 2;
  // Text from outside, such as a configuration, may be no UTF-8: replaced rather than thrown about.
  return json.dump(kIndent, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Done> write_json(const std::string& path, const Outcome& outcome) {
  return replace_file(path, to_json(outcome));
}

}  // namespace farrier::report
