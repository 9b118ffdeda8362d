#pragma once

#include <termios.h>

#include <string>
#include <vector>

#include "cli/drive/steering.hpp"
#include "core/result.hpp"

namespace farrier::cli {

/// The keys in bytes that a terminal sent. A sequence that is cut off stays in `bytes` for the next call.
std::vector<Key> keys_in(std::string& bytes);

/// The keyboard of the terminal on standard input, key by key and without echo. The destructor restores the terminal.
class TerminalKeys {
 public:
  /// Refuses a standard input that is no terminal.
  static Result<TerminalKeys> open();
  TerminalKeys(TerminalKeys&& other) noexcept;
  TerminalKeys& operator=(TerminalKeys&&) = delete;
  ~TerminalKeys();

  /// Keys that were pressed since the last call. Does not wait.
  std::vector<Key> pressed();
  /// True when the terminal is gone.
  bool lost() const noexcept;

 private:
  explicit TerminalKeys(const termios& before) noexcept : before_(before) {}

  termios before_;
  std::string bytes_;
  bool lost_ = false;  ///< noticed by a read
  bool owns_ = true;
};

}  // namespace farrier::cli
