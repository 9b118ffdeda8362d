#pragma once

#include <httplib.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace farrier::test {

/// Frames of a page's server on this computer until done(frame).
template <class Done>
std::vector<nlohmann::json> frames_until(std::uint16_t port, Done&& done) {
  std::vector<nlohmann::json> frames;
  std::string text;
  httplib::Client client("127.0.0.1", port);
  client.set_read_timeout(5, 0);
  client.Get("/api/frames", [&](const char* data, std::size_t size) {
    text.append(data, size);
    for (std::size_t end = text.find("\n\n"); end != std::string::npos; end = text.find("\n\n")) {
      const std::string event = text.substr(0, end);
      text.erase(0, end + 2);
      const std::size_t frame = event.find("\ndata: {\"");
      if (event.starts_with("id: ") && frame != std::string::npos) {
        frames.push_back(nlohmann::json::parse(event.substr(frame + 7)));
        if (done(frames.back())) {
          return false;
        }
      }
    }
    return true;
  });
  return frames;
}

}  // namespace farrier::test
