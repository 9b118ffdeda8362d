#pragma once

#include <algorithm>
#include <string>

#include "bus/topics.hpp"
#include "tools/monitor/joint_row.hpp"
#include "tools/monitor/metric_table.hpp"

namespace farrier::display {

/// Calls use(robot::Joint, JointFrame, its leg's name) for every joint.
template <class Use>
void each_joint(const MetricState& state, Use&& use) {
  for (const robot::Joint& joint : state.robot.joints) {
    if (joint.number < state.frame.joints.size()) {
      use(joint, state.frame.joints[joint.number], state.robot.plan.legs[static_cast<std::size_t>(joint.leg)].name);
    }
  }
}

/// The same for every joint that was heard of.
template <class Use>
void each_heard_joint(const MetricState& state, Use&& use) {
  each_joint(state, [&](const robot::Joint& joint, const monitor::JointFrame& frame, const std::string& leg) {
    if (frame.newest.tick != kNoTick) {
      use(joint, frame, leg);
    }
  });
}

/// A value of every joint that was heard of, cylinders or motors alone: newtons and newton metres are two metrics.
template <bool kRotary, class Value>
void force_of_joints(const MetricState& state, const Sample& sample, Value&& value) {
  each_heard_joint(state, [&](const robot::Joint& joint, const monitor::JointFrame& frame, const std::string& leg) {
    if (joint.rotary == kRotary) {
      sample(value(frame), {leg, joint.name});
    }
  });
}

/// Calls use(ParticipantFrame, name) for every process that was heard of. Each has a name of its own.
template <class Use>
void each_process(const MetricState& state, Use&& use) {
  std::vector<std::string> names;
  for (const monitor::ParticipantFrame& process : state.frame.participants) {
    if (process.hello.session == 0) {
      continue;
    }
    std::string name = printable(signals::text_of(process.hello.name));
    if (std::ranges::find(names, name) != names.end()) {
      name += " (" + std::to_string(process.hello.participant) + ")";  // two alike would invalidate the whole scrape
    }
    names.push_back(name);
    use(process, name);
  }
}

/// The same for every process that has reported its health.
template <class Use>
void each_healthy_process(const MetricState& state, Use&& use) {
  each_process(state, [&](const monitor::ParticipantFrame& process, const std::string& name) {
    if (process.health.tick != kNoTick) {
      use(process, name);
    }
  });
}

/// SystemHealth's percentiles of a time, of the processes that have measured it.
inline void percentiles(const MetricState& state, const Sample& sample,
                        std::array<double, 4> signals::SystemHealth::* times) {
  constexpr std::array kPercentiles{"50", "99", "99.9", "100"};
  each_healthy_process(state, [&](const monitor::ParticipantFrame& process, const std::string& name) {
    const std::array<double, 4>& measured = process.health.*times;
    for (std::size_t i = 0; i < measured.size() && measured.back() > 0.0; ++i) {
      sample(measured[i], {name, kPercentiles[i]});
    }
  });
}

/// Counts by topic, of topics that a process has anything to do with.
inline void topic_counts(const MetricState& state, const Sample& sample,
                         std::array<std::uint64_t, signals::kMaxTopics> signals::SystemHealth::* counts) {
  each_healthy_process(state, [&](const monitor::ParticipantFrame& process, const std::string& name) {
    for (const bus::TopicSpec& topic : bus::topics()) {
      const auto i = static_cast<std::size_t>(topic.id);
      if (process.health.sent[i] + process.health.received[i] + process.health.lost[i] > 0) {
        sample(static_cast<double>((process.health.*counts)[i]), {name, topic.name});
      }
    }
  });
}

}  // namespace farrier::display
