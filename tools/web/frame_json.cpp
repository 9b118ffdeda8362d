#include "tools/web/frame_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/monitor/metric_state.hpp"
#include "tools/web/body_json.hpp"
#include "tools/web/supply_json.hpp"

namespace farrier::web {
namespace {

using nlohmann::json;

constexpr int kDigits = 6;

// Others may say anything in a name or a text: what is no UTF-8 is replaced, never thrown at.
std::string text_of(const json& document) { return document.dump(-1, ' ', false, json::error_handler_t::replace); }

json number(double value) {
  if (!std::isfinite(value)) {
    return nullptr;
  }
  if (value == 0.0) {
    return 0;
  }
  const int scale = kDigits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
  if (std::abs(scale) > 300) {
    return value;
  }
  // By a power of ten that is itself exact, where there is one: so 0.1 stays 0.1 in as many letters.
  return scale >= 0 ? std::round(value * std::pow(10.0, scale)) / std::pow(10.0, scale)
                    : std::round(value / std::pow(10.0, -scale)) * std::pow(10.0, -scale);
}

json tick(Tick value) { return value == kNoTick ? json(nullptr) : json(value); }

json event_of(const monitor::EventFrame& event) {
  return {{"n", event.number},        {"t", number(event.time_s)},
          {"tick", tick(event.tick)}, {"severity", static_cast<int>(event.severity)},
          {"who", event.who},         {"joint", event.joint},
          {"text", event.text}};
}

json gains_of(const signals::JointControllerGains& gains) {
  if (gains.generation == 0) {
    return nullptr;
  }
  return {gains.generation,      number(gains.k_position), number(gains.k_velocity),
          number(gains.k_force), number(gains.k_integral), number(gains.feed_forward)};
}

json summary_of(const signals::JointSummary& one) {
  return {
      one.tick,  number(one.force_reference_N_or_Nm), number(one.force_N_or_Nm), number(one.valve_current_A), one.phase,
      one.faults};
}

json estimate_of(const monitor::JointFrame& joint) {
  const signals::JointModelEstimate& estimate = joint.estimate;
  if (estimate.tick == kNoTick) {
    return nullptr;
  }
  json poles = json::array();
  for (const std::complex<double>& pole : joint.poles) {
    poles.push_back({number(pole.real()), number(pole.imag())});
  }
  return {{"tick", tick(estimate.tick)},
          {"validity", number(estimate.validity)},
          {"excitation", number(estimate.excitation)},
          {"error", number(estimate.prediction_error)},
          {"mass", joint.mass_kg_or_kgm2 ? number(*joint.mass_kg_or_kgm2) : json(nullptr)},
          {"poles", std::move(poles)}};
}

json decision_of(const signals::JointUpdateDecision& decision) {
  if (decision.tick == kNoTick) {
    return nullptr;
  }
  return {{"tick", tick(decision.tick)},
          {"verdict", to_string(decision.verdict)},
          {"phase", decision.phase},
          {"radius", number(decision.estimated_radius)}};
}

json joint_of(const monitor::JointFrame& joint) {
  json summaries = json::array();
  for (const signals::JointSummary& one : joint.summaries) {
    summaries.push_back(summary_of(one));
  }
  const std::optional<double> nrmse = joint.nrmse();
  return {{"s", std::move(summaries)},
          {"age", number(joint.age_s)},
          {"rate", number(joint.rate_Hz)},
          {"missed", joint.missed_ticks},
          {"nrmse", nrmse ? number(*nrmse) : json(nullptr)},
          {"state", joint.newest.tick == kNoTick ? json(nullptr) : json(joint.newest.state)},
          {"phase", joint.newest.phase},
          {"generation", joint.newest.generation},
          {"faults", joint.faults},
          {"gains", {gains_of(joint.gains[0]), gains_of(joint.gains[1])}},
          {"estimate", estimate_of(joint)},
          {"decision", decision_of(joint.decision)},
          {"redesigns", joint.redesigns}};
}

json process_of(const monitor::ParticipantFrame& process, std::size_t number_of_it) {
  const std::string_view name = signals::text_of(process.hello.name);
  return {{"name", name.empty() ? "participant " + std::to_string(number_of_it) : std::string(name)},
          {"age", number(process.age_s)},
          {"lost", process.lost()},
          {"missed", process.health.missed_periods}};
}

}  // namespace

std::string robot_json(const robot::Robot& robot, bool recorded) {
  json joints = json::array();
  for (const robot::Joint& joint : robot.joints) {
    joints.push_back({{"name", joint.name},
                      {"leg", joint.leg},
                      {"unit", joint.rotary ? "Nm" : "N"},
                      {"mass_unit", joint.rotary ? "kg m²" : "kg"}});
  }
  json legs = json::array();
  for (const gait::LegPlan& leg : robot.plan.legs) {
    legs.push_back(leg.name);
  }
  json faults = json::array();
  json failures = json::array();
  for (const FaultInfo& info : kFaults) {
    faults.push_back(info.name);
    failures.push_back(info.failed());
  }
  return text_of({{"name", robot.name},
                  {"period_s", robot.period_s},
                  {"recorded", recorded},
                  {"joints", std::move(joints)},
                  {"legs", std::move(legs)},
                  {"body", body_shapes(robot)},
                  {"supply", supply_facts(robot)},
                  {"faults", std::move(faults)},
                  {"failures", std::move(failures)},
                  {"silent_s", monitor::kSilent_s},
                  {"states",
                   {to_string(signals::JointState::kNull), to_string(signals::JointState::kDamping),
                    to_string(signals::JointState::kTracking)}},
                  {"phases", {to_string(signals::Phase::kSwing), to_string(signals::Phase::kStance)}}});
}

std::string frame_json(const monitor::Frame& frame) {
  json joints = json::array();
  for (const monitor::JointFrame& joint : frame.joints) {
    joints.push_back(joint_of(joint));
  }
  json processes = json::array();
  for (std::size_t i = 0; i < frame.participants.size(); ++i) {
    if (frame.participants[i].hello.session != 0 || frame.participants[i].health.tick != kNoTick) {
      processes.push_back(process_of(frame.participants[i], i));
    }
  }
  json events = json::array();
  for (const monitor::EventFrame& event : frame.events) {
    events.push_back(event_of(event));
  }
  json phases = json::array();
  for (const signals::Phase phase : frame.phases) {
    phases.push_back(static_cast<int>(phase));
  }
  const bool known = frame.mode.epoch != 0;
  return text_of({{"t", number(frame.time_s)},
                  {"tick", tick(frame.tick)},
                  {"age", number(frame.age_s)},
                  {"mode", known ? json(to_string(frame.mode.mode)) : json(nullptr)},
                  {"lost", frame.lost_samples},
                  {"phases", std::move(phases)},
                  {"joints", std::move(joints)},
                  {"body", body_json(frame.body)},
                  {"supply", supply_json(frame.supply, frame.joints.size())},
                  {"processes", std::move(processes)},
                  {"events", std::move(events)}});
}

std::string event_json(const monitor::EventFrame& event) { return text_of(event_of(event)); }

}  // namespace farrier::web
