// Foxglove's protocol and its queues: texts of viewers, and viewers that do not read.

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "tools/foxglove/foxglove_server.hpp"
#include "tools/foxglove/viewer.hpp"

namespace farrier::foxglove {
namespace viewers_test {

using namespace std::chrono_literals;

const std::vector<ros_view::Topic> kTopics = {
    {.name = "/a", .type = "std_msgs/msg/String", .type_hash = "", .definition = "string data\n"},
    {.name = "/b",
     .type = "std_msgs/msg/String",
     .type_hash = "",
     .definition = "string data\n",
     .kept = true,
     .depth = 2}};

std::shared_ptr<const SharedMessage> message_of(std::size_t topic, std::size_t size) {
  return std::make_shared<SharedMessage>(SharedMessage{topic, 7, std::vector<std::uint8_t>(size, 1)});
}

TEST(Protocol, FindsASubprotocolInAList) {
  EXPECT_TRUE(offers_subprotocol("foxglove.sdk.v1"));
  EXPECT_TRUE(offers_subprotocol("chat ,\tfoxglove.websocket.v1"));
  for (const char* none : {"", ",", "foxglove.sdk.v2", "xfoxglove.sdk.v1", "foxglove.sdk.v1x", " , ,"}) {
    EXPECT_FALSE(offers_subprotocol(none)) << none;
  }
}

TEST(Protocol, AMessageHasSubscriptionAndTimeBeforeItsBytes) {
  std::vector<std::uint8_t> bytes;
  append_message(bytes, 0x04030201, 0x0807060504030201, std::vector<std::uint8_t>{9});
  EXPECT_EQ(bytes, (std::vector<std::uint8_t>{1, 1, 2, 3, 4, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
}

TEST(Subscriptions, BeginAndEndByTheViewersNumbers) {
  Subscriptions subscriptions(2);
  const auto begun = subscriptions.take(R"({"op":"subscribe","subscriptions":[{"id":9,"channelId":1}]})");
  EXPECT_EQ(begun.begun, std::vector<std::size_t>{1});
  EXPECT_TRUE(begun.problems.empty());
  EXPECT_EQ(subscriptions.id(1), 9u);
  EXPECT_EQ(subscriptions.id(0), std::nullopt);
  EXPECT_TRUE(subscriptions.take(R"({"op":"unsubscribe","subscriptionIds":[9]})").problems.empty());
  EXPECT_EQ(subscriptions.id(1), std::nullopt);
}

TEST(Viewer, LosesItsOldestMessagesAndIsToldOnceItReadsAgain) {
  Viewer viewer(2);
  ASSERT_TRUE(viewer.take(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":0}]})", true));
  constexpr std::size_t kSize = 1u << 20;
  for (int i = 0; i < 6; ++i) {
    viewer.offer(message_of(0, kSize));
    viewer.offer(message_of(1, kSize));  // not subscribed to
  }
  EXPECT_EQ(viewer.dropped(), 2u);
  int messages = 0;
  std::string told;
  while (viewer.has_waiting()) {
    std::vector<std::uint8_t> bytes;
    const bool text = viewer.pop(bytes);
    messages += text ? 0 : 1;
    told = text ? std::string(bytes.begin(), bytes.end()) : told;
  }
  EXPECT_EQ(messages, 4);
  EXPECT_NE(told.find("2 messages were dropped"), std::string::npos) << told;
}

TEST(Viewer, IsHopelessIfItAsksAndNeverReads) {
  Viewer viewer(1);
  for (int i = 0; i < 200'000 && !viewer.is_hopeless(); ++i) {
    ASSERT_TRUE(viewer.take("{}", true));
  }
  EXPECT_TRUE(viewer.is_hopeless());
}

TEST(Viewer, RefusesATextThatIsTooLongInParts) {
  Viewer viewer(1);
  const std::string part(Viewer::kLargestText / 2, ' ');
  EXPECT_TRUE(viewer.take(part, false));
  EXPECT_TRUE(viewer.take(part, false));
  EXPECT_FALSE(viewer.take(" ", false));
}

/// A viewer that subscribes to the first topic and reads nothing more.
class SilentViewer {
 public:
  explicit SilentViewer(int port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    write(
        "GET / HTTP/1.1\r\nHost: x\r\nConnection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Protocol: foxglove.sdk.v1\r\n\r\n");
    char bytes[4096];
    EXPECT_GT(::read(socket_, bytes, sizeof bytes), 0);
    // A text frame of the client, masked by zeros.
    const std::string text = R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":0}]})";
    write(std::string("\x81") + static_cast<char>(0x80 + text.size()) + std::string(4, '\0') + text);
  }
  ~SilentViewer() { ::close(socket_); }
  SilentViewer(const SilentViewer&) = delete;
  SilentViewer& operator=(const SilentViewer&) = delete;

 private:
  void write(const std::string& bytes) const {
    EXPECT_EQ(::write(socket_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  int socket_;
};

TEST(FoxgloveServer, AViewerThatDoesNotReadLosesMessagesAndDelaysNobody) {
  auto server = FoxgloveServer::create({.ip = "127.0.0.1", .port = 0}, "test", kTopics);
  ASSERT_TRUE(server.ok()) << server.error().message;
  const SilentViewer silent(server.value()->port());
  const std::vector<std::uint8_t> message(100'000, 1);
  auto slowest = 0ns;
  for (int i = 0; i < 2000 && server.value()->counts().dropped == 0; ++i) {
    const auto before = std::chrono::steady_clock::now();
    server.value()->send(0, 1, message);
    slowest = std::max<std::chrono::nanoseconds>(slowest, std::chrono::steady_clock::now() - before);
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_GT(server.value()->counts().dropped, 0u);
  EXPECT_LT(slowest, 200ms) << "of a call, on a busy machine too";
}

TEST(FoxgloveServer, RefusesAPortThatIsTaken) {
  const auto first = FoxgloveServer::create({.ip = "127.0.0.1", .port = 0}, "test", kTopics);
  ASSERT_TRUE(first.ok());
  const auto port = static_cast<std::uint16_t>(first.value()->port());
  const auto second = FoxgloveServer::create({.ip = "127.0.0.1", .port = port}, "test", kTopics);
  ASSERT_FALSE(second.ok());
  EXPECT_NE(second.error().message.find("Address already in use"), std::string::npos) << second.error().message;
}

}  // namespace viewers_test
}  // namespace farrier::foxglove
