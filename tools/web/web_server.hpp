#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/result.hpp"
#include "tools/monitor/listen_address.hpp"
#include "tools/web/frame_ring.hpp"
#include "tools/web/page_files.hpp"

namespace farrier::web {

/// Value of a parameter of a request; empty for none.
using Parameter = std::function<std::string(const std::string& name)>;

/// Content of the server. Everything is read, nothing can be changed.
struct Site {
  PageFiles page;
  /// JSON by path; an empty answer means that the request is invalid.
  std::map<std::string, std::function<std::string(const Parameter&)>> documents;
  /// Served as events at /api/frames where there is one.
  std::shared_ptr<FrameRing> frames;
};

/// Serves a site on threads of its own until it goes, which takes less than a second.
class WebServer {
 public:
  /// Port 0: any. Refuses an address that cannot be had. Beyond this computer it asks for a token.
  static Result<std::unique_ptr<WebServer>> create(const display::ListenAddress& address, Site site);
  ~WebServer();
  WebServer(const WebServer&) = delete;
  WebServer& operator=(const WebServer&) = delete;

  int port() const noexcept;
  /// URL of the page, with the token if one is needed.
  std::string url() const;

 private:
  class Impl;
  explicit WebServer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace farrier::web
