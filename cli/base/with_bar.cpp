#include "cli/base/with_bar.hpp"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "participant/loop.hpp"
#include "cli/base/progress.hpp"

namespace farrier::cli {

void with_bar(const std::string& command,
              const std::function<void(const std::function<void(double)>& progress)>& work) {
  using namespace std::chrono_literals;
  constexpr double kSteps = 100.0;
  participant::install_signal_handlers();
  std::atomic<double> share = 0.0;
  std::atomic<bool> done = false;
  std::thread beside([&] {
    work([&share](double now) { share = now; });
    done = true;
  });
  {
    Progress bar(command, static_cast<Tick>(kSteps), "percent");
    while (!done && !participant::stop_requested()) {
      bar.update(static_cast<Tick>(kSteps * share));
      std::this_thread::sleep_for(20ms);
    }
  }
  if (!done) {
    std::fprintf(stderr, "farrier %s: stopped; nothing was written\n", command.c_str());
    std::_Exit(participant::stop_status());
  }
  beside.join();
}

}  // namespace farrier::cli
