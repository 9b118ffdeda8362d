#include "cli/drive/terminal_keys.hpp"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <optional>
#include <string_view>

namespace farrier::cli {
namespace {

struct KeyBytes {
  std::string_view bytes;
  Key key;
};

constexpr std::array kKeys{
    KeyBytes{"\x1b[A", Key::kFaster},
    KeyBytes{"w", Key::kFaster},
    KeyBytes{"\x1b[B", Key::kSlower},
    KeyBytes{"s", Key::kSlower},
    KeyBytes{"\x1b[D", Key::kTurnLeft},
    KeyBytes{"a", Key::kTurnLeft},
    KeyBytes{"\x1b[C", Key::kTurnRight},
    KeyBytes{"d", Key::kTurnRight},
    KeyBytes{",", Key::kLeft},
    KeyBytes{".", Key::kRight},
    KeyBytes{" ", Key::kStop},
    KeyBytes{"l", Key::kLie},
    KeyBytes{"q", Key::kEnd},
    KeyBytes{"\x03", Key::kEnd},
    KeyBytes{"x", Key::kNull},
};

constexpr std::string_view kArrow = "\x1b[";

volatile std::sig_atomic_t hung_up = 0;

void hang_up(int /*signal*/) { hung_up = 1; }

}  // namespace

std::vector<Key> keys_in(std::string& bytes) {
  std::vector<Key> keys;
  while (!bytes.empty()) {
    std::optional<KeyBytes> found;
    for (const KeyBytes& known : kKeys) {
      if (bytes.starts_with(known.bytes)) {
        found = known;
      }
    }
    if (!found && bytes.size() < kArrow.size() + 1 && (kArrow.starts_with(bytes) || bytes == kArrow)) {
      break;  // the rest of an arrow is on its way
    }
    if (found) {
      keys.push_back(found->key);
    }
    bytes.erase(0, found ? found->bytes.size() : 1);
  }
  return keys;
}

Result<TerminalKeys> TerminalKeys::open() {
  termios before{};
  if (::isatty(STDIN_FILENO) != 1 || ::tcgetattr(STDIN_FILENO, &before) != 0) {
    return Error{"keys come from a terminal: standard input is none"};
  }
  termios raw = before;
  raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO | ISIG);
  raw.c_cc[VMIN] = 0;
  raw.c_cc[VTIME] = 0;
  if (::tcsetattr(STDIN_FILENO, TCSANOW, &raw) != 0) {
    return Error{"the terminal does not take keys one by one"};
  }
  std::signal(SIGHUP, hang_up);
  return TerminalKeys(before);
}

TerminalKeys::TerminalKeys(TerminalKeys&& other) noexcept
    : before_(other.before_), bytes_(std::move(other.bytes_)), lost_(other.lost_), owns_(other.owns_) {
  other.owns_ = false;
}

TerminalKeys::~TerminalKeys() {
  if (owns_) {
    static_cast<void>(::tcsetattr(STDIN_FILENO, TCSANOW, &before_));
  }
}

bool TerminalKeys::lost() const noexcept { return lost_ || hung_up != 0; }

std::vector<Key> TerminalKeys::pressed() {
  pollfd waiting{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  if (lost_ || ::poll(&waiting, 1, 0) <= 0) {
    return {};
  }
  std::array<char, 64> buffer{};
  const ssize_t got = ::read(STDIN_FILENO, buffer.data(), buffer.size());
  if (got <= 0 && ((waiting.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0 || (got < 0 && errno != EINTR))) {
    lost_ = true;
    return {};
  }
  bytes_.append(buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  return keys_in(bytes_);
}

}  // namespace farrier::cli
