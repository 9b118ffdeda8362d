#pragma once

#include <atomic>
#include <string>
#include <thread>

namespace farrier::cli {

/// Watches the page of a `farrier monitor --web` as a browser does, but draws nothing.
class PageViewer {
 public:
  /// `log_path`: of the monitor, which says there where its page is. It may be started later.
  explicit PageViewer(std::string log_path);
  ~PageViewer();
  PageViewer(const PageViewer&) = delete;
  PageViewer& operator=(const PageViewer&) = delete;

  /// From the first frame that came to the last; 0 without any.
  double frames_per_s() const noexcept;

 private:
  void watch();

  std::string log_path_;
  std::atomic<bool> ends_{false};
  std::atomic<std::int64_t> frames_{0};
  std::atomic<double> lasted_s_{0.0};
  std::thread thread_;
};

}  // namespace farrier::cli
