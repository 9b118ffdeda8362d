// farrier info: the content of a recording, its run, and its losses.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>

#include "participant/loop.hpp"
#include "recording/recording_file.hpp"
#include "cli/base/command.hpp"
#include "cli/base/long_work.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::cli {
namespace {

using nlohmann::json;

struct InfoOptions {
  std::string path;
  bool json = false;
};

/// Summary of one topic.
struct TopicSum {
  std::uint64_t samples = 0;
  std::uint64_t first_ns = 0, last_ns = 0;  // elapsed

  double seconds() const noexcept { return static_cast<double>(last_ns - first_ns) * 1e-9; }
  double rate_hz() const noexcept {
    return samples > 1 && last_ns > first_ns ? static_cast<double>(samples - 1) / seconds() : 0.0;
  }
};

struct Contents {
  std::array<TopicSum, bus::kTopicCount> topics;
  TopicSum all;
  mcap::Text facts, lost;  // lost: empty without its record, which is written last
  std::string ending;
  std::string nothing;  // of Farrier is in the file, and what is; empty: something is
  std::uint64_t damaged = 0;
  std::map<std::string, recording::ForeignTopic> foreign;
  recording::Timeline timeline;
};

Contents read_all(recording::RunFileReader& file) {
  Contents contents;
  recording::Sample sample;
  while (file.next(sample)) {
    for (TopicSum* sum : {&contents.topics[static_cast<std::size_t>(sample.topic)], &contents.all}) {
      sum->first_ns = sum->samples == 0 ? sample.elapsed_ns : std::min(sum->first_ns, sample.elapsed_ns);
      sum->last_ns = std::max(sum->last_ns, sample.elapsed_ns);
      ++sum->samples;
    }
  }
  contents.facts = file.metadata(recording::kRunFacts);
  contents.lost = file.metadata(recording::kLosses);
  contents.ending = file.ending();
  contents.nothing = file.nothing_of_farrier();
  contents.damaged = file.damaged_samples();
  contents.foreign = file.foreign();
  contents.timeline = file.timeline();
  return contents;
}

std::string lost_text(const Contents& contents, const char* topic) {
  const auto found = contents.lost.find(topic);
  return found == contents.lost.end() ? "?" : found->second;
}

void print_text(const Contents& contents) {
  for (const auto& [name, value] : contents.facts) {
    if (value.find('\n') == std::string::npos) {
      std::printf("%-20s %s\n", name.c_str(), value.c_str());
    }
  }
  std::printf("%-20s %s\n\n", "duration_s", report::short_number(contents.all.seconds()).c_str());
  std::printf("%-24s %10s %10s %10s\n", "topic", "samples", "Hz", "lost");
  for (const bus::TopicSpec& topic : bus::topics()) {
    const TopicSum& sum = contents.topics[static_cast<std::size_t>(topic.id)];
    std::printf("%-24s %10llu %10s %10s\n", topic.name, static_cast<unsigned long long>(sum.samples),
                report::short_number(sum.rate_hz()).c_str(), lost_text(contents, topic.name).c_str());
  }
  if (!contents.foreign.empty()) {
    std::vector<std::vector<std::string>> rows{{"topic of another program", "messages", "type", "encoding"}};
    for (const auto& [name, topic] : contents.foreign) {
      rows.push_back({name, std::to_string(topic.messages), topic.type, topic.encoding});
    }
    std::printf("\n%s", report::aligned(rows).c_str());
  }
}

json foreign_json(const Contents& contents) {
  json all = json::object();
  for (const auto& [name, topic] : contents.foreign) {
    all[name] = {{"messages", topic.messages}, {"type", topic.type}, {"encoding", topic.encoding}};
  }
  return all;
}

json steps_json(const Contents& contents) {
  json all = json::array();
  for (const recording::ClockStep& step : contents.timeline.steps()) {
    all.push_back({{"at_s", static_cast<double>(step.at_ns) * 1e-9}, {"by_s", step.by_s()}});
  }
  return all;
}

void print_json(const Contents& contents) {
  json topics = json::object();
  for (const bus::TopicSpec& topic : bus::topics()) {
    const TopicSum& sum = contents.topics[static_cast<std::size_t>(topic.id)];
    json one = {{"samples", sum.samples}, {"duration_s", sum.seconds()}, {"rate_hz", sum.rate_hz()}};
    if (const auto lost = contents.lost.find(topic.name); lost != contents.lost.end()) {
      one["lost"] = std::strtoull(lost->second.c_str(), nullptr, 10);
    }
    topics[topic.name] = std::move(one);
  }
  const json all = {{"run", contents.facts},
                    {"duration_s", contents.all.seconds()},
                    {"samples", contents.all.samples},
                    {"topics", std::move(topics)},
                    {"foreign", foreign_json(contents)},
                    {"damaged_samples", contents.damaged},
                    {"clock_steps", steps_json(contents)},
                    {"whole", contents.ending.empty()},
                    {"ending", contents.ending}};
  std::printf("%s\n", all.dump(2, ' ', false, json::error_handler_t::replace).c_str());
}

int run_info_command(const InfoOptions& o) {
  auto file = recording::RunFileReader::open(o.path);
  if (!file) {
    return refuse("info", file.error().message);
  }
  file.value().ask(long_work("info"));
  const Contents contents = read_all(file.value());
  if (participant::stop_requested()) {
    return participant::stop_status();
  }
  if (!contents.nothing.empty()) {
    return refuse("info", contents.nothing);
  }
  o.json ? print_json(contents) : print_text(contents);
  std::fflush(stdout);  // remarks come behind it
  for (const std::string& step : recording::step_texts(contents.timeline)) {
    std::fprintf(stderr, "farrier info: %s: %s; durations leave the step out\n", o.path.c_str(), step.c_str());
  }
  if (!contents.ending.empty()) {
    return fail("info", o.path + ": " + contents.ending + "; what is above is the rest");
  }
  return kPassed;
}

}  // namespace

std::function<int()> declare_info(CLI::App& app) {
  auto o = std::make_shared<InfoOptions>();
  app.add_option("file", o->path, "recording, as farrier record makes it")->required()->type_name("<file>");
  app.add_flag("--json", o->json, "as JSON, with the robot's configuration");
  return [o] { return run_info_command(*o); };
}

}  // namespace farrier::cli
