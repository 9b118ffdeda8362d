#include "bench/command/page_viewer.hpp"

#include <httplib.h>

#include <filesystem>
#include <fstream>
#include <optional>

#include "participant/clock.hpp"

namespace farrier::cli {
namespace {

using namespace std::chrono_literals;

constexpr auto kNextLook = 50ms;
constexpr std::string_view kSaid = "page at ";
constexpr std::string_view kFrame = "\ndata: {\"";

/// Returns the page's URL from the monitor's log; nothing yet if the log does not have it.
std::optional<std::string> page_url(const std::string& log_path) {
  std::ifstream log(log_path);
  for (std::string line; std::getline(log, line);) {
    if (const std::size_t said = line.find(kSaid); said != std::string::npos && !log.eof()) {
      const std::string url = line.substr(said + kSaid.size());
      return url.substr(0, url.find_last_not_of('/') + 1);
    }
  }
  return std::nullopt;
}

}  // namespace

PageViewer::PageViewer(std::string log_path) : log_path_(std::move(log_path)) {
  std::error_code none;
  std::filesystem::remove(log_path_, none);  // of an earlier run, whose page was elsewhere
  thread_ = std::thread([this] { watch(); });
}

PageViewer::~PageViewer() {
  ends_ = true;
  thread_.join();
}

double PageViewer::frames_per_s() const noexcept {
  const double lasted_s = lasted_s_;
  return lasted_s > 0.0 ? static_cast<double>(frames_ - 1) / lasted_s : 0.0;
}

void PageViewer::watch() {
  std::optional<std::string> url;
  while (!ends_ && !(url = page_url(log_path_))) {
    std::this_thread::sleep_for(kNextLook);
  }
  if (ends_) {
    return;
  }
  httplib::Client client(*url);
  client.set_read_timeout(1, 0);
  SteadyTime first{};
  std::string text;
  client.Get("/api/frames", [&](const char* data, std::size_t size) {
    text.append(data, size);
    for (std::size_t place = text.find(kFrame); place != std::string::npos; place = text.find(kFrame)) {
      text.erase(0, place + kFrame.size());
      const SteadyTime now = participant::steady_now();
      first = frames_++ == 0 ? now : first;
      lasted_s_ = std::chrono::duration<double>(now - first).count();
    }
    text.erase(0, text.size() - std::min(text.size(), kFrame.size() - 1));
    return !ends_;
  });
}

}  // namespace farrier::cli
