#include "cli/base/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace farrier::cli {
namespace {

using namespace std::chrono_literals;

constexpr int kWidth = 30;

}  // namespace

Progress::Progress(std::string title, Tick total, const char* unit)
    : title_(std::move(title)), total_(std::max<Tick>(total, 1)), unit_(unit), terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (terminal_) {
    std::fputs("\r\033[K", stderr);
  }
}

std::string Progress::count() const {
  return std::string(unit_) + ' ' + std::to_string(done_) + " of " + std::to_string(total_);
}

void Progress::draw(const std::string& tail) {
  const int filled = static_cast<int>(kWidth * done_ / total_);
  const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                          std::string(static_cast<std::size_t>(kWidth - filled), '.');
  std::fprintf(stderr, "\r\033[K%s [%s] %s%s", title_.c_str(), bar.c_str(), count().c_str(), tail.c_str());
  std::fflush(stderr);
}

void Progress::update(Tick done) {
  const SteadyTime now = std::chrono::steady_clock::now();
  const bool moved = done != done_;
  done_ = std::min(done, total_);
  if (terminal_ && moved && now >= next_draw_) {
    next_draw_ = now + 100ms;
    draw("");
  }
  const int tenth = static_cast<int>(10 * done_ / total_);
  if (!terminal_ && tenth > last_tenth_) {
    last_tenth_ = tenth;
    std::fprintf(stderr, "%s: %s\n", title_.c_str(), count().c_str());
  }
}

void Progress::note(const std::string& text) {
  if (terminal_) {
    draw("  " + text);
  } else {
    std::fprintf(stderr, "%s: %s\n", title_.c_str(), text.c_str());
  }
}

}  // namespace farrier::cli
