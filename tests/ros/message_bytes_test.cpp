// Another serializer of ROS 2, @foxglove/rosmsg2-serialization, writes the bytes of each message that ours writes, and
// ours reads what it writes.

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "ros_messages/cdr.hpp"
#include "ros_messages/type_description.hpp"
#include "tests/support/scratch_directory.hpp"
#include "tools/tool_process/tool_process.hpp"

namespace farrier::test {
namespace message_bytes_test {

using nlohmann::json;
using namespace ros_messages;

constexpr int kEach = 20;

std::string hex_of(const std::vector<std::uint8_t>& bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) {
    constexpr const char* kDigits = "0123456789abcdef";
    text += {kDigits[byte / 16], kDigits[byte % 16]};
  }
  return text;
}

std::vector<std::uint8_t> bytes_of(const std::string& hex) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t at = 0; at + 1 < hex.size(); at += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(hex.substr(at, 2), nullptr, 16)));
  }
  return bytes;
}

/// Visitor that fills fields with random values.
struct RandomFields {
  std::mt19937_64& random;

  template <class T>
  void operator()(const char* /*name*/, T& field) {
    fill(field);
  }
  int up_to(int most) { return std::uniform_int_distribution(0, most)(random); }
  template <class T>
  void fill(T& field) {
    if constexpr (Message<T>) {
      T::visit(field, *this);
    } else if constexpr (kIsString<T>) {
      field.assign(static_cast<std::size_t>(up_to(9)), static_cast<char>('a' + up_to(25)));
    } else if constexpr (kIsSequence<T>) {
      field.resize(static_cast<std::size_t>(up_to(3)));
      for (auto&& element : field) {
        fill(element);
      }
    } else if constexpr (kArraySize<T> != 0) {
      for (auto& element : field) {
        fill(element);
      }
    } else if constexpr (std::is_same_v<T, double>) {
      field = std::uniform_real_distribution(-1e6, 1e6)(random);
    } else if constexpr (std::is_same_v<T, bool>) {
      field = up_to(1) == 1;
    } else if constexpr (std::is_same_v<T, std::byte>) {
      field = static_cast<std::byte>(up_to(127));
    } else {
      field = static_cast<T>(random());
    }
  }
};

template <class... Messages>
struct Every {
  /// Random messages of each type as {type, definition, hex: [...]}.
  static json random_messages() {
    json all = json::array();
    std::mt19937_64 random(11);
    (all.push_back(random_ones<Messages>(random)), ...);
    return all;
  }
  /// Bytes, with "" for those that ours cannot read, that ours makes of what it reads of `hex` of a type.
  static std::string read_and_written(const std::string& type, const std::string& hex) {
    std::string again;
    ((type == Messages::kRosName ? void(again = again_of<Messages>(hex)) : void()), ...);
    return again;
  }
  static constexpr std::size_t kCount = sizeof...(Messages);

 private:
  template <class M>
  static json random_ones(std::mt19937_64& random) {
    json hex = json::array();
    for (int i = 0; i < kEach; ++i) {
      M message;
      M::visit(message, RandomFields{random});
      std::vector<std::uint8_t> bytes;
      to_cdr(message, bytes);
      hex.push_back(hex_of(bytes));
    }
    return {{"type", M::kRosName}, {"definition", message_text(describe<M>())}, {"hex", hex}};
  }
  template <class M>
  static std::string again_of(const std::string& hex) {
    const auto message = from_cdr<M>(bytes_of(hex));
    std::vector<std::uint8_t> bytes;
    if (message) {
      to_cdr(*message, bytes);
    }
    return hex_of(bytes);
  }
};
using All = AllMessages<Every>;

TEST(MessageBytes, AreThoseThatNpmsSerializerOfRos2WritesAndReads) {
  const ScratchDirectory scratch;
  const json ours = All::random_messages();
  ASSERT_EQ(ours.size(), All::kCount);
  std::ofstream(scratch.file("ours.json")) << ours;
  const auto ran = run_tool({"node", "nodejs"}, {"message_bytes.mjs", scratch.file("ours.json")}, FARRIER_ROS_NPM,
                            scratch.file("theirs.json"));
  ASSERT_TRUE(ran.ok()) << ran.error().message;
  const json theirs = json::parse(std::ifstream(scratch.file("theirs.json")));
  ASSERT_EQ(theirs.size(), ours.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const std::string type = ours[i].at("type");
    EXPECT_EQ(theirs[i].at("again"), ours[i].at("hex")) << type << ": read by theirs and written again";
    ASSERT_EQ(theirs[i].at("own").size(), kEach) << type;
    for (const json& hex : theirs[i].at("own")) {
      EXPECT_EQ(All::read_and_written(type, hex), hex) << type << ": written by theirs";
    }
  }
}

}  // namespace message_bytes_test
}  // namespace farrier::test
