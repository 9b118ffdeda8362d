// Samples packed into a journal and unpacked again.

#include "signals/journal.hpp"

#include <gtest/gtest.h>

#include "tests/contract/random_signal.hpp"

namespace farrier::signals {
namespace journal_test {

TEST(Journal, GivesBackEverySampleWithItsAge) {
  std::mt19937_64 random(1);
  std::vector<JointMeasurement> written;
  SystemJournal journal;
  while (has_room<JointMeasurement>(journal)) {
    written.push_back(contract::random_signal<JointMeasurement>(random));
    append(journal, written.back(), static_cast<std::uint32_t>(written.size()));
  }
  journal.closed_after_ns = 1000;
  EXPECT_GT(written.size(), 300u) << "more than twenty-five ticks of twelve joints";
  std::size_t read = 0;
  EXPECT_TRUE(visit_journal<JointMeasurement>(
      journal, [&](const JointMeasurement& signal, std::span<const std::uint8_t> cdr, std::uint32_t age_ns) {
        ASSERT_LT(read, written.size());
        std::vector<std::uint8_t> expected;
        to_cdr(written[read], expected);
        EXPECT_TRUE(std::ranges::equal(cdr, expected)) << read;
        EXPECT_EQ(contract::bytes_of(signal), contract::bytes_of(written[read])) << read;
        EXPECT_EQ(age_ns, 1000 - (read + 1));
        ++read;
      }));
  EXPECT_EQ(read, written.size());
}

TEST(Journal, LeavesNothingOfAnEarlierOneBetweenTheNumbers) {
  SystemJournal journal;
  journal.bytes.resize(journal.bytes.capacity());
  std::ranges::fill(journal.bytes, std::uint8_t{0xff});
  clear(journal);
  append(journal, JointSensors{.joint = 3, .tick = 7}, 0);
  std::vector<std::uint8_t> expected;
  to_cdr(JointSensors{.joint = 3, .tick = 7}, expected);
  visit_journal<JointSensors>(journal, [&](const JointSensors&, std::span<const std::uint8_t> cdr, std::uint32_t) {
    EXPECT_TRUE(std::ranges::equal(cdr, expected));
  });
}

TEST(Journal, RefusesWhatIsNoJournalOfItsTopic) {
  const auto nothing = [](const auto&, auto, std::uint32_t) { ADD_FAILURE() << "took a sample that is none"; };
  SystemJournal journal;
  journal.samples = 1;
  EXPECT_FALSE(visit_journal<JointSensors>(journal, nothing)) << "fewer bytes than the sample has";
  journal.bytes.resize(journal_entry_size<JointSensors>());
  EXPECT_FALSE(visit_journal<JointSensors>(journal, nothing)) << "bytes without CDR's head";
  journal.samples = 0xffff;
  EXPECT_FALSE(visit_journal<JointSensors>(journal, nothing)) << "more than there are bytes for";
}

TEST(Journal, KnowsTheTopicOfAStream) {
  EXPECT_EQ(topic_of_stream(stream_of(0, 3)), 3);
  EXPECT_EQ(topic_of_stream(stream_of(17, 14)), 14);
  EXPECT_NE(stream_of(1, 0), stream_of(0, 1));
}

}  // namespace journal_test
}  // namespace farrier::signals
