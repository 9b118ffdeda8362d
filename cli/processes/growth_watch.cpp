#include "cli/processes/growth_watch.hpp"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>

namespace farrier::cli {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

constexpr Tick kLooks = 100;
constexpr Tick kWarmUp = 10;  // looks left out at the beginning: buffers grow to their size
constexpr auto kLongestSleep = 5s;
constexpr auto kWakeUp = 20ms;

/// Returns the resources that a process holds; nothing if it is gone.
std::optional<Growth> holdings(pid_t process) {
  const fs::path folder = fs::path("/proc") / std::to_string(process);
  std::ifstream status(folder / "status");
  Growth held;
  bool alive = false;
  for (std::string word; status >> word;) {
    if (word == "VmRSS:") {  // a zombie has none
      alive = static_cast<bool>(status >> held.memory_KiB);
    } else if (word == "Threads:") {
      status >> held.threads;
    }
  }
  std::error_code gone;
  for (fs::directory_iterator entry(folder / "fd", gone); entry != fs::directory_iterator(); entry.increment(gone)) {
    held.descriptors += 1;
  }
  return alive && !gone ? std::optional(held) : std::nullopt;
}

}  // namespace

GrowthWatch::GrowthWatch(std::vector<pid_t> processes, Tick ticks) : processes_(std::move(processes)), ticks_(ticks) {
  if (!processes_.empty()) {
    thread_ = std::thread([this] { look(); });
  }
}

GrowthWatch::~GrowthWatch() { end(); }

void GrowthWatch::end() {
  ends_ = true;
  if (thread_.joinable()) {
    thread_.join();
  }
}

void GrowthWatch::look() {
  Tick due = ticks_ * kWarmUp / kLooks;
  auto looked = std::chrono::steady_clock::now();
  for (; !ends_; std::this_thread::sleep_for(kWakeUp)) {
    const auto time = std::chrono::steady_clock::now();
    const bool too_long = first_ && time - looked > kLongestSleep;
    if ((now_ < due && !too_long) || now_ >= ticks_) {
      continue;
    }
    Holdings held;
    for (const pid_t process : processes_) {
      held.push_back(holdings(process));
    }
    looked = time;
    due = now_ + ticks_ / kLooks;
    (first_ ? last_ : first_) = std::move(held);
  }
}

std::vector<std::optional<Growth>> GrowthWatch::growths() {
  end();
  std::vector<std::optional<Growth>> growths;
  for (std::size_t i = 0; last_ && i < processes_.size(); ++i) {
    const auto& first = (*first_)[i];
    const auto& last = (*last_)[i];
    growths.push_back(!first || !last ? std::nullopt
                                      : std::optional(Growth{last->memory_KiB - first->memory_KiB,
                                                             last->threads - first->threads,
                                                             last->descriptors - first->descriptors}));
  }
  return growths;
}

}  // namespace farrier::cli
