// The relay of bad cables does what it is told, by seed.

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "tests/support/frame_relay.hpp"
#include "tests/support/needs_network_namespaces.hpp"

namespace farrier::test {
namespace frame_relay_test {

using namespace std::chrono_literals;

constexpr int kDatagrams = 2000;
constexpr std::uint16_t kPort = 7400;

/// A socket on the host that was bound there.
Descriptor socket_on(const NetworkNamespaces& network, const std::string& host, const sockaddr_in& address) {
  const NetworkNamespaces::Visit visit(network, host);
  Descriptor opened(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  const int takes_all = 4 << 20;
  ::setsockopt(opened.number(), SOL_SOCKET, SO_RCVBUFFORCE, &takes_all, sizeof takes_all);
  const timeval patience{0, 200'000};
  ::setsockopt(opened.number(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  EXPECT_EQ(::bind(opened.number(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  return opened;
}

sockaddr_in address_of(const char* text) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(kPort);
  ::inet_pton(AF_INET, text, &address.sin_addr);
  return address;
}

/// Numbers of those of kDatagrams that come from one host to the other, in their order.
std::vector<int> received_over(const Impairment& impairment) {
  NetworkNamespaces network({{"one", "eth0", "10.77.0.1"}, {"two", "eth0", "10.77.0.2"}});
  const Descriptor from = socket_on(network, "one", address_of("10.77.0.1"));
  const Descriptor to = socket_on(network, "two", address_of("10.77.0.2"));
  const sockaddr_in target = address_of("10.77.0.2");
  const auto send = [&](int number) {
    ::sendto(from.number(), &number, sizeof number, 0, reinterpret_cast<const sockaddr*>(&target), sizeof target);
  };
  const auto receive = [&](int& number) { return ::recv(to.number(), &number, sizeof number, 0) == sizeof number; };

  // Datagrams that wait for a neighbour's address may be overtaken within the kernel; so it is asked for before.
  int number = -1;
  send(number);
  EXPECT_TRUE(receive(number)) << "the bridge carries nothing";

  const FrameRelay relay(network, "one", impairment);
  for (int i = 0; i < kDatagrams; ++i) {
    send(i);
    std::this_thread::sleep_for(20us);
  }
  std::vector<int> received;
  while (receive(number)) {
    received.push_back(number);
  }
  return received;
}

class BadCable : public NeedsNetworkNamespaces<testing::Test> {};

TEST_F(BadCable, CarriesEverythingInItsOrderUnlessToldOtherwise) {
  std::vector<int> all(kDatagrams);
  std::ranges::generate(all, [n = 0]() mutable { return n++; });
  EXPECT_EQ(received_over({}), all);
  EXPECT_EQ(received_over({.most = 1ms}), all);
}

TEST_F(BadCable, LosesTheSameBySeed) {
  const std::vector<int> received = received_over({.loss = 0.05, .seed = 3});
  EXPECT_NEAR(static_cast<double>(received.size()), 0.95 * kDatagrams, 0.02 * kDatagrams);
  EXPECT_EQ(received_over({.loss = 0.05, .seed = 3}), received);
  EXPECT_NE(received_over({.loss = 0.05, .seed = 4}), received);
}

TEST_F(BadCable, DoublesAndReorders) {
  std::vector<int> received = received_over({.duplicate = 0.1, .reorder = 0.1});
  EXPECT_FALSE(std::ranges::is_sorted(received));
  std::ranges::sort(received);
  EXPECT_NEAR(static_cast<double>(received.size()), 1.1 * kDatagrams, 0.03 * kDatagrams);
  const auto rest = std::ranges::unique(received);
  EXPECT_EQ(std::ssize(received) - std::ssize(rest), kDatagrams);
}

}  // namespace frame_relay_test
}  // namespace farrier::test
