#pragma once

// Requests of a browser to the page's server, and a page in miniature.

#include <filesystem>
#include <fstream>

#include "tests/support/scratch_directory.hpp"
#include "tests/unit/monitor/feed.hpp"
#include "tools/web/web_display.hpp"

#include <httplib.h>  // behind Eigen, which has a parameter of a name that this makes a macro

namespace farrier::web::testing {

inline PageFiles small_page() {
  return {{"/", {"text/html; charset=utf-8", "<p>page</p>"}}, {"/main.js", {"text/javascript; charset=utf-8", "open();"}}};
}

inline const robot::Robot& hyq() { return monitor::testing::hyq(); }

inline std::unique_ptr<WebDisplay> serve(const std::string& ip = "127.0.0.1") {
  auto display = WebDisplay::create({ip, 0, false}, small_page(), hyq());
  EXPECT_TRUE(display.ok()) << display.error().message;
  return std::move(display).value();
}

inline httplib::Client client(const WebDisplay& display) {
  httplib::Client client("127.0.0.1", display.port());
  client.set_read_timeout(2, 0);
  return client;
}

/// Returns the text that /api/frames sends until `enough` frames and gaps have come.
inline std::string stream(const WebDisplay& display, std::size_t enough, const httplib::Headers& headers = {}) {
  std::string text;
  client(display).Get("/api/frames", headers, [&](const char* data, std::size_t size) {
    text.append(data, size);
    std::size_t events = 0;
    for (std::size_t at = text.find("\ndata: {"); at != std::string::npos; at = text.find("\ndata: {", at + 1)) {
      ++events;
    }
    return events < enough;
  });
  return text;
}

}  // namespace farrier::web::testing
