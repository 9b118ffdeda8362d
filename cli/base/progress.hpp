#pragma once

#include <cstdint>
#include <string>

#include "core/time.hpp"

namespace farrier::cli {

/// Progress of long work on standard error: a bar that redraws itself on a terminal, a line every tenth elsewhere.
class Progress {
 public:
  /// `unit`: what is counted.
  Progress(std::string title, Tick total, const char* unit = "tick");
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void update(Tick done);
  /// Says why nothing moves, until the next update that does.
  void note(const std::string& text);

 private:
  void draw(const std::string& tail);

  std::string count() const;

  std::string title_;
  Tick total_;
  const char* unit_;
  Tick done_ = 0;
  bool terminal_;
  int last_tenth_ = -1;
  SteadyTime next_draw_{};
};

}  // namespace farrier::cli
