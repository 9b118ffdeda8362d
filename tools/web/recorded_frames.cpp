#include "tools/web/recorded_frames.hpp"

#include <zstd.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "core/ensure.hpp"
#include "monitor/robot_view.hpp"
#include "tools/playback/recorded_run.hpp"
#include "tools/web/frame_json.hpp"

namespace farrier::web {
namespace {

using nlohmann::json;

constexpr std::size_t kFramesPerBlock = 100;
constexpr std::size_t kMostEvents = 5000;  // in the overview; a frame has all of its own
constexpr std::uint64_t kBegin_ns = 1'000'000'000;
constexpr auto kStep_ns = static_cast<std::uint64_t>(1e9 / RecordedFrames::kFramesPerSecond);

std::string compressed(const std::string& text) {
  std::string block(ZSTD_compressBound(text.size()), '\0');
  const std::size_t size = ZSTD_compress(block.data(), block.size(), text.data(), text.size(), 3);
  FARRIER_ENSURE(ZSTD_isError(size) == 0, "zstd refuses what is in memory");
  block.resize(size);
  return block;
}

std::string expanded(const std::string& block) {
  std::string text(ZSTD_getFrameContentSize(block.data(), block.size()), '\0');
  const std::size_t size = ZSTD_decompress(text.data(), text.size(), block.data(), block.size());
  FARRIER_ENSURE(ZSTD_isError(size) == 0, "zstd refuses what is in memory");
  return text;
}

std::size_t number_of(const std::string& text, std::size_t otherwise) {
  std::size_t value = otherwise;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace

/// Makes frames as log time passes.
class RecordedFrames::Maker {
 public:
  explicit Maker(RecordedFrames& to) : to_(to), view_(*to.robot_), faults_(to.robot_->joints.size()) {}

  void take(const recording::Sample& sample) {
    recording::Sample timed = sample;
    timed.log_time_ns = kBegin_ns + sample.elapsed_ns;  // for the view 0 is no time
    next_ns_ = next_ns_ == 0 ? timed.log_time_ns + kStep_ns : next_ns_;
    while (timed.log_time_ns >= next_ns_) {
      put(view_.frame(next_ns_));
      next_ns_ += kStep_ns;
    }
    view_.take(timed);
  }

  /// Adds an event of the page's own.
  void note(const std::string& text) {
    view_.note(signals::Severity::kWarning, text, std::max(next_ns_, kBegin_ns + kStep_ns) - kStep_ns);
  }

  void finish(const std::string& ending) {
    if (next_ns_ != 0) {
      put(view_.frame(next_ns_));
    }
    close_block();
    json faults = json::array();
    for (std::size_t joint = 0; joint < faults_.size(); ++joint) {
      end_fault(joint, end_s_);
      faults.push_back(std::move(faults_[joint].past));
    }
    const json overview = {{"duration_s", end_s_},       {"opens_at_s", opens_at_s_},
                           {"frames", to_.count_},       {"frames_per_s", kFramesPerSecond},
                           {"ending", ending},           {"events", std::move(events_)},
                           {"faults", std::move(faults)}};
    to_.overview_ = overview.dump(-1, ' ', false, json::error_handler_t::replace);
  }

 private:
  struct Faults {
    json past = json::array();  ///< [from, to, bits]
    double from_s = 0.0;
    std::uint32_t bits = 0;
  };

  void put(const monitor::Frame& frame) {
    end_s_ = frame.time_s;
    const auto said = [](const monitor::JointFrame& joint) { return !joint.summaries.empty(); };
    const auto heard = std::ranges::count_if(
        frame.joints, [](const monitor::JointFrame& joint) { return joint.newest.tick != kNoTick; });
    if (heard >= most_heard_ && std::ranges::any_of(frame.joints, said)) {
      most_heard_ = heard;
      opens_at_s_ = end_s_;
    }
    for (std::size_t joint = 0; joint < frame.joints.size(); ++joint) {
      if (frame.joints[joint].faults != faults_[joint].bits) {
        end_fault(joint, frame.time_s);
        faults_[joint].from_s = frame.time_s;
        faults_[joint].bits = frame.joints[joint].faults;
      }
    }
    for (const monitor::EventFrame& event : frame.events) {
      if (events_.size() < kMostEvents) {
        events_.push_back(json::parse(event_json(event)));
      }
    }
    block_ += frame_json(frame) + "\n";
    if (++to_.count_ % kFramesPerBlock == 0) {
      close_block();
    }
  }

  void end_fault(std::size_t joint, double time_s) {
    if (faults_[joint].bits != 0) {
      faults_[joint].past.push_back({faults_[joint].from_s, time_s, faults_[joint].bits});
    }
  }

  void close_block() {
    if (!block_.empty()) {
      to_.blocks_.push_back(compressed(block_));
      block_.clear();
    }
  }

  RecordedFrames& to_;
  monitor::RobotView view_;
  std::uint64_t next_ns_ = 0;
  double end_s_ = 0.0;
  double opens_at_s_ = 0.0;
  std::ptrdiff_t most_heard_ = 0;  ///< joints of one frame
  std::string block_;
  json events_ = json::array();
  std::vector<Faults> faults_;
};

Result<RecordedFrames> RecordedFrames::read(const std::string& path, KeepOn keep_on) {
  auto run = FARRIER_TRY(playback::RecordedRun::open(path, {}, std::move(keep_on)));
  RecordedFrames frames;
  frames.robot_ = std::make_shared<const robot::Robot>(run.robot());
  Maker maker(frames);
  const auto& topics = monitor::RobotView::topics();
  bool summaries = false;
  std::size_t told = 0;  // steps of the clock
  recording::Sample sample;
  while (run.next(sample)) {
    for (const auto& steps = run.timeline().steps(); told < steps.size(); ++told) {
      maker.note(recording::to_string(steps[told]) + "; the page goes on without the step");
    }
    if (std::ranges::find(topics, sample.topic) != topics.end()) {
      summaries = summaries || sample.topic == bus::TopicId::kJointSummary;
      maker.take(sample);
    }
  }
  if (run.ending() == recording::kInterrupted) {
    return Error{path + ": " + run.ending()};
  }
  if (!summaries) {
    return Error{path + " has no samples of lf/joint/summary, from which pages are drawn" +
                 (run.ending().empty() ? "" : ": " + run.ending())};
  }
  frames.remarks_ = recording::step_texts(run.timeline());
  if (!run.ending().empty()) {
    frames.remarks_.push_back(run.ending());
    maker.note("the recording is not whole: " + run.ending());
  }
  maker.finish(run.ending());
  return frames;
}

std::string RecordedFrames::frames(std::size_t from, std::size_t to, std::size_t every) const {
  if (every == 0) {
    return "";
  }
  to = std::min(to, count_);
  std::string text;
  std::size_t wanted = from;
  std::size_t given = 0;
  while (wanted < to && given < kMostAtOnce) {
    const std::string block = expanded(blocks_[wanted / kFramesPerBlock]);
    std::size_t i = wanted - wanted % kFramesPerBlock;
    for (std::size_t line = 0; line < block.size() && i < to && given < kMostAtOnce; ++i) {
      const std::size_t end = block.find('\n', line);
      if (i == wanted) {
        text += (text.empty() ? "[" : ",") + block.substr(line, end - line);
        wanted += std::min(every, to - wanted);
        ++given;
      }
      line = end + 1;
    }
  }
  return text.empty() ? text : text + "]";
}

Site RecordedFrames::site(std::shared_ptr<const RecordedFrames> frames, PageFiles page) {
  Site site{.page = std::move(page), .documents = {}, .frames = nullptr};
  site.documents["/api/robot"] = [text = robot_json(frames->robot(), true)](const Parameter&) { return text; };
  site.documents["/api/recording"] = [frames](const Parameter&) { return frames->overview(); };
  site.documents["/api/frames"] = [frames](const Parameter& parameter) {
    return frames->frames(number_of(parameter("from"), 0), number_of(parameter("to"), frames->count()),
                          number_of(parameter("every"), 1));
  };
  return site;
}

}  // namespace farrier::web
