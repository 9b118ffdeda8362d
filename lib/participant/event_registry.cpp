#include "participant/event_registry.hpp"

#include <array>

#include "core/fault.hpp"
#include "signals/words.hpp"

namespace farrier::participant {
namespace {

using enum EventKind;
using enum signals::Severity;

// clang-format off
constexpr std::array kEvents{
    EventSpec{kJointNulled, "<faults>", "joint_node", kWarning, "The joint's valve is at null for these faults.",
              "Fix the causes beside `tripped`; then `farrier request arm --session <number>`."},
    EventSpec{kJointFaults, "<faults>; no fault", "joint_node", kInfo, "The joint's faults have changed, and its valve is not at null.", "See the table of [architecture.md](architecture.md#what-a-joint-does-when-something-is-missing)."},
    EventSpec{kGainsRefused, "gains refused: <why>", "joint_node", kWarning, "Gains came that a joint does not take up; it keeps those it has.", "Supervisor and joint_node of one version; somebody else may write the topic: `farrier topics`."},
    EventSpec{kReplacedSupervisorRefused, "orders of a supervisor that has been replaced are refused: authority <number> after <number>", "joint_node, sim_bridge", kWarning, "A supervisor that another one has taken over from still gives orders.", "End it; started again it stands by."},
    EventSpec{kGainsKept, "<phase> gains kept: <verdict>", "supervisor", kInfo, "An estimate asked for new gains, and no design for it was good enough.", ""},
    EventSpec{kSupervisorLeads, "leads with authority <number>", "supervisor", kWarning, "It has taken over from a supervisor that went silent.", "See why the other one did: its log."},
    EventSpec{kSupervisorStandsBy, "stands by: another supervisor leads with authority <number>", "supervisor", kWarning, "It led, and has been replaced.", "See why it was silent."},
    EventSpec{kOperatorRequest, "an operator's request: <request>", "supervisor", kWarning, "Somebody has asked for it by `farrier request`.", ""},
    EventSpec{kEstimatesBegin, "estimates from now on", "estimator_service", kInfo, "It hears the joints.", ""},
    EventSpec{kValveSilent, info_of(Fault::kActuatorSilent).event_text(), "sim_bridge", kWarning, "None has come for `safety.valve_silent_s`: the joint's spool is at null.", "See whether its joint_node runs: `farrier topics`."},
    EventSpec{kValveHeard, "valve commands heard again", "sim_bridge", kInfo, "The spool follows them.", ""},
    EventSpec{kEstimatesSilent, "estimates silent", "supervisor", kWarning, "None has come for five of their periods: gains stay as they are.", "See whether estimator_service runs, and hears the joints: `farrier topics`."},
    EventSpec{kEstimatesHeard, "estimates heard again", "supervisor", kInfo, "Gains follow them.", ""},
    EventSpec{kSupervisorSilent, "supervisor silent", "joint_node", kWarning, "No mode has come for 50 ms: gains and mode stay as they are, and nobody arms a joint that trips.", "See whether a supervisor runs: `farrier topics`; started again it goes on."},
    EventSpec{kSupervisorHeard, "supervisor heard again", "joint_node", kInfo, "That one, or another that has taken over.", ""},
    EventSpec{kSupplyLow, "supply low", "sim_bridge", kWarning, "The pressure of the hydraulic supply is below `supply.low_share` of the nominal one.", "See `supply/state`: `pump_flow_m3_s` less than the pump should give, or `flow_m3_s` more than it can."},
    EventSpec{kSupplyRecovered, "supply recovered", "sim_bridge", kInfo, "The pressure is above `supply.recovered_share` of the nominal one.", ""},
    EventSpec{kSupplySlow, "slows down: the supply falls", "locomotion", kWarning, "The pressure is below `supply.slow_share` of the nominal one. The velocities of a trot shrink, down to `supply.slowest` of those commanded.", "See `supply/state`: the pump gives less oil than the trot needs."},
    EventSpec{kSupplyFast, "as fast as commanded again", "locomotion", kInfo, "The pressure was above `supply.recovered_share` for long enough.", ""},
    EventSpec{kSupplyStand, "stands: the supply is low", "locomotion", kWarning, "The supply was low for `supply.stand_after_s`. A trot ends until the supply has recovered and an operator asks to stand or lie.", "Fix the supply; ask to stand, then to trot."},
    EventSpec{kSupplyLie, "lies down: the supply cannot carry the robot", "locomotion", kWarning, "Its pressure is below `supply.lie_share` of the nominal one, or the pump gives no oil. The robot lies until the supply has recovered and an operator asks to lie.", "Fix the supply; ask to lie, then to stand."},
    EventSpec{kJointDead, "lies down: a joint does not follow", "locomotion", kWarning, "The joint neither moved nor had the torque that it was asked for, for `locomotion.joint_guard.dead_after_s`. The robot lies until an operator asks to lie.", "See the joint's valve; ask to lie, then to stand."},
    EventSpec{kTraceIncomplete, "the trace is incomplete: disk full?", "sim_bridge", kError, "Rows of `--trace` could not be written.", "Make room; run again."},
    EventSpec{kWorldFailed, "<why>", "sim_bridge", kError, "The simulated body has no next state: a number is not finite or too large. The run ends.", "See whether forces of the scene or gains are too large for the body."},
    EventSpec{kNumberTaken, "<process> is participant <number> of this run already: end it first", "any", kError, "Two processes have one place in the robot; this one does not begin.", "`farrier doctor` names both."},
    EventSpec{kSecurity, "security: <why>", "any", kWarning, "DDS Security refused somebody, or something that somebody did.", "[security.md](security.md)."},
    EventSpec{kFaultOnPurpose, "fault on purpose: <fault>", "any", kWarning, "A fault that this process was started with (`--fault`) acts for the first time on what it hears.", ""},
};
// clang-format on

constexpr bool in_order() {
  for (std::size_t i = 0; i < kEvents.size(); ++i) {
    if (static_cast<std::size_t>(kEvents[i].kind) != i) {
      return false;
    }
  }
  return true;
}
static_assert(in_order(), "the registry is indexed by EventKind");

}  // namespace

std::span<const EventSpec> event_specs() noexcept { return kEvents; }

const EventSpec& spec(EventKind kind) noexcept { return kEvents[static_cast<std::size_t>(kind)]; }

std::string text_of(EventKind kind, std::string_view detail) {
  const std::string_view text = spec(kind).text;
  return std::string(text.substr(0, text.find('<'))).append(detail);
}

std::string events_table_markdown() {
  std::string table = "| text | of | severity | means | what to do |\n|---|---|---|---|---|\n";
  for (const EventSpec& event : kEvents) {
    table += std::string("| `") + event.text + "` | " + event.writers + " | " + signals::to_string(event.severity) +
             " | " + event.meaning + " | " + event.remedy + " |\n";
  }
  return table;
}

}  // namespace farrier::participant
