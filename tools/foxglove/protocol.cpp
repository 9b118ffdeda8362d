#include "tools/foxglove/protocol.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <nlohmann/json.hpp>

namespace farrier::foxglove {
namespace {

using nlohmann::json;

constexpr std::uint8_t kMessageData = 1;

std::string text_of(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

/// A number of 32 bits; none for any other value.
std::optional<std::uint32_t> number(const json& value) {
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() > UINT32_MAX) {
    return std::nullopt;
  }
  return value.get<std::uint32_t>();
}

std::optional<std::uint32_t> number(const json& object, const char* name) {
  const auto found = object.is_object() ? object.find(name) : object.end();
  return object.is_object() && found != object.end() ? number(*found) : std::nullopt;
}

/// A short quotation of what a viewer has sent.
std::string quoted(const std::string& text) {
  constexpr std::size_t kMost = 40;
  return "\"" + text.substr(0, kMost) + (text.size() > kMost ? "..." : "") + "\"";
}

/// The list of this name, empty where there is none.
const json& list(const json& object, const char* name) {
  static const json none = json::array();
  const auto found = object.find(name);
  return found != object.end() && found->is_array() ? *found : none;
}

template <class Number>
void append(std::vector<std::uint8_t>& bytes, Number value) {
  static_assert(std::endian::native == std::endian::little);
  const auto* const first = reinterpret_cast<const std::uint8_t*>(&value);
  bytes.insert(bytes.end(), first, first + sizeof value);
}

}  // namespace

bool offers_subprotocol(std::string_view header) {
  while (!header.empty()) {
    const std::size_t comma = std::min(header.find(','), header.size());
    std::string_view name = header.substr(0, comma);
    header.remove_prefix(std::min(comma + 1, header.size()));
    name.remove_prefix(std::min(name.find_first_not_of(" \t"), name.size()));
    name = name.substr(0, name.find_last_not_of(" \t") + 1);
    if (std::ranges::find(kSubprotocols, name) != std::end(kSubprotocols)) {
      return true;
    }
  }
  return false;
}

std::string server_info(const std::string& name, const std::string& session) {
  return text_of({{"op", "serverInfo"},
                  {"name", name},
                  {"capabilities", json::array()},
                  {"supportedEncodings", json::array()},
                  {"sessionId", session}});
}

std::string advertisement(const std::vector<ros_view::Topic>& topics) {
  json channels = json::array();
  for (const ros_view::Topic& topic : topics) {
    channels.push_back({{"id", channels.size()},
                        {"topic", topic.name},
                        {"encoding", "cdr"},
                        {"schemaName", topic.type},
                        {"schemaEncoding", "ros2msg"},
                        {"schema", topic.definition}});
  }
  return text_of({{"op", "advertise"}, {"channels", std::move(channels)}});
}

std::string status(StatusLevel level, const std::string& message) {
  return text_of({{"op", "status"}, {"level", static_cast<int>(level)}, {"message", message}});
}

void append_message(std::vector<std::uint8_t>& bytes, std::uint32_t subscription, std::uint64_t time_ns,
                    std::span<const std::uint8_t> cdr) {
  append(bytes, kMessageData);
  append(bytes, subscription);
  append(bytes, time_ns);
  bytes.insert(bytes.end(), cdr.begin(), cdr.end());
}

Subscriptions::Outcome Subscriptions::take(std::string_view text) {
  Outcome outcome;
  const json message = json::parse(text, nullptr, false);
  const auto op = message.is_object() ? message.find("op") : message.end();
  if (!message.is_object() || op == message.end() || !op->is_string()) {
    outcome.problems.emplace_back("a text that is no JSON object with an op is ignored");
    return outcome;
  }
  const auto name = op->get<std::string>();
  if (name == "subscribe") {
    for (const json& one : list(message, "subscriptions")) {
      const auto id = number(one, "id");
      const auto channel = number(one, "channelId");
      if (!id || !channel) {
        outcome.problems.emplace_back("a subscription without the numbers id and channelId is ignored");
      } else if (*channel >= ids_.size()) {
        outcome.problems.push_back("there is no channel " + std::to_string(*channel));
      } else if (ids_[*channel] || std::ranges::find(ids_, id) != ids_.end()) {
        outcome.problems.push_back("channel " + std::to_string(*channel) + " or subscription " + std::to_string(*id) +
                                   " is subscribed to already");
      } else {
        ids_[*channel] = id;
        outcome.begun.push_back(*channel);
      }
    }
  } else if (name == "unsubscribe") {
    for (const json& one : list(message, "subscriptionIds")) {
      const auto id = number(one);
      const auto found = id ? std::ranges::find(ids_, id) : ids_.end();
      if (found == ids_.end()) {
        outcome.problems.emplace_back("there is no such subscription to end");
      } else {
        found->reset();
      }
    }
  } else {
    outcome.problems.push_back("this server knows no op " + quoted(name) + ", it can only be read");
  }
  return outcome;
}

}  // namespace farrier::foxglove
