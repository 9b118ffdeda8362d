#include "recorder/recorder.hpp"

#include <algorithm>

#include "recorder/journal_streams.hpp"
#include "recorder/stream.hpp"
#include "recorder/watching_endpoint.hpp"
#include "robot/keys.hpp"
#include "recording/loss_count.hpp"
#include "signals/cdr.hpp"
#include "signals/journal.hpp"
#include "signals/tick_of.hpp"

namespace farrier::recorder {
namespace {

/// Samples of a key that may wait while this process is stopped: a quarter of a second at 1 kHz.
constexpr int kDepth = 256;

/// Journals of a stream that may wait meanwhile: a second and more.
constexpr int kJournalDepth = 128;

/// A port of somebody who takes part.
template <class Signal>
struct Port {
  participant::In<Signal>* in;
  template <class Use>
  void drain(Use&& use) {
    in->drain(use);
  }
  bus::ReaderStatus status() const { return in->status(); }
};

/// `Heard`: a Port or a subscription.
template <class Signal, class Heard>
class TypedTap final : public Tap {
 public:
  explicit TypedTap(Heard heard) : heard_(std::move(heard)) {}

  void drain(const recording::TakeSample& take) override {
    const Now now;
    heard_.drain([&](const Signal& signal) {
      if (!signals::is_probe(signal)) {
        losses_.heard(signal);
        signals::to_cdr(signal, cdr_);
        stream_.hand_on(signal, cdr_, now, 0, take);
      }
    });
  }
  void append_progress(std::vector<TopicProgress>& all) const override {
    all.push_back(stream_.progress(losses_.lost(), heard_.status()));
  }

 private:
  Heard heard_;
  Stream<Signal> stream_;
  recording::LossCount<Signal> losses_;
  std::vector<std::uint8_t> cdr_;
};

/// Tap of a topic that processes keep journals of.
template <class Heard>
class JournalTap final : public Tap {
 public:
  explicit JournalTap(Heard heard) : heard_(std::move(heard)) {}

  void drain(const recording::TakeSample& take) override {
    const Now now;
    heard_.drain([&](const signals::SystemJournal& journal) { streams_.take(journal, now, take); });
  }
  void append_progress(std::vector<TopicProgress>& all) const override {
    streams_.append_progress(all, heard_.status());
  }

 private:
  Heard heard_;
  JournalStreams streams_;
};

/// Endpoint of a polled reader: its samples wake no thread.
bus::EndpointSpec leisurely_endpoint(const robot::Robot& robot, bus::TopicId topic, int depth) {
  bus::EndpointSpec endpoint = watching_endpoint(robot, topic, depth);
  endpoint.wakes = false;
  return endpoint;
}

template <class Signal>
Result<std::unique_ptr<Tap>> watch(bus::Bus& bus, const robot::Robot& robot) {
  using Heard = bus::Subscription<Signal>;
  auto heard = FARRIER_TRY(Heard::create(bus, leisurely_endpoint(robot, bus::TopicOf<Signal>::id, kDepth)));
  return std::unique_ptr<Tap>(std::make_unique<TypedTap<Signal, Heard>>(std::move(heard)));
}

/// True for signals of the whole robot: on a bench nobody publishes them.
template <class Signal>
inline constexpr bool kMayBeAbsent =
    std::is_same_v<Signal, signals::BodyImu> || std::is_same_v<Signal, signals::BodyTruth> ||
    std::is_same_v<Signal, signals::BodyState> || std::is_same_v<Signal, signals::BodyCommand> ||
    std::is_same_v<Signal, signals::SupplyState> || std::is_same_v<Signal, signals::SupplyTruth>;

bool may_be_absent(bus::TopicId topic) {
#define FARRIER_MAY_BE_ABSENT(Signal, file) kMayBeAbsent<signals::Signal>,
  static constexpr bool kAll[] = {FARRIER_SIGNALS(FARRIER_MAY_BE_ABSENT)};
#undef FARRIER_MAY_BE_ABSENT
  return kAll[static_cast<std::size_t>(topic)];
}

/// Keys that a participant must hear on a topic before the run begins.
template <class Signal>
std::vector<std::uint16_t> keys_of(const robot::Robot& robot, const participant::Identity& identity) {
  if constexpr (std::is_same_v<Signal, signals::GaitPhase>) {
    return robot::leg_numbers(robot);
  } else if constexpr (std::is_same_v<Signal, signals::ClockTickDone>) {
    std::vector<std::uint16_t> all_but_the_clock;
    for (std::uint16_t number = participant::kSimBridge + 1; number < identity.participants; ++number) {
      all_but_the_clock.push_back(number);
    }
    return all_but_the_clock;
  } else if constexpr (kMayBeAbsent<Signal> || std::is_same_v<Signal, signals::SystemRequest>) {
    return {};  // operators come and go
  } else if constexpr (requires(Signal signal) { signal.joint; }) {
    return robot::joint_numbers(robot);
  } else {
    return {0};
  }
}

/// True for signals that every process publishes without a port, so that the greeting does not probe them.
template <class Signal>
inline constexpr bool kWithoutPorts =
    std::is_same_v<Signal, signals::SystemHello> || std::is_same_v<Signal, signals::SystemHealth> ||
    std::is_same_v<Signal, signals::SystemEvent>;

template <class Signal>
Result<std::unique_ptr<Tap>> take_part(participant::Participant& participant, const robot::Robot& robot) {
  if constexpr (kWithoutPorts<Signal>) {
    return watch<Signal>(participant.bus(), robot);
  } else {
    const bool by_leg = bus::spec(bus::TopicOf<Signal>::id).route == bus::Route::kLeg;
    auto in = FARRIER_TRY(
        participant.subscribe<Signal>(keys_of<Signal>(robot, participant.identity()),
                                      by_leg ? robot::legs_of_joints(robot) : std::vector<std::string>{}, kDepth));
    return std::unique_ptr<Tap>(std::make_unique<TypedTap<Signal, Port<Signal>>>(Port<Signal>{in}));
  }
}

template <class Heard>
std::unique_ptr<Tap> make_journal_tap(Heard heard) {
  return std::make_unique<JournalTap<Heard>>(std::move(heard));
}

/// Streams that participants of a run in lock-step keep journals of.
std::vector<std::uint16_t> journalled_streams(const participant::Identity& identity) {
  const int processes = identity.participants - (identity.launches ? 1 : 0);
  std::vector<std::uint16_t> streams;
  for (std::uint16_t number = 0; number < processes; ++number) {
    for (const bus::TopicSpec& topic : bus::topics()) {
      if (is_journalled(topic.id) && !may_be_absent(topic.id) && topic.writers.contains(participant::role_of(number))) {
        streams.push_back(signals::stream_of(number, static_cast<std::uint8_t>(topic.id)));
      }
    }
  }
  return streams;
}

/// The two kinds of tap of one topic, with and without ports of a participant.
struct MakeTap {
  Result<std::unique_ptr<Tap>> (*watch)(bus::Bus&, const robot::Robot&);
  Result<std::unique_ptr<Tap>> (*take_part)(participant::Participant&, const robot::Robot&);
};

#define FARRIER_TAP(Signal, file) {&watch<signals::Signal>, &take_part<signals::Signal>},
constexpr MakeTap kTaps[] = {FARRIER_SIGNALS(FARRIER_TAP)};
#undef FARRIER_TAP

}  // namespace

Result<Recorder> Recorder::create(bus::Bus& bus, const robot::Robot& robot, const std::vector<bus::TopicId>& topics) {
  std::vector<std::unique_ptr<Tap>> taps;
  for (const bus::TopicSpec& topic : bus::topics()) {
    const bool chosen = std::ranges::find(topics, topic.id) != topics.end();
    if (!chosen && (!topics.empty() || topic.id == bus::TopicId::kSystemJournal)) {
      continue;
    }
    taps.push_back(FARRIER_TRY(kTaps[static_cast<std::size_t>(topic.id)].watch(bus, robot)));
  }
  return Recorder(std::move(taps));
}

Result<Recorder> Recorder::of_journals(bus::Bus& bus, const robot::Robot& robot) {
  std::vector<bus::TopicId> others;
  for (const bus::TopicSpec& topic : bus::topics()) {
    if (!is_journalled(topic.id) && topic.id != bus::TopicId::kSystemJournal) {
      others.push_back(topic.id);
    }
  }
  auto recorder = FARRIER_TRY(create(bus, robot, others));
  auto journals = FARRIER_TRY(bus::Subscription<signals::SystemJournal>::create(
      bus, leisurely_endpoint(robot, bus::TopicId::kSystemJournal, kJournalDepth)));
  recorder.taps_.push_back(make_journal_tap(std::move(journals)));
  return recorder;
}

Result<Recorder> Recorder::of_journals(participant::Participant& participant, const robot::Robot& robot) {
  std::vector<std::unique_ptr<Tap>> taps;
  for (const bus::TopicSpec& topic : bus::topics()) {
    if (is_journalled(topic.id) || topic.id == bus::TopicId::kSystemJournal) {
      continue;
    }
    taps.push_back(FARRIER_TRY(kTaps[static_cast<std::size_t>(topic.id)].take_part(participant, robot)));
  }
  auto journals = FARRIER_TRY(
      participant.subscribe<signals::SystemJournal>(journalled_streams(participant.identity()), {}, kJournalDepth));
  taps.push_back(make_journal_tap(Port<signals::SystemJournal>{journals}));
  return Recorder(std::move(taps));
}

void Recorder::drain(const recording::TakeSample& take) {
  for (const auto& tap : taps_) {
    tap->drain(take);
  }
}

std::vector<TopicProgress> Recorder::progress() const {
  std::vector<TopicProgress> all;
  for (const auto& tap : taps_) {
    tap->append_progress(all);
  }
  return all;
}

recording::TopicCounts Recorder::lost() const {
  recording::TopicCounts lost{};
  for (const TopicProgress& one : progress()) {
    lost[static_cast<std::size_t>(one.topic)] = one.lost;
  }
  return lost;
}

}  // namespace farrier::recorder
