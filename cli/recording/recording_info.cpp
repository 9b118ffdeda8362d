// farrier info: the content of a recording, its run, and its losses.

#include <CLI/CLI.hpp>
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

struct InfoOptions {
  std::string path;
  bool json = false;
};

/// Summary of one topic.
struct TopicSum {
  std::uint64_t samples = 0;
  std::uint64_t first_ns = 0, last_ns = 0;  // logged

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
};

Contents read_all(recording::RunFileReader& file) {
  Contents contents;
  recording::Sample sample;
  while (file.next(sample)) {
    for (TopicSum* sum : {&contents.topics[static_cast<std::size_t>(sample.topic)], &contents.all}) {
      sum->first_ns = sum->samples == 0 ? sample.log_time_ns : std::min(sum->first_ns, sample.log_time_ns);
      sum->last_ns = std::max(sum->last_ns, sample.log_time_ns);
      ++sum->samples;
    }
  }
  contents.facts = file.metadata(recording::kRunFacts);
  contents.lost = file.metadata(recording::kLosses);
  contents.ending = file.ending();
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
}

void print_json(const Contents& contents) {
  nlohmann::json topics = nlohmann::json::object();
  for (const bus::TopicSpec& topic : bus::topics()) {
    const TopicSum& sum = contents.topics[static_cast<std::size_t>(topic.id)];
    nlohmann::json one = {{"samples", sum.samples}, {"duration_s", sum.seconds()}, {"rate_hz", sum.rate_hz()}};
    if (const auto lost = contents.lost.find(topic.name); lost != contents.lost.end()) {
      one["lost"] = std::strtoull(lost->second.c_str(), nullptr, 10);
    }
    topics[topic.name] = std::move(one);
  }
  const nlohmann::json all = {{"run", contents.facts},
                              {"duration_s", contents.all.seconds()},
                              {"samples", contents.all.samples},
                              {"topics", std::move(topics)},
                              {"whole", contents.ending.empty()},
                              {"ending", contents.ending}};
  std::printf("%s\n", all.dump(2).c_str());
}

int run_info_command(const InfoOptions& o) {
  auto file = recording::RunFileReader::open(o.path);
  if (!file) {
    std::fprintf(stderr, "farrier info: %s\n", file.error().message.c_str());
    return kBadInput;
  }
  file.value().ask(long_work("info"));
  const Contents contents = read_all(file.value());
  if (participant::stop_requested()) {
    return participant::stop_status();
  }
  o.json ? print_json(contents) : print_text(contents);
  if (!contents.ending.empty()) {
    std::fprintf(stderr, "farrier info: %s: %s; what is above is what came before\n", o.path.c_str(),
                 contents.ending.c_str());
    return kFailed;
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
