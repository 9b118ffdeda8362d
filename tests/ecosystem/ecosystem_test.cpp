// Other software reads recordings: npm's readers of MCAP, IDL and CDR see every sample of every topic as we do.

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/support/random_recording.hpp"
#include "tests/support/scratch_directory.hpp"
#include "tools/tool_process/tool_process.hpp"

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
double sum_of(Integer field) { return static_cast<double>(field); }
template <class Enum>
requires std::is_enum_v<Enum>
double sum_of(Enum field) { return static_cast<double>(field); }
template <std::size_t kCount>
double sum_of(const std::array<char, kCount>& text) {  // up to 255 each
  double sum = 0.0;
  for (const char letter : text) {
    sum += static_cast<unsigned char>(letter);
  }
  return sum;
}
template <class List>
requires requires(const List& fields) { fields.begin(); }
double sum_of(const List& fields) {
  double sum = 0.0;
  for (const auto& field : fields) {
    sum += sum_of(field);
  }
  return sum;
}

/// Twenty random samples of every topic; what they sum up to.
std::map<std::string, TopicSum> write_recording(const std::string& path) {
  std::map<std::string, TopicSum> sums;
  write_random_recording(path, {{"robot", "hyq"}}, {}, 20, [&]<class Signal>(const Signal& signal) {
    TopicSum& topic = sums[bus::spec(bus::TopicOf<Signal>::id).name];
    double sum = 0.0;
    signals::visit_fields(signal, [&](const char*, const auto& field) { sum += sum_of(field); });
    topic.sum += sum;
    ++topic.samples;
  });
  return sums;
}

TEST(Ecosystem, NpmsReadersSeeEverySampleOfEveryTopicAsWeDo) {
  const ScratchDirectory scratch;
  const std::string path = scratch.file("run.mcap");
  const auto sums = write_recording(path);
  const auto ran =
      run_tool({"node", "nodejs"}, {"decode_recording.mjs", path}, FARRIER_ECOSYSTEM, scratch.file("read.json"));
  ASSERT_TRUE(ran.ok()) << ran.error().message;
  const json read = json::parse(std::ifstream(scratch.file("read.json")));
  ASSERT_EQ(sums.size(), bus::kTopicCount);
  for (const auto& [topic, ours] : sums) {
    ASSERT_TRUE(read.at("topics").contains(topic)) << topic;
    const json& theirs = read.at("topics").at(topic);
    EXPECT_EQ(theirs.at("samples"), ours.samples) << topic;
    EXPECT_NEAR(theirs.at("sum").get<double>(), ours.sum, 1e-9 * std::abs(ours.sum)) << topic;
  }
  EXPECT_EQ(read.at("statistics"), 20 * static_cast<int>(bus::kTopicCount));
  EXPECT_EQ(read.at("metadata").at(recording::kRunFacts).at("robot"), "hyq");
  EXPECT_EQ(read.at("metadata").at(recording::kLosses).at("joint/sensors"), "0");
}

}  // namespace
}  // namespace farrier::test
