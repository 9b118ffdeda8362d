// farrier monitor --web: the page of a robot that runs, or of a recording.

#include "cli/monitor/monitor_web.hpp"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <thread>

#include "participant/loop.hpp"
#include "cli/base/command.hpp"
#include "cli/base/installation.hpp"
#include "cli/base/long_work.hpp"
#include "tools/web/recorded_frames.hpp"
#include "tools/web/web_display.hpp"

namespace farrier::cli {
namespace {

using namespace std::chrono_literals;

constexpr const char* kUsual = ":8642";
constexpr int kHighestPort = 65535;

/// Where the page is served and what it is made of.
struct Opened {
  display::ListenAddress address;
  web::PageFiles page;
};

Result<Opened> prepare(const WebOptions& options) {
  // A port alone is one of this computer.
  const bool port_alone = options.address.find_first_not_of("0123456789") == std::string::npos;
  const std::string text = options.address.empty() ? kUsual : (port_alone ? ":" : "") + options.address;
  auto address = display::parse_listen_address(text);
  if (!address) {
    return Error{"--web: " + address.error().message};
  }
  auto page = web::read_page(page_directory());
  if (!page) {
    return Error{"--web: " + page.error().message};
  }
  return Opened{std::move(address).value(), std::move(page).value()};
}

void tell(const std::string& what, const std::string& url) {
  std::fprintf(stderr, "farrier monitor: %s at %s\n", what.c_str(), url.c_str());
}

}  // namespace

void declare_web(CLI::App& app, WebOptions& options, CLI::Option* once) {
  CLI::Option* web =
      app.add_option(
             "--web", options.address,
             "serve a page for browsers: of this computer at --web, --web 8642 or --web :8642, of others too at "
             "--web 0.0.0.0:8642, which asks for the token that is printed; at --web 0 on any port that is free")
          ->expected(0, 1)
          ->default_str(kUsual)
          ->type_name("<address:port>")
          ->excludes(once);
  app.add_option_function<int>(
         "--port", [&options](const int& port) { options.address = ":" + std::to_string(port); },
         "short for --web with a port: serve the page at this port of this computer alone")
      ->type_name("<n>")
      ->check(CLI::Range(1, kHighestPort))
      ->excludes(web)
      ->excludes(once);
  app.add_option("--open", options.recording, "show this recording on the page instead of a robot that runs")
      ->type_name("<file>");
}

Result<std::unique_ptr<display::Display>> open_web(const WebOptions& options, const robot::Robot& robot) {
  auto opened = FARRIER_TRY(prepare(options));
  auto display = web::WebDisplay::create(opened.address, std::move(opened.page), robot);
  if (!display) {
    return Error{"--web: " + display.error().message};
  }
  tell("page", display.value()->url());
  return std::unique_ptr<display::Display>(std::move(display).value());
}

int show_recording(const WebOptions& options) {
  participant::install_signal_handlers();
  auto opened = prepare(options);
  if (!opened) {
    return refuse("monitor", opened.error().message);
  }
  auto frames = web::RecordedFrames::read(options.recording, long_work("monitor, reading"));
  if (!frames) {
    return participant::stop_requested() ? participant::stop_status() : refuse("monitor", frames.error().message);
  }
  for (const std::string& remark : frames.value().remarks()) {
    std::fprintf(stderr, "farrier monitor: %s: %s\n", options.recording.c_str(), remark.c_str());
  }
  auto site = web::RecordedFrames::site(std::make_shared<const web::RecordedFrames>(std::move(frames).value()),
                                        std::move(opened.value().page));
  auto server = web::WebServer::create(opened.value().address, std::move(site));
  if (!server) {
    return refuse("monitor", "--web: " + server.error().message);
  }
  tell(options.recording, server.value()->url());
  while (!participant::stop_requested()) {
    std::this_thread::sleep_for(100ms);
  }
  return participant::stop_status();
}

}  // namespace farrier::cli
