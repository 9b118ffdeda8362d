#include "tools/foxglove/foxglove_server.hpp"

#include <libwebsockets.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <ctime>
#include <deque>
#include <map>
#include <mutex>
#include <thread>

#include "tools/foxglove/viewer.hpp"

namespace farrier::foxglove {
namespace {

constexpr std::size_t kMostArriving = 10'000;  // messages; the thread of the server is then stuck
constexpr std::size_t kReadBytes = 4096;
constexpr unsigned kSlowHandshake_s = 5;
// A viewer that answers no ping is gone.
constexpr std::uint16_t kPing_s = 10, kHangUp_s = 25;

/// Value of Sec-WebSocket-Protocol.
std::string offered(lws* wsi) {
  std::string text(static_cast<std::size_t>(std::max(0, lws_hdr_total_length(wsi, WSI_TOKEN_PROTOCOL))) + 1, '\0');
  const int length = lws_hdr_copy(wsi, text.data(), static_cast<int>(text.size()), WSI_TOKEN_PROTOCOL);
  text.resize(static_cast<std::size_t>(std::max(0, length)));
  return text;
}

/// Answers a request that is no upgrade to be had.
int refuse(lws* wsi, unsigned status, const char* why) {
  lws_return_http_status(wsi, status, why);
  return 1;
}

}  // namespace

class FoxgloveServer::Impl {
 public:
  Impl(const std::string& name, std::vector<ros_view::Topic> topics)
      : topics_(std::move(topics)),
        hello_(server_info(name, std::to_string(::getpid()) + "-" + std::to_string(::time(nullptr)))),
        advertisement_(advertisement(topics_)),
        kept_(topics_.size()) {}

  ~Impl() {
    stopping_ = true;
    if (thread_.joinable()) {
      lws_cancel_service(context_);
      thread_.join();
    }
    if (context_ != nullptr) {
      lws_context_destroy(context_);
    }
  }

  Result<Done> start(const display::ListenAddress& address) {
    if (address.port != 0) {
      FARRIER_TRY(display::check_listening(address));  // with the system's reason
    }
    // The first has requests that are no upgrades, and upgrades that name no protocol.
    protocols_ = {lws_protocols{"http", &Impl::on_event, sizeof(void*), kReadBytes, 0, nullptr, 0},
                  lws_protocols{kSubprotocols[0], &Impl::on_event, sizeof(void*), kReadBytes, 0, nullptr, 0},
                  lws_protocols{kSubprotocols[1], &Impl::on_event, sizeof(void*), kReadBytes, 0, nullptr, 0},
                  lws_protocols{}};
    retry_.secs_since_valid_ping = kPing_s;
    retry_.secs_since_valid_hangup = kHangUp_s;
    lws_set_log_level(0, nullptr);
    lws_context_creation_info info{};
    info.port = address.port;
    info.iface = address.ip == "0.0.0.0" || address.ip == "::" ? nullptr : address.ip.c_str();
    info.protocols = protocols_.data();
    info.user = this;
    info.gid = static_cast<gid_t>(-1);
    info.uid = static_cast<uid_t>(-1);
    info.timeout_secs = kSlowHandshake_s;
    info.retry_and_idle_policy = &retry_;
    info.options = LWS_SERVER_OPTION_VALIDATE_UTF8 | LWS_SERVER_OPTION_FAIL_UPON_UNABLE_TO_BIND |
                   LWS_SERVER_OPTION_EXPLICIT_VHOSTS | (address.v6 ? 0 : LWS_SERVER_OPTION_DISABLE_IPV6);
    context_ = lws_create_context(&info);
    lws_vhost* const host = context_ == nullptr ? nullptr : lws_create_vhost(context_, &info);
    if (host == nullptr) {
      return Error{"cannot listen on " + address.text()};
    }
    port_ = lws_get_vhost_listen_port(host);
    thread_ = std::thread([this] { serve(); });
    return Done{};
  }

  void send(std::size_t topic, std::uint64_t time_ns, std::span<const std::uint8_t> cdr) {
    if (topics_[topic].kept || viewers_now_ > 0) {
      auto message = std::make_shared<SharedMessage>(SharedMessage{topic, time_ns, {cdr.begin(), cdr.end()}});
      {
        const std::lock_guard lock(mutex_);
        if (arriving_.size() >= kMostArriving) {
          ++dropped_;
          return;
        }
        arriving_.push_back(std::move(message));
      }
      lws_cancel_service(context_);
    }
  }

  int port() const noexcept { return port_; }
  ServerCounts counts() const { return {viewers_ever_, sent_, dropped_}; }

 private:
  void serve() {
    // Signals are for the thread that waits for them.
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, nullptr);
    while (!stopping_ && lws_service(context_, 0) >= 0) {
    }
  }

  static int on_event(lws* wsi, lws_callback_reasons reason, void* user, void* in, std::size_t length) {
    auto* const self = wsi == nullptr ? nullptr : static_cast<Impl*>(lws_context_user(lws_get_context(wsi)));
    return self == nullptr ? 0 : self->handle(wsi, reason, static_cast<Viewer**>(user), in, length);
  }

  int handle(lws* wsi, lws_callback_reasons reason, Viewer** viewer, void* in, std::size_t length) {
    switch (reason) {
      case LWS_CALLBACK_EVENT_WAIT_CANCELLED:
        distribute();
        return 0;
      case LWS_CALLBACK_HTTP:
        return refuse(wsi, HTTP_STATUS_BAD_REQUEST, "This is a server for Foxglove: open ws://");
      case LWS_CALLBACK_HTTP_CONFIRM_UPGRADE:
        if (!offers_subprotocol(offered(wsi))) {
          return refuse(wsi, HTTP_STATUS_BAD_REQUEST, "Sec-WebSocket-Protocol must be foxglove.sdk.v1");
        }
        return viewers_.size() < kMostViewers ? 0 : refuse(wsi, HTTP_STATUS_SERVICE_UNAVAILABLE, "too many viewers");
      case LWS_CALLBACK_ESTABLISHED:
        *viewer = welcome(wsi);
        return 0;
      case LWS_CALLBACK_RECEIVE:
        return hear(wsi, **viewer, {static_cast<const char*>(in), length});
      case LWS_CALLBACK_SERVER_WRITEABLE:
        return write(wsi, **viewer);
      case LWS_CALLBACK_CLOSED:
        leave(wsi);
        return 0;
      default:
        return 0;
    }
  }

  Viewer* welcome(lws* wsi) {
    Viewer& viewer = viewers_.try_emplace(wsi, topics_.size()).first->second;
    viewers_now_ = viewers_.size();
    ++viewers_ever_;
    viewer.say(hello_);
    viewer.say(advertisement_);
    lws_callback_on_writable(wsi);
    return &viewer;
  }

  void leave(lws* wsi) {
    viewers_.erase(wsi);
    viewers_now_ = viewers_.size();
  }

  int hear(lws* wsi, Viewer& viewer, std::string_view part) {
    const bool last = lws_is_final_fragment(wsi) != 0 && lws_remaining_packet_payload(wsi) == 0;
    if (lws_frame_is_binary(wsi) != 0) {
      return close(wsi, LWS_CLOSE_STATUS_UNACCEPTABLE_OPCODE, "this server takes no messages");
    }
    if (!viewer.take(part, last)) {
      return close(wsi, LWS_CLOSE_STATUS_MESSAGE_TOO_LARGE, "too long");
    }
    for (const std::size_t topic : viewer.begun()) {
      for (const auto& message : kept_[topic]) {
        viewer.owe(*message);
      }
    }
    if (viewer.is_hopeless()) {
      return close(wsi, LWS_CLOSE_STATUS_POLICY_VIOLATION, "too much is asked and not read");
    }
    lws_callback_on_writable(wsi);
    return 0;
  }

  static int close(lws* wsi, lws_close_status status, std::string why) {
    lws_close_reason(wsi, status, reinterpret_cast<unsigned char*>(why.data()), why.size());
    return -1;
  }

  int write(lws* wsi, Viewer& viewer) {
    const std::uint64_t sent = viewer.sent();
    bytes_.assign(LWS_PRE, 0);
    const bool text = viewer.pop(bytes_);
    sent_ += viewer.sent() - sent;
    const std::size_t length = bytes_.size() - LWS_PRE;
    if (length > 0 && lws_write(wsi, bytes_.data() + LWS_PRE, length, text ? LWS_WRITE_TEXT : LWS_WRITE_BINARY) < 0) {
      return -1;
    }
    if (viewer.has_waiting()) {
      lws_callback_on_writable(wsi);
    }
    return 0;
  }

  /// Hands messages that have come on to all viewers.
  void distribute() {
    std::vector<std::shared_ptr<const SharedMessage>> messages;
    {
      const std::lock_guard lock(mutex_);
      messages.swap(arriving_);
    }
    for (const auto& message : messages) {
      if (const ros_view::Topic& topic = topics_[message->topic]; topic.kept) {
        auto& kept = kept_[message->topic];
        kept.push_back(message);
        while (kept.size() > static_cast<std::size_t>(topic.depth)) {
          kept.pop_front();
        }
      }
      for (auto& [wsi, viewer] : viewers_) {
        const std::uint64_t dropped = viewer.dropped();
        viewer.offer(message);
        dropped_ += viewer.dropped() - dropped;
      }
    }
    for (auto& [wsi, viewer] : viewers_) {
      if (viewer.has_waiting()) {
        lws_callback_on_writable(wsi);
      }
    }
  }

  const std::vector<ros_view::Topic> topics_;
  const std::string hello_, advertisement_;
  std::array<lws_protocols, 4> protocols_{};
  lws_retry_bo_t retry_{};
  lws_context* context_ = nullptr;
  int port_ = 0;
  std::thread thread_;
  std::atomic<bool> stopping_ = false;
  std::atomic<std::size_t> viewers_now_ = 0;
  std::atomic<std::uint64_t> viewers_ever_ = 0, sent_ = 0, dropped_ = 0;

  std::mutex mutex_;
  std::vector<std::shared_ptr<const SharedMessage>> arriving_;

  // Used by the thread alone.
  std::map<lws*, Viewer> viewers_;
  std::vector<std::deque<std::shared_ptr<const SharedMessage>>> kept_;  // by topic
  std::vector<std::uint8_t> bytes_;
};

Result<std::unique_ptr<FoxgloveServer>> FoxgloveServer::create(const display::ListenAddress& address,
                                                               const std::string& name,
                                                               std::vector<ros_view::Topic> topics) {
  auto impl = std::make_unique<Impl>(name, std::move(topics));
  FARRIER_TRY(impl->start(address));
  return std::unique_ptr<FoxgloveServer>(new FoxgloveServer(std::move(impl)));
}

FoxgloveServer::FoxgloveServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
FoxgloveServer::~FoxgloveServer() = default;

void FoxgloveServer::send(std::size_t topic, std::uint64_t time_ns, std::span<const std::uint8_t> cdr) {
  impl_->send(topic, time_ns, cdr);
}

int FoxgloveServer::port() const noexcept { return impl_->port(); }
ServerCounts FoxgloveServer::counts() const { return impl_->counts(); }

}  // namespace farrier::foxglove
