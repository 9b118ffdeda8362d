#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "mcap/compression.hpp"
#include "mcap/reader.hpp"
#include "mcap/writer.hpp"
#include "tests/support/scratch_directory.hpp"

namespace farrier::mcap {
namespace mcap_test {

using Bytes = std::vector<std::uint8_t>;

class McapFile : public testing::Test {
 protected:
  /// 40 messages on two channels in chunks of a few, and one metadata record.
  Bytes written() {
    auto writer = Writer::create(path_, "test", "mcap_test", 256);
    EXPECT_TRUE(writer.ok());
    const std::uint16_t schema = writer.value().add_schema({.name = "wire::X", .encoding = "omgidl", .data = "module"});
    const std::uint16_t one =
        writer.value().add_channel({.schema_id = schema, .topic = "one", .message_encoding = "cdr"});
    const std::uint16_t two =
        writer.value().add_channel({.schema_id = schema, .topic = "two", .message_encoding = "cdr"});
    for (std::uint32_t i = 0; i < kMessages; ++i) {
      const Bytes data = data_of(i);
      writer.value().write(Message{.channel_id = i % 3 == 0 ? two : one,
                                   .sequence = i,
                                   .log_time_ns = 1000 + i,
                                   .publish_time_ns = 900 + i,
                                   .data = data});
    }
    writer.value().write(Metadata{"facts", {{"seed", "7"}}});
    EXPECT_TRUE(writer.value().finish().ok());
    std::ifstream in(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  /// A file that is cut short and written again waits for the disk on some file systems; a new one does not.
  void write(std::span<const std::uint8_t> bytes) const {
    std::filesystem::remove(path_);
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }

  /// Reads `bytes` as a file and checks that its messages are the first of those written; how many they were.
  std::uint32_t prefix_read(std::span<const std::uint8_t> bytes, std::string& ending) {
    write(bytes);
    auto reader = Reader::open(path_);
    if (!reader) {
      ending = reader.error().message;
      return 0;
    }
    std::uint32_t count = 0;
    for (Message message; reader.value().next(message); ++count) {
      EXPECT_EQ(message.sequence, count);
      EXPECT_EQ(Bytes(message.data.begin(), message.data.end()), data_of(count));
      EXPECT_EQ(reader.value().channels().at(message.channel_id).topic, count % 3 == 0 ? "two" : "one");
    }
    ending = reader.value().ending();
    return count;
  }

  static Bytes data_of(std::uint32_t i) { return Bytes(10 + i % 7, static_cast<std::uint8_t>(i * 31)); }

  static constexpr std::uint32_t kMessages = 40;
  const test::ScratchDirectory scratch_;
  const std::string path_ = scratch_.file("file.mcap");
};

TEST_F(McapFile, ReadsWhatWasWritten) {
  written();
  auto reader = Reader::open(path_);
  ASSERT_TRUE(reader.ok()) << reader.error().message;
  std::uint32_t count = 0;
  for (Message message; reader.value().next(message); ++count) {
    EXPECT_EQ(message.log_time_ns, 1000 + count);
    EXPECT_EQ(message.publish_time_ns, 900 + count);
  }
  EXPECT_EQ(count, kMessages);
  EXPECT_EQ(reader.value().ending(), "");
  EXPECT_GT(reader.value().chunks(), 4u);
  ASSERT_EQ(reader.value().metadata().size(), 1u);
  EXPECT_EQ(reader.value().metadata()[0].values.at("seed"), "7");
  EXPECT_EQ(reader.value().schemas().at(1).name, "wire::X");
}

// kill -9, a full disk, a pulled plug.
TEST_F(McapFile, CutOffAnywhereIsReadUpToItsLastWholeChunk) {
  const Bytes whole = written();
  std::uint32_t read_of_shorter = 0;
  for (std::size_t length = 0; length < whole.size(); ++length) {
    std::string ending;
    const std::uint32_t read = prefix_read(std::span(whole).first(length), ending);
    EXPECT_GE(read, read_of_shorter) << "a longer file has no fewer messages, at " << length;
    EXPECT_NE(ending, "") << "cut off at " << length << " of " << whole.size();
    read_of_shorter = read;
    if (HasFailure()) {
      return;
    }
  }
  EXPECT_EQ(read_of_shorter, kMessages);
}

TEST_F(McapFile, DamagedAnywhereItsMessagesAreThoseWrittenOrNone) {
  const Bytes whole = written();
  std::uint32_t unharmed = 0;
  for (std::size_t at = kMagic.size(); at < whole.size(); ++at) {
    Bytes damaged = whole;
    damaged[at] ^= 0x41;
    write(damaged);
    auto reader = Reader::open(path_);
    std::uint32_t read = 0;
    if (reader) {
      for (Message message; reader.value().next(message);) {
        ++read;
        ASSERT_EQ(Bytes(message.data.begin(), message.data.end()), data_of(message.sequence)) << "damaged at " << at;
      }
    }
    unharmed += read == kMessages ? 1 : 0;
  }
  EXPECT_GT(unharmed, 0u);  // in its indexes and its summary
}

TEST_F(McapFile, RefusesWhatIsNotMcapAndWhatIsNotThere) {
  std::ofstream(path_) << "tick,joint\n";
  const auto text = Reader::open(path_);
  ASSERT_FALSE(text.ok());
  EXPECT_NE(text.error().message.find("not an MCAP file"), std::string::npos);
  EXPECT_FALSE(Reader::open("/nowhere/run.mcap").ok());
  EXPECT_FALSE(Writer::create("/nowhere/run.mcap", "", "").ok());
}

TEST_F(McapFile, AFullDiskIsSaidAndNothingFails) {
  auto writer = Writer::create("/dev/full", "test", "mcap_test", 256);
  ASSERT_TRUE(writer.ok());
  const std::uint16_t channel = writer.value().add_channel({.topic = "one"});
  const Bytes data(100, 1);
  for (std::uint32_t i = 0; i < 100; ++i) {
    writer.value().write(Message{.channel_id = channel, .sequence = i, .data = data});
  }
  EXPECT_TRUE(writer.value().failed());
  const auto finished = writer.value().finish();
  ASSERT_FALSE(finished.ok());
  EXPECT_NE(finished.error().message.find("No space left"), std::string::npos) << finished.error().message;
}

TEST(McapCompression, RefusesFalseSizesAndOtherCompressions) {
  Compressor compressor;
  const Bytes data(1000, 3);
  const auto frame = compressor.compress(data);
  const Bytes compressed(frame.begin(), frame.end());
  ASSERT_TRUE(decompress(compressed, "zstd", data.size()).ok());
  EXPECT_FALSE(decompress(compressed, "zstd", data.size() + 1).ok());
  EXPECT_FALSE(decompress(compressed, "zstd", kLargestChunk + 1).ok());
  EXPECT_FALSE(decompress(compressed, "lz4", data.size()).ok());
  EXPECT_FALSE(decompress(compressed, "brotli", data.size()).ok());
  EXPECT_FALSE(decompress(data, "", data.size() - 1).ok());
}

// Frames of the program lz4 1.9.4, of linked blocks, and of independent ones with a checksum each.
TEST(McapCompression, ExpandsLz4) {
  std::string text;
  for (int i = 0; i < 12; ++i) {
    text += "joint " + std::to_string(i % 3) + " of the left front leg; ";
  }
  text += std::string(300, 'A');
  const Bytes block{0xf2, 0x10, 'j',  'o',  'i',  'n',  't',  ' ',  '0',  ' ', 'o',  'f',  ' ',  't',  'h',  'e',
                    ' ',  'l',  'e',  'f',  't',  ' ',  'f',  'r',  'o',  'n', 't',  ' ',  'l',  'e',  'g',  ';',
                    ' ',  0x1f, 0x00, 0x1f, '1',  0x1f, 0x00, 0x0b, 0x1f, '2', 0x1f, 0x00, 0x05, 0x0f, 0x5d, 0x00,
                    0xff, 0x05, 0x1f, 'A',  0x01, 0x00, 0xff, 0x14, 0x50, 'A', 'A',  'A',  'A',  'A'};
  const Bytes end{0x00, 0x00, 0x00, 0x00, 0x8b, 0x00, 0xe4, 0xf0};
  Bytes linked{0x04, 0x22, 0x4d, 0x18, 0x64, 0x40, 0xa7, 0x3e, 0x00, 0x00, 0x00};
  linked.insert(linked.end(), block.begin(), block.end());
  linked.insert(linked.end(), end.begin(), end.end());
  Bytes independent{0x04, 0x22, 0x4d, 0x18, 0x74, 0x40, 0xbd, 0x3e, 0x00, 0x00, 0x00};
  independent.insert(independent.end(), block.begin(), block.end());
  independent.insert(independent.end(), {0x2d, 0xdf, 0x58, 0x59});
  independent.insert(independent.end(), end.begin(), end.end());
  for (const Bytes& frame : {linked, independent}) {
    const auto expanded = decompress(frame, "lz4", text.size());
    ASSERT_TRUE(expanded.ok());
    EXPECT_EQ(std::string(expanded.value().begin(), expanded.value().end()), text);
    EXPECT_FALSE(decompress(frame, "lz4", text.size() - 1).ok());
    EXPECT_FALSE(decompress(Bytes(frame.begin(), frame.end() - 20), "lz4", text.size()).ok());
  }
}

// The check value of the polynomial's entry (Cook, "Catalogue of parametrised CRC algorithms", CRC-32/ISO-HDLC).
TEST(McapCompression, CrcIsThatOfZip) {
  const std::string check = "123456789";
  EXPECT_EQ(crc32(std::span(reinterpret_cast<const std::uint8_t*>(check.data()), check.size())), 0xcbf43926u);
}

}  // namespace mcap_test
}  // namespace farrier::mcap
