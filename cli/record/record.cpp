// farrier record: everything a robot's processes publish, into an MCAP file.

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

#include "participant/clock.hpp"
#include "participant/loop.hpp"
#include "recorder/recorder.hpp"
#include "robot/robot.hpp"
#include "recording/background_writer.hpp"
#include "cli/base/command.hpp"
#include "cli/record/guest.hpp"
#include "cli/record/topic_choice.hpp"
#include "report/figures/recording_facts.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::cli {
namespace {

using namespace std::chrono_literals;

constexpr auto kNextLook = 5ms;  // the deepest history is of 256 samples at 1 kHz

struct RecordOptions {
  std::string path;
  std::vector<std::string> topics;
  std::vector<std::string> facts;
  double duration_s = 0.0;
  bool force = false;
  GuestOptions guest;
};

struct Sum {
  std::uint64_t samples = 0, lost = 0;
};

Sum sum_of(const recorder::Recorder& recorder, const recording::BackgroundWriter& file) {
  Sum sum;
  for (const recorder::TopicProgress& topic : recorder.progress()) {
    sum.samples += topic.samples;
    sum.lost += topic.lost;
  }
  for (const std::uint64_t dropped : file.dropped()) {
    sum.samples -= dropped;
    sum.lost += dropped;
  }
  return sum;
}

std::string sum_text(const Sum& sum, const recording::BackgroundWriter& file) {
  return std::to_string(sum.samples) + " samples, " + std::to_string(sum.lost) + " lost, " +
         report::short_number(static_cast<double>(file.bytes()) / 1e6) + " MB";
}

/// Records until somebody asks it to stop, the time is over or the disk refuses. `duration_s` counts from the first
/// sample, because discovery takes a part of a second or, on a busy computer, several.
void record(bus::Bus& bus, recorder::Recorder& recorder, recording::BackgroundWriter& file, double duration_s) {
  const bool terminal = ::isatty(STDERR_FILENO) == 1;
  const SteadyTime joined = participant::steady_now();
  std::optional<SteadyTime> first_sample;
  SteadyTime next_line = joined + 1s;
  while (!participant::stop_requested() && file.failure().empty()) {
    const SteadyTime now = participant::steady_now();
    const bool over = first_sample ? std::chrono::duration<double>(now - *first_sample).count() >= duration_s
                                   : now - joined >= kFirstSampleLimit;
    if (duration_s > 0.0 && over) {
      break;
    }
    if (terminal && now >= next_line) {
      next_line = now + 1s;
      std::fprintf(stderr, "\r\033[K%s", sum_text(sum_of(recorder, file), file).c_str());
    }
    // Not at every arrival: twenty thousand of them come in a second.
    bus.wait_for_arrivals(~std::uint64_t{0}, kNextLook);
    recorder.drain([&](const recording::Sample& sample) {
      first_sample = first_sample.value_or(now);
      file.offer(sample);
    });
  }
  if (terminal) {
    std::fputs("\r\033[K", stderr);
  }
}

int run_record(const RecordOptions& o) {
  participant::install_signal_handlers();
  const auto robot = robot::load_robot(o.guest.robot_path);
  if (!robot) {
    std::fputs(config::to_string(robot.error()).c_str(), stderr);
    return kBadInput;
  }
  mcap::Text facts = report::recording_facts(robot.value());
  facts["vendor"] = o.guest.vendor;
  for (const std::string& fact : o.facts) {
    const std::size_t equals = fact.find('=');
    if (equals == std::string::npos || equals == 0) {
      return refuse("record", "--fact: '" + fact + "' is not name=value");
    }
    facts[fact.substr(0, equals)] = fact.substr(equals + 1);
  }
  if (auto free = recording::refuse_existing(o.path); !free && !o.force) {
    return refuse("record", free.error().message);
  }
  std::error_code unknown;
  if (std::filesystem::equivalent(o.path, o.guest.robot_path, unknown)) {
    return refuse("record", o.path + " is the robot file: give another file");
  }
  auto file = recording::RunFileWriter::create(o.path, facts);
  if (!file) {
    return refuse("record", file.error().message);
  }
  auto bus = join_as_guest(o.guest, bus::Role::kMonitor);
  if (!bus) {
    return fail("record", bus.error().message, bus.error().status);
  }
  auto recorder = o.topics.empty() ? recorder::Recorder::of_journals(*bus.value(), robot.value())
                                   : recorder::Recorder::create(*bus.value(), robot.value(), topics_of(o.topics));
  if (!recorder) {
    return fail("record", recorder.error().message);
  }
  recording::BackgroundWriter writer(std::move(file).value());
  const std::string part = recording::path_while_written(o.path);
  std::fprintf(stderr, "farrier record: records domain %d into %s, until its end %s; Ctrl-C ends it\n",
               o.guest.network.domain, o.path.c_str(), part.c_str());
  record(*bus.value(), recorder.value(), writer, o.duration_s);
  const auto finished = writer.finish(recorder.value().lost());
  const Sum sum = sum_of(recorder.value(), writer);
  std::printf("%s: %s\n", (finished ? o.path : part).c_str(), sum_text(sum, writer).c_str());
  if (!finished) {
    return fail("record", finished.error().message + "; what came before is readable in " + part);
  }
  if (sum.samples == 0) {
    return fail("record", "nothing came; why: farrier doctor --domain " + std::to_string(o.guest.network.domain));
  }
  return kPassed;
}

}  // namespace

std::function<int()> declare_record(CLI::App& app) {
  auto o = std::make_shared<RecordOptions>();
  app.add_option("file", o->path, "where the recording goes, such as run.mcap")->required()->type_name("<file>");
  declare_topic_choice(app, o->topics);
  app.add_option("--duration", o->duration_s, "seconds from the first sample; without it, Ctrl-C ends the recording")
      ->check(CLI::PositiveNumber)
      ->type_name("<s>");
  app.add_flag("--force", o->force, "replace the file if it is there");
  app.add_option("--fact", o->facts, "something else that the recording is to say of the run")
      ->type_name("<name>=<value>");
  declare_guest(app, o->guest);
  return [o] { return run_record(*o); };
}

}  // namespace farrier::cli
