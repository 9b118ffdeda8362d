#include "cli/base/long_work.hpp"

#include <memory>
#include <optional>

#include "participant/loop.hpp"
#include "cli/base/progress.hpp"

namespace farrier::cli {

namespace {

using namespace std::chrono_literals;

constexpr auto kShort = 2s;
constexpr Tick kSteps = 100;

}  // namespace

KeepOn long_work(const std::string& title) {
  participant::install_signal_handlers();
  return [title, begin = std::chrono::steady_clock::now(),
          bar = std::make_shared<std::optional<Progress>>()](double share) {
    if (!*bar && std::chrono::steady_clock::now() - begin >= kShort) {
      bar->emplace(title, kSteps, "percent");
    }
    if (*bar) {
      (*bar)->update(static_cast<Tick>(static_cast<double>(kSteps) * share));
    }
    return !participant::stop_requested();
  };
}

}  // namespace farrier::cli
