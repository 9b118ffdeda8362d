#include "cli/processes/run_limits.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "bus/settings/user_settings.hpp"
#include "cli/processes/process_stat.hpp"
#include "cli/processes/run_children.hpp"

namespace farrier::cli {
namespace {

using namespace std::chrono_literals;

constexpr auto kLook = 100ms;
/// A longer time between two looks is one in which this process was stopped or had no processor.
constexpr auto kLongestStep = 1s;

bool debugger_holds(const std::vector<ChildProcess>& children) {
  return is_traced(::getpid()) ||
         std::ranges::any_of(children, [](const ChildProcess& child) { return is_traced(child.pid()); });
}

std::string seconds(double time_s) {
  char text[32];
  std::snprintf(text, sizeof text, "%g s", time_s);
  return text;
}

std::string named(const ChildProcess& child) { return child.name() + " (pid " + std::to_string(child.pid()) + ")"; }

std::string stopped(const ChildProcess& child) { return "\n  " + named(child) + " is stopped"; }

}  // namespace

void WaitLimit::begin(SteadyTime now) noexcept {
  waited_ = Nanoseconds::zero();
  looked_ = now;
}

bool WaitLimit::reached(SteadyTime now, const std::function<bool()>& held) {
  if (limit_ == Nanoseconds::zero() || now - looked_ < kLook) {
    return false;
  }
  waited_ += std::min<Nanoseconds>(now - looked_, kLongestStep);
  looked_ = now;
  if (held()) {
    waited_ = Nanoseconds::zero();
  }
  return waited_ >= limit_;
}

RunLimits::RunLimits(const DdsRun& run, const participant::ProcessOptions& common,
                     const std::vector<run::Member>& members)
    : run_(run), common_(common), members_(members), start_(run.start_limit_s), tick_(run.stall_limit_s) {
  start_.begin(std::chrono::steady_clock::now());
}

Result<Done> RunLimits::check(const participant::Participant& launcher, const run::RunListener& listener,
                              const run::RunMonitor& monitor, const std::vector<ChildProcess>& children) {
  const SteadyTime now = std::chrono::steady_clock::now();
  const auto held = [&] { return debugger_holds(children); };
  if (!launcher.has_started()) {
    return start_.reached(now, held) ? Result<Done>(Error{start_lacks(launcher, children)}) : Done{};
  }
  if (listener.tick() != last_) {
    last_ = listener.tick();
    tick_.begin(now);
  }
  if (common_.clock == bus::ClockKind::kLockstep && tick_.reached(now, held)) {
    return Error{tick_lacks(listener, monitor, children)};
  }
  return Done{};
}

std::string RunLimits::start_lacks(const participant::Participant& launcher,
                                   const std::vector<ChildProcess>& children) const {
  std::string missing;  // a line each
  std::string deaf;
  bool runs_unheard = false;
  for (const run::Member& member : members_) {
    const signals::SystemHello& hello = launcher.hellos()[member.number];
    const auto child = std::ranges::find(children, member.name, &ChildProcess::name);
    if (child != children.end() && child->stopped()) {
      missing += stopped(*child);
    } else if (child != children.end() && hello.session == 0) {
      const std::string said = child->last_line();
      missing += "\n  " + named(*child) + " runs and is not heard; its log " + child->log_path() +
                 (said.empty() ? " is empty" : " ends with: " + said);
      runs_unheard = true;
    } else if (hello.routes_heard < hello.routes_expected) {
      deaf += "\n  " + member.name + " hears " + std::to_string(hello.routes_heard) + " of " +
              std::to_string(hello.routes_expected) + " routes";
    }
  }
  std::string text = "the start is not complete after " + seconds(run_.start_limit_s) + " (--start-limit)";
  text += missing.empty() ? "; not every sample arrives:" + deaf : "; missing:" + missing;
  if (runs_unheard || missing.empty()) {
    text += "\nDDS domain " + std::to_string(common_.network.domain) + " or the network of address " +
            common_.network.address + " may not carry samples: farrier doctor --domain " +
            std::to_string(common_.network.domain) + " --address " + common_.network.address + " looks for the cause";
  }
  if (const std::string settings = bus::lines_of_user_settings(common_.network, "  "); !settings.empty()) {
    text += "\nDDS settings of the environment may be the cause; start the run without those that are honoured:\n" +
            settings.substr(0, settings.size() - 1);
  }
  return text + "\n--start-limit 0 lets a start wait for ever";
}

std::string RunLimits::tick_lacks(const run::RunListener& listener, const run::RunMonitor& monitor,
                                  const std::vector<ChildProcess>& children) const {
  const bool ran_to_its_end = run_.common.ticks > 0 && listener.tick() >= run_.common.ticks;
  const bool had_time_to_say = std::chrono::duration<double>(run_.stall_limit_s) >= kSilenceWorthSaying;
  std::string suspects;  // a line each
  std::string waits;
  for (const ChildProcess& child : children) {
    if (child.stopped()) {
      suspects += stopped(child);
    } else if (const std::string said = child.last_words(kSilenceWorthSaying); !said.empty()) {
      waits += "\n  " + (said.starts_with(child.name() + ":") ? said : child.name() + ": " + said);
    } else if (had_time_to_say && !ran_to_its_end) {  // one that waits says so every 2 s
      suspects += "\n  " + named(child) + " runs and does not say what it waits for";
    }
  }
  if (ran_to_its_end) {
    for (const run::Member& member : members_) {
      waits += monitor.healths()[member.number].final_report != 0 ? "" : "\n  no final report of " + member.name;
    }
  } else {
    waits += "\n  " + members_.back().name + ": waiting for " + listener.waits_for();
  }
  return "no tick has begun for " + seconds(run_.stall_limit_s) + " (--stall-limit); the run stands at tick " +
         std::to_string(listener.tick()) + ":" + suspects + waits + "\nlogs: " + run_.log_directory +
         "; --stall-limit 0 lets a run wait for ever";
}

}  // namespace farrier::cli
