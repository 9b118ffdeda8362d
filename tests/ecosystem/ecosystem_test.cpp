// What others read of a recording: npm's readers of MCAP, IDL and CDR see every sample of every topic as we do.

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "run_file/run_file.hpp"
#include "signals/cdr.hpp"
#include "tests/contract/random_signal.hpp"
#include "tests/support/scratch_directory.hpp"

namespace farrier::test {
namespace {

using nlohmann::json;

struct TopicSum {
  int samples = 0;
  double sum = 0.0;
};

double sum_of(double field) { return field; }
template <class Integer>
  requires std::is_integral_v<Integer>
double sum_of(Integer field) {
  return static_cast<double>(field);
}
template <std::size_t kCount>
double sum_of(const std::array<char, kCount>& text) {  // up to 255 each
  double sum = 0.0;
  for (const char letter : text) {
    sum += static_cast<unsigned char>(letter);
  }
  return sum;
}
template <class T, std::size_t kCount>
double sum_of(const std::array<T, kCount>& fields) {
  double sum = 0.0;
  for (const T& field : fields) {
    sum += sum_of(field);
  }
  return sum;
}

/// Twenty random samples of every topic; what they sum up to.
std::map<std::string, TopicSum> write_recording(const std::string& path) {
  std::map<std::string, TopicSum> sums;
  auto file = run_file::RunFileWriter::create(path, {{"robot", "hyq"}});
  EXPECT_TRUE(file.ok());
  std::mt19937_64 random(5);
  std::vector<std::uint8_t> cdr;
  std::uint64_t time_ns = 0;
  const auto write = [&]<class Signal>(const Signal&) {
    TopicSum& topic = sums[bus::spec(bus::TopicOf<Signal>::id).name];
    for (int i = 0; i < 20; ++i) {
      const auto signal = contract::random_signal<Signal>(random);
      signals::to_cdr(signal, cdr);
      file.value().write({.topic = bus::TopicOf<Signal>::id, .log_time_ns = ++time_ns, .cdr = cdr});
      double sum = 0.0;
      signals::visit_fields(signal, [&](const char*, const auto& field) { sum += sum_of(field); });
      topic.sum += sum;
      ++topic.samples;
    }
  };
#define FARRIER_WRITE(Signal, file) write(signals::Signal{});
  FARRIER_SIGNALS(FARRIER_WRITE)
#undef FARRIER_WRITE
  EXPECT_TRUE(file.value().finish({}).ok());
  return sums;
}

/// What the command prints; fails the test unless it ends with 0.
std::string output_of(const std::string& command) {
  std::FILE* const pipe = ::popen((command + " 2>&1").c_str(), "r");
  std::string output;
  std::array<char, 4096> bytes;
  for (std::size_t count; (count = std::fread(bytes.data(), 1, bytes.size(), pipe)) > 0;) {
    output.append(bytes.data(), count);
  }
  EXPECT_EQ(::pclose(pipe), 0) << command << "\n" << output;
  return output;
}

TEST(Ecosystem, NpmsReadersSeeEverySampleOfEveryTopicAsWeDo) {
  const ScratchDirectory scratch;
  const std::string path = scratch.file("run.mcap");
  const auto sums = write_recording(path);
  const std::string output = output_of("cd '" FARRIER_ECOSYSTEM "' && node decode_recording.mjs '" + path + "'");
  ASSERT_FALSE(HasFailure());
  const json read = json::parse(output);
  ASSERT_EQ(sums.size(), bus::kTopicCount);
  for (const auto& [topic, ours] : sums) {
    ASSERT_TRUE(read.at("topics").contains(topic)) << topic;
    const json& theirs = read.at("topics").at(topic);
    EXPECT_EQ(theirs.at("samples"), ours.samples) << topic;
    EXPECT_NEAR(theirs.at("sum").get<double>(), ours.sum, 1e-9 * std::abs(ours.sum)) << topic;
  }
  EXPECT_EQ(read.at("statistics"), 20 * static_cast<int>(bus::kTopicCount));
  EXPECT_EQ(read.at("metadata").at(run_file::kRunFacts).at("robot"), "hyq");
  EXPECT_EQ(read.at("metadata").at(run_file::kLosses).at("joint/sensors"), "0");
}

}  // namespace
}  // namespace farrier::test
