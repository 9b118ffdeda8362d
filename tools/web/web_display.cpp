#include "tools/web/web_display.hpp"

#include "tools/web/frame_json.hpp"

namespace farrier::web {
namespace {

constexpr std::size_t kFrames = 200;  // ten seconds: what a page that is opened sees of the past
constexpr std::size_t kEvents = 300;

}  // namespace

Result<std::unique_ptr<WebDisplay>> WebDisplay::create(const display::ListenAddress& address, PageFiles page,
                                                       const robot::Robot& robot) {
  auto frames = std::make_shared<FrameRing>(kFrames, kEvents);
  Site site{.page = std::move(page), .documents = {}, .frames = frames};
  site.documents["/api/robot"] = [text = robot_json(robot, false)](const Parameter&) { return text; };
  auto server = FARRIER_TRY(WebServer::create(address, std::move(site)));
  return std::unique_ptr<WebDisplay>(new WebDisplay(std::move(frames), std::move(server)));
}

void WebDisplay::show(const monitor::Frame& frame) {
  std::vector<std::string> events;
  for (const monitor::EventFrame& event : frame.events) {
    events.push_back(event_json(event));
  }
  frames_->put(frame_json(frame), events);
}

}  // namespace farrier::web
