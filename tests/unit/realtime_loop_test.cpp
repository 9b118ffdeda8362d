// What the sender thread does at leisure, and that it is called back from it.

#include "participant/realtime_loop.hpp"

#include <sched.h>

#include <atomic>
#include <functional>
#include <thread>

#include "runtime/realtime_thread.hpp"
#include "tests/unit/participant_run.hpp"

namespace farrier::participant {
namespace {

using namespace std::chrono_literals;
using namespace testing;
using signals::SystemHello;

int priority_of_this_thread() {
  sched_param parameters{};
  sched_getparam(0, &parameters);
  return parameters.sched_priority;
}

/// Steps every 10 ms. Its first leisure lasts until the thread is raised out of it, at most 2 s.
class Leisurely final : public RealtimeApplication {
 public:
  explicit Leisurely(std::function<void()> end) : end_(std::move(end)) {}

  bool receive(SteadyTime) override {
    if (seen_.load()) {
      end_();
    }
    return true;
  }
  void step(const Wake&) noexcept override {}
  void send() override { ++sends; }
  void send_at_leisure() override {
    if (seen_.load()) {
      return;
    }
    at_leisure = priority_of_this_thread();
    for (int i = 0; at_leisure != 0 && i < 2000 && priority_of_this_thread() == at_leisure; ++i) {
      std::this_thread::sleep_for(1ms);
    }
    called_back = priority_of_this_thread();
    sends_before = sends;
    seen_.store(true);
  }
  bool finished() const override { return false; }
  Nanoseconds period() const override { return 10ms; }
  Trigger trigger() const override { return Trigger::kDeadline; }
  std::string waits_for() const override { return ""; }

  int at_leisure = 0, called_back = 0;
  int sends = 0, sends_before = 0;

 private:
  std::function<void()> end_;
  std::atomic<bool> seen_{false};
};

TEST(RealtimeLoopTest, OutputsCallTheSenderBackFromItsLeisure) {
  const TestRun run(2);
  const Member member = run.join(kSimBridge, "clock");
  const auto bus = run.bus();
  const bus::EndpointSpec endpoint = endpoint_of(run.identity(1, ""), bus::TopicId::kSystemHello);
  auto stranger = bus::Publisher<SystemHello>::create(*bus, endpoint).value();
  SystemHello foreign;  // which no participant runs with: it ends the loop
  foreign.participant = 1;
  foreign.session = kSession;
  foreign.contract = bus::contract_hash() ^ 1;
  Leisurely application([&] {
    stranger.publish(foreign);
    member->started(run.now());
  });
  EXPECT_EQ(run_realtime(application, *member.participant, 1), 1);
  if (application.at_leisure == 0) {
    GTEST_SKIP() << "needs the right to SCHED_FIFO";
  }
  EXPECT_EQ(application.at_leisure, runtime::kLeisurePriority + 1);
  EXPECT_EQ(application.called_back, runtime::kBusPriority + 1);
  EXPECT_GT(application.sends, application.sends_before);
}

}  // namespace
}  // namespace farrier::participant
