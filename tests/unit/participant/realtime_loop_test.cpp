// The sender thread has a lower priority until outputs call it back. A control thread that could not run lets in the
// inputs that came meanwhile.

#include "participant/realtime_loop.hpp"

#include <sched.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <functional>
#include <thread>

#include "runtime/realtime_thread.hpp"
#include "tests/unit/participant/run.hpp"

namespace farrier::participant {
namespace realtime_loop_test {

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

/// Gets inputs every few milliseconds, for 2 s, and steps on them.
class Fed : public RealtimeApplication {
 public:
  explicit Fed(std::function<void()> end) : end_(std::move(end)) {}

  bool receive(SteadyTime now) override {
    begin_ = begin_ == SteadyTime{} ? now : begin_;
    if (now - begin_ > 2s) {
      over_.store(true);
      end_();
    }
    inputs_.fetch_add(1);
    inputs_complete.post();
    return true;
  }
  void step(const Wake&) noexcept override {
    ++steps;
    const int inputs = inputs_.load();
    steps_without_inputs += inputs == stepped_for_ && !over_.load() ? 1 : 0;
    stepped_for_ = inputs;
  }
  void send() override {}
  bool finished() const override { return false; }
  Nanoseconds period() const override { return 200ms; }
  Trigger trigger() const override { return Trigger::kArrival; }
  std::string waits_for() const override { return ""; }

  int steps = 0, steps_without_inputs = 0;

 private:
  std::function<void()> end_;
  SteadyTime begin_{};
  std::atomic<int> inputs_{0};
  std::atomic<bool> over_{false};
  int stepped_for_ = 0;
};

/// Runs an application until it calls what its constructor gets.
template <class Application>
class LoopRun {
 public:
  int run(int priority_shift) {
    return run_realtime(application, *member_.participant, priorities_of(application, priority_shift, false));
  }

  Application application{[this] { end(); }};

 private:
  // A contract which no participant runs with ends the loop.
  void end() {
    SystemHello foreign;
    foreign.participant = 1;
    foreign.session = kSession;
    foreign.contract = bus::contract_hash() ^ 1;
    stranger_.publish(foreign);
    member_->started(run_.now());
  }

  const TestRun run_{2};
  const Member member_ = run_.join(kSimBridge, "clock");
  const std::unique_ptr<bus::Bus> bus_ = run_.bus();
  bus::Publisher<SystemHello> stranger_ =
      bus::Publisher<SystemHello>::create(*bus_, endpoint_of(run_.identity(1, ""), bus::TopicId::kSystemHello)).value();
};

/// Stops this process three times, each time for longer than a `Fed` waits for inputs.
pid_t start_stopping_this_process() {
  const pid_t self = ::getpid();
  const pid_t stopping = ::fork();
  if (stopping == 0) {
    for (int i = 0; i < 3; ++i) {
      ::usleep(150'000);
      ::kill(self, SIGSTOP);
      ::usleep(450'000);
      ::kill(self, SIGCONT);
    }
    ::_exit(0);
  }
  return stopping;
}

TEST(RealtimeLoopTest, AThreadThatCouldNotRunLetsWhatCameMeanwhileIn) {
  LoopRun<Fed> loop;
  const pid_t stopping = start_stopping_this_process();
  EXPECT_EQ(loop.run(0), 1);
  int status = 0;
  EXPECT_EQ(::waitpid(stopping, &status, 0), stopping);
  EXPECT_GT(loop.application.steps, 10);
  EXPECT_EQ(loop.application.steps_without_inputs, 0);
}

TEST(RealtimeLoopTest, OutputsCallTheSenderBackFromItsLeisure) {
  LoopRun<Leisurely> loop;
  EXPECT_EQ(loop.run(1), 1);
  const Leisurely& application = loop.application;
  if (application.at_leisure == 0) {
    GTEST_SKIP() << "needs the right to SCHED_FIFO";
  }
  EXPECT_EQ(application.at_leisure, runtime::kLeisurePriority + 1);
  EXPECT_EQ(application.called_back, runtime::kBusPriority + 1);
  EXPECT_GT(application.sends, application.sends_before);
}

/// Publishes where others only compute.
class Yardstick final : public Fed {
 public:
  using Fed::Fed;
  bool publishes_in_step() const override { return true; }
};

TEST(PrioritiesTest, OfThreadsThatPublishAreAlikeWhereMessagesAreEncrypted) {
  const Fed joint_node([] {});
  const Priorities open = priorities_of(joint_node, 2, false);
  EXPECT_GT(open.control, open.bus);
  EXPECT_LT(open.leisure, open.bus);
  const Priorities secured = priorities_of(joint_node, 2, true);
  EXPECT_EQ(secured.control, open.control);
  EXPECT_EQ(secured.bus, open.bus);
  EXPECT_EQ(secured.leisure, secured.bus);
  const Yardstick yardstick([] {});
  EXPECT_EQ(priorities_of(yardstick, 2, false).control, open.control);
  EXPECT_EQ(priorities_of(yardstick, 2, true).control, open.bus);
}

}  // namespace realtime_loop_test
}  // namespace farrier::participant
