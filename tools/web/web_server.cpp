#include "tools/web/web_server.hpp"

#include <httplib.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <charconv>
#include <memory>
#include <thread>

#include "core/text.hpp"
#include "tools/web/access.hpp"

namespace farrier::web {
namespace {

using namespace std::chrono_literals;
using Handled = httplib::Server::HandlerResponse;

constexpr int kMostStreams = 8;            // pages that watch at a time; each has a thread
constexpr std::size_t kThreads = kMostStreams + 4;
constexpr std::size_t kFramesAtOnce = 50;
constexpr auto kLongestWait = 200ms;       // for a frame, and for a page that does not read
constexpr int kSendBuffer = 128 * 1024;    // what a slow page may be behind, beside the ring

void socket_options(int socket) {
  const int on = 1;
  ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  ::setsockopt(socket, SOL_SOCKET, SO_SNDBUF, &kSendBuffer, sizeof kSendBuffer);
}

std::string own_name() {
  std::array<char, 256> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) {
    return "";
  }
  return lower(name.data());
}

/// As it is: httplib would compress a body with Brotli's slowest for every browser that can take it.
void send(httplib::Response& response, std::shared_ptr<const std::string> text, const std::string& type) {
  const std::size_t size = text->size();
  response.set_content_provider(size, type, [text](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
    return sink.write(text->data() + offset, length);
  });
}

void refuse(httplib::Response& response, int status, const char* why) {
  response.status = status;
  response.set_content(std::string(why) + "\n", "text/plain; charset=utf-8");
}

/// Server-sent events: the id of a frame is this server's and the number of the next one.
std::string stream_text(const FrameRing::Piece& piece, const std::string& life, std::uint64_t& next) {
  std::string text;
  if (piece.passed_over > 0) {
    text += "event: gap\ndata: {\"frames\":" + std::to_string(piece.passed_over) + ",\"events\":[";
    for (const FrameRing::Text& event : piece.events) {
      text += (event == piece.events.front() ? "" : ",") + *event;
    }
    text += "]}\n\n";
  }
  next = piece.next - piece.frames.size();
  for (const FrameRing::Text& frame : piece.frames) {
    text += "id: " + life + "-" + std::to_string(++next) + "\ndata: " + *frame + "\n\n";
  }
  return text;
}

}  // namespace

class WebServer::Impl {
 public:
  Impl(display::ListenAddress address, Site site) : address_(std::move(address)), site_(std::make_shared<const Site>(std::move(site))) {}
  ~Impl() {
    stopping_ = true;
    if (site_->frames) {
      site_->frames->close();
    }
    server_.stop();
    if (thread_.joinable()) {
      thread_.join();
    }
  }

  Result<Done> start() {
    server_.new_task_queue = [] { return new httplib::ThreadPool(kThreads); };
    server_.set_socket_options(socket_options);
    server_.set_tcp_nodelay(true);
    // A connection an answer: an idle one would hold a thread, and the end up.
    server_.set_keep_alive_max_count(1);
    server_.set_read_timeout(kLongestWait);
    server_.set_write_timeout(kLongestWait);
    server_.set_payload_max_length(0);
    server_.set_default_headers({{"Content-Security-Policy",
                                  "default-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
                                 {"X-Content-Type-Options", "nosniff"},
                                 {"X-Frame-Options", "DENY"},
                                 {"Cross-Origin-Resource-Policy", "same-origin"},
                                 {"Referrer-Policy", "no-referrer"},
                                 {"Cache-Control", "no-store"}});
    server_.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      return admit(request, response) ? Handled::Unhandled : Handled::Handled;
    });
    server_.Get(".*", [this](const httplib::Request& request, httplib::Response& response) { answer(request, response); });
    port_ = address_.port;
    const bool bound = port_ != 0 ? server_.bind_to_port(address_.ip, port_)
                                  : (port_ = server_.bind_to_any_port(address_.ip)) > 0;
    if (!bound) {
      const auto reason = display::check_listening(address_);
      return Error{reason ? "cannot listen on " + address_.text() : reason.error().message};
    }
    loopback_ = is_loopback(address_.ip);
    token_ = loopback_ ? std::string() : random_token();
    cookie_ = "farrier_" + std::to_string(port_);  // cookies know no ports
    thread_ = std::thread([this] { server_.listen_after_bind(); });
    while (!server_.is_running()) {
      std::this_thread::yield();  // a stop before would be none
    }
    return Done{};
  }

  int port() const noexcept { return port_; }

  std::string url() const {
    const bool any = address_.ip == "0.0.0.0" || address_.ip == "::";
    const std::string host = any ? own_name_ : address_.v6 ? "[" + address_.ip + "]" : address_.ip;
    return "http://" + host + ":" + std::to_string(port_) + "/" + (token_.empty() ? "" : "?token=" + token_);
  }

 private:
  bool admit(const httplib::Request& request, httplib::Response& response) {
    if (request.method != "GET") {
      refuse(response, 405, "this page can only be read");
      return false;
    }
    if (!host_is_ours(request.get_header_value("Host"), loopback_, own_name_)) {
      refuse(response, 421, "not the name of this computer: use the address that farrier monitor has printed");
      return false;
    }
    if (token_.empty()) {
      return true;
    }
    if (equal(request.get_param_value("token"), token_)) {
      response.set_header("Set-Cookie", cookie_ + "=" + token_ + "; HttpOnly; SameSite=Lax; Path=/");
      response.set_redirect("/");  // so that the token stays in no history
      return false;
    }
    const std::string cookies = request.get_header_value("Cookie");
    if (!equal(cookie(cookies, cookie_), token_)) {
      refuse(response, 401, "use the address that farrier monitor has printed, with its token");
      return false;
    }
    return true;
  }

  void answer(const httplib::Request& request, httplib::Response& response) {
    if (request.path == "/api/frames" && site_->frames) {
      stream(request, response);
    } else if (const auto document = site_->documents.find(request.path); document != site_->documents.end()) {
      std::string text = document->second([&](const std::string& name) { return request.get_param_value(name); });
      if (text.empty()) {
        refuse(response, 400, "no such piece");
      } else {
        send(response, std::make_shared<const std::string>(std::move(text)), "application/json");
      }
    } else if (const auto file = site_->page.find(request.path); file != site_->page.end()) {
      send(response, {site_, &file->second.bytes}, file->second.type);
    } else {
      refuse(response, 404, "no such page");
    }
  }

  void stream(const httplib::Request& request, httplib::Response& response) {
    if (streams_.fetch_add(1) >= kMostStreams) {
      --streams_;
      response.set_header("Retry-After", "5");
      refuse(response, 503, "as many pages watch already as this monitor serves");
      return;
    }
    std::uint64_t from = 0;
    const std::string last = request.get_header_value("Last-Event-ID");
    if (last.substr(0, life_.size() + 1) == life_ + "-") {  // otherwise of another server, whose numbers are not ours
      std::from_chars(last.data() + life_.size() + 1, last.data() + last.size(), from);
    }
    response.set_chunked_content_provider(
        "text/event-stream",
        [this, from, opened = false](std::size_t, httplib::DataSink& sink) mutable {
          std::string text = opened ? "" : "retry: 500\nevent: server\ndata: \"" + life_ + "\"\n\n";
          opened = true;
          const FrameRing::Piece piece = site_->frames->read(from, kFramesAtOnce, kLongestWait);
          text += stream_text(piece, life_, from);
          if (stopping_ || piece.closed) {
            return false;
          }
          // A comment where there is no frame, to find out that the page has gone.
          text = text.empty() ? ":\n\n" : text;
          return sink.write(text.data(), text.size());
        },
        [this](bool) { --streams_; });
  }

  const display::ListenAddress address_;
  const std::shared_ptr<const Site> site_;
  const std::string own_name_ = web::own_name();
  const std::string life_ = random_token().substr(0, 8);
  httplib::Server server_;
  std::thread thread_;
  std::atomic<bool> stopping_ = false;
  std::atomic<int> streams_ = 0;
  int port_ = 0;
  bool loopback_ = true;
  std::string token_, cookie_;
};

Result<std::unique_ptr<WebServer>> WebServer::create(const display::ListenAddress& address, Site site) {
  auto impl = std::make_unique<Impl>(address, std::move(site));
  FARRIER_TRY(impl->start());
  return std::unique_ptr<WebServer>(new WebServer(std::move(impl)));
}

WebServer::WebServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
WebServer::~WebServer() = default;
int WebServer::port() const noexcept { return impl_->port(); }
std::string WebServer::url() const { return impl_->url(); }

}  // namespace farrier::web
