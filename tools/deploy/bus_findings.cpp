#include "tools/deploy/bus_findings.hpp"

#include <fnmatch.h>

#include <algorithm>
#include <map>
#include <set>

#include "bus/topics.hpp"
#include "config/suggest.hpp"
#include "config/visitor.hpp"

namespace farrier::deploy {
namespace {

using namespace std::chrono_literals;
using bus::DiscoveredEndpoint;

/// Longer than the transport of a sample, even to a computer with other users.
constexpr Nanoseconds kSkewWorthSaying = 100ms;

/// Name of an endpoint in messages: "the Cyclone writer of 0110f3a2...".
std::string name_of(const DiscoveredEndpoint& endpoint) {
  const std::string vendor = endpoint.participant.substr(0, 4);
  return std::string("the ") + (vendor == "0110" ? "Cyclone " : vendor == "010f" ? "Fast DDS " : "") +
         (endpoint.writes ? "writer" : "reader") + " of process " + endpoint.participant;
}

std::string time_text(Nanoseconds time) {
  return time == bus::kInfinite ? "infinite"
                                : config::number_text(std::chrono::duration<double, std::milli>(time).count()) + " ms";
}

const bus::TopicSpec* spec_of(const std::string& topic) {
  const auto specs = bus::topics();
  const auto found =
      std::find_if(specs.begin(), specs.end(), [&](const bus::TopicSpec& s) { return s.name == topic; });
  return found == specs.end() ? nullptr : &*found;
}

std::vector<std::string> partitions_of(const DiscoveredEndpoint& endpoint) {
  return endpoint.partitions.empty() ? std::vector<std::string>{""} : endpoint.partitions;
}

bool meet(const DiscoveredEndpoint& a, const DiscoveredEndpoint& b) {
  for (const std::string& one : partitions_of(a)) {
    for (const std::string& other : partitions_of(b)) {
      // Either may be a pattern (DDS 1.4, 2.2.3.13).
      const auto matches = [](const std::string& pattern, const std::string& name) {
        return ::fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
      };
      if (one == other || matches(one, other) || matches(other, one)) {
        return true;
      }
    }
  }
  return false;
}

bool of_robot(const DiscoveredEndpoint& endpoint, const std::string& robot) {
  DiscoveredEndpoint whole = endpoint;
  whole.partitions = {bus::partition(robot), bus::partition(robot, "*")};
  return meet(endpoint, whole);
}

/// The policies that keep the two apart, each with both offers; empty when they go together (DDS 1.4, 2.2.3).
std::vector<std::string> misfits(const bus::Qos& offered, const bus::Qos& asked) {
  std::vector<std::string> found;
  const auto differ = [&](bool bad, const std::string& policy, const std::string& offer, const std::string& request) {
    if (bad) {
      found.push_back(policy + ": " + offer + " is offered and " + request + " is asked for");
    }
  };
  differ(offered.reliability < asked.reliability, "RELIABILITY", "best effort", "reliable");
  differ(offered.durability < asked.durability, "DURABILITY", "volatile", "transient local");
  differ(offered.deadline > asked.deadline, "DEADLINE", time_text(offered.deadline), time_text(asked.deadline));
  differ(offered.liveliness < asked.liveliness, "LIVELINESS kind", "automatic", "manual by topic");
  differ(offered.lease > asked.lease, "LIVELINESS lease", time_text(offered.lease), time_text(asked.lease));
  const auto ownership = [](bus::Ownership o) { return o == bus::Ownership::kShared ? "shared" : "exclusive"; };
  differ(offered.ownership != asked.ownership, "OWNERSHIP", ownership(offered.ownership), ownership(asked.ownership));
  return found;
}

class BusCheck {
 public:
  BusCheck(const bus::Discovery& found, const std::string& robot) : found_(found), robot_(robot) {}

  Findings run() {
    for (const DiscoveredEndpoint& endpoint : found_.endpoints) {
      check_contract(endpoint);
    }
    for (const DiscoveredEndpoint& writer : found_.endpoints) {
      for (const DiscoveredEndpoint& reader : found_.endpoints) {
        if (writer.writes && !reader.writes) {
          check_pair(writer, reader);
        }
      }
    }
    check_writers();
    check_clocks();
    return std::move(findings_);
  }

 private:
  /// Once, however many endpoints say the same.
  void report(const std::string& what, const std::string& fix) {
    if (said_.insert(what).second) {
      findings_.push_back({what, fix});
    }
  }

  void check_contract(const DiscoveredEndpoint& endpoint) {
    const bus::TopicSpec* spec = spec_of(endpoint.topic);
    if (spec == nullptr) {
      check_name(endpoint);
    } else if (endpoint.type != spec->type_name) {
      report(name_of(endpoint) + " has type " + endpoint.type + " for " + endpoint.topic + ", which is of " +
                 spec->type_name,
             "generate its types from idl/" + std::string(spec->idl) + " of this version");
    } else if (!of_robot(endpoint, robot_)) {
      const std::string partition = partitions_of(endpoint).front();
      const std::string right = spec->route == bus::Route::kLeg ? bus::partition(robot_, "<leg>")
                                                                : bus::partition(robot_);
      report(name_of(endpoint) + " has " + endpoint.topic + " in partition '" + partition + "', which is not robot " +
                 robot_ + "'s",
             "give it partition " + right + ", or ask for its robot");
    }
  }

  // A name that is no topic belongs to another system, unless it is nearly one of ours.
  void check_name(const DiscoveredEndpoint& endpoint) {
    std::vector<std::string> known;
    for (const bus::TopicSpec& spec : bus::topics()) {
      known.emplace_back(spec.name);
    }
    if (const std::string meant = config::suggest(endpoint.topic, known).name; !meant.empty()) {
      report(name_of(endpoint) + " has topic '" + endpoint.topic + "', which nobody else does",
             "if " + meant + " is meant, give it that name");
    }
  }

  void check_pair(const DiscoveredEndpoint& writer, const DiscoveredEndpoint& reader) {
    if (writer.topic != reader.topic || spec_of(writer.topic) == nullptr || !of_robot(writer, robot_) ||
        !meet(writer, reader)) {
      return;
    }
    for (const std::string& misfit : misfits(writer.qos, reader.qos)) {
      report(writer.topic + ", " + misfit + ", by " + name_of(writer) + " and " + name_of(reader),
             "give both the QoS that idl/README.md has; processes of a run have one --clock and one version");
    }
  }

  // Checks topics with several writers: those that only one process may write, and those in which authority decides.
  void check_writers() {
    std::map<std::pair<std::string, std::string>, std::vector<const DiscoveredEndpoint*>> writers;
    for (const DiscoveredEndpoint& endpoint : found_.endpoints) {
      if (endpoint.writes && of_robot(endpoint, robot_)) {
        for (const std::string& partition : endpoint.partitions) {
          writers[{endpoint.topic, partition}].push_back(&endpoint);
        }
      }
    }
    for (const auto& [place, several] : writers) {
      if (several.size() > 1) {
        check_rivals(place.first, several);
      }
    }
  }

  void check_rivals(const std::string& topic, const std::vector<const DiscoveredEndpoint*>& writers) {
    using bus::TopicId;
    std::set<std::string> processes;
    std::string list;
    bool equal_strength = false;
    for (const DiscoveredEndpoint* writer : writers) {
      if (processes.insert(writer->participant).second) {
        list += (list.empty() ? "" : ", ") + writer->participant;
      }
      equal_strength = equal_strength || (writer != writers.front() &&
                                          writer->ownership_strength == writers.front()->ownership_strength);
    }
    const bool one_alone = topic == bus::spec(TopicId::kJointSensors).name ||
                           topic == bus::spec(TopicId::kJointCommand).name ||
                           topic == bus::spec(TopicId::kGaitPhase).name || topic == bus::spec(TopicId::kClockTick).name;
    if (processes.size() > 1 && one_alone) {
      report("several processes write " + topic + " of robot " + robot_ + ": " + list,
             "end all but one: ps -ef | grep -e sim_bridge -e locomotion; two robots of a name need two domains");
    } else if (processes.size() > 1 && equal_strength && writers.front()->qos.ownership == bus::Ownership::kExclusive) {
      report("several processes write " + topic + " of robot " + robot_ + " with the same strength: " + list,
             "end all supervisors but one: ps -ef | grep supervisor");
    }
  }

  // Control uses ages on the steady clock; comparing records afterwards uses the wall clock.
  void check_clocks() {
    for (const bus::DiscoveredClock& clock : found_.clocks) {
      if (std::chrono::abs(clock.ahead) > kSkewWorthSaying) {
        report("the clock of process " + clock.participant + " is " +
                   config::number_text(std::chrono::duration<double>(std::chrono::abs(clock.ahead)).count()) + " s" +
                   (clock.ahead.count() > 0 ? " ahead of" : " behind") + " this computer's",
               "joints do not mind, records and logs of several computers do: apt install chrony on each, chronyc tracking");
      }
    }
  }

  const bus::Discovery& found_;
  const std::string& robot_;
  Findings findings_;
  std::set<std::string> said_;
};

}  // namespace

Findings bus_findings(const bus::Discovery& found, const std::string& robot, const bus::NetworkOptions& network) {
  if (!found.participants.empty()) {
    return BusCheck(found, robot).run();
  }
  std::string peers;
  for (const std::string& peer : network.peers) {
    peers += (peers.empty() ? "" : ", ") + peer;
  }
  return {{"nobody else is in domain " + std::to_string(network.domain) + ": looked on " + peers + " from " +
               network.address,
           "start the robot, or give the --domain, --address and --peers that its processes have (ps -ef)"}};
}

}  // namespace farrier::deploy
