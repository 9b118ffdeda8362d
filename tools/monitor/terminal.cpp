#include "tools/monitor/terminal.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "participant/clock.hpp"
#include "tools/monitor/recent_events.hpp"
#include "tools/monitor/terminal_table.hpp"

#define NCURSES_NOMACROS  // its macros have names that anybody's functions have
#include <curses.h>

namespace farrier::display {
namespace {

using namespace std::chrono_literals;

constexpr auto kBetweenDrawings = 250ms;  // numbers that change faster cannot be read
constexpr int kEscapeDelay_ms = 25;       // after which Esc is the key and not the beginning of another

int key_of(int code) noexcept {
  switch (code) {
    case KEY_UP: return kKeyUp;
    case KEY_DOWN: return kKeyDown;
    case KEY_PPAGE: return kKeyPageUp;
    case KEY_NPAGE: return kKeyPageDown;
    case KEY_HOME: return kKeyHome;
    case KEY_BACKSPACE:
    case '\b': return kKeyBackspace;
    case KEY_ENTER:
    case '\r': return kKeyEnter;
    default: return code;
  }
}

}  // namespace

struct Terminal::Screen {
  const robot::Robot& robot;
  SCREEN* curses;
  RecentEvents events;
  monitor::Frame frame;                 // the last one that came, with all faults since the last drawing
  monitor::Frame shown;                 // the one that is drawn: older while paused
  TableView view;
  SteadyTime next_drawing{};

  ~Screen() {
    ::endwin();
    ::delscreen(curses);
  }

  int attributes(Tone tone) const {
    const auto color = [](short pair) { return ::has_colors() ? static_cast<int>(COLOR_PAIR(pair)) : 0; };
    switch (tone) {
      case Tone::kPlain: return A_NORMAL;
      case Tone::kHeading: return A_BOLD;
      case Tone::kFaint: return A_DIM;
      case Tone::kWarning: return color(1);
      case Tone::kBad: return color(2) | static_cast<int>(A_BOLD);
    }
    return A_NORMAL;
  }

  /// True when a key changed anything.
  bool press_keys() {
    bool pressed = false;
    for (int code = ::wgetch(stdscr); code != ERR; code = ::wgetch(stdscr)) {
      pressed = true;  // KEY_RESIZE too
      if (code == '\f') {
        ::clearok(curscr, TRUE);  // Ctrl-L: somebody else has written on the screen
      }
      view.press(key_of(code));
    }
    return pressed;
  }

  void take(const monitor::Frame& next) {
    std::vector<std::uint32_t> faults;
    for (const monitor::JointFrame& joint : frame.joints) {
      faults.push_back(joint.faults);
    }
    frame = next;
    for (std::size_t i = 0; i < std::min(faults.size(), frame.joints.size()); ++i) {
      frame.joints[i].faults |= faults[i];
    }
    events.take(next);
  }

  void draw() {
    if (!view.paused || shown.joints.empty()) {
      shown = frame;
      for (monitor::JointFrame& joint : frame.joints) {
        joint.faults = joint.newest.faults;
      }
    }
    view.width = getmaxx(stdscr);
    view.height = getmaxy(stdscr);
    const Table table = terminal_table(shown, robot, events.all(), view);
    view.first_row = std::min(view.first_row, table.rows - table.shown);
    ::werase(stdscr);
    for (int i = 0; i < static_cast<int>(table.lines.size()); ++i) {
      const Line& line = table.lines[static_cast<std::size_t>(i)];
      ::wattrset(stdscr, attributes(line.tone));
      ::wmove(stdscr, i, 0);
      ::waddnstr(stdscr, line.text.c_str(), view.width);
    }
    ::wrefresh(stdscr);
  }
};

Terminal::Terminal(std::unique_ptr<Screen> screen) : screen_(std::move(screen)) {}
Terminal::~Terminal() = default;

Result<std::unique_ptr<Terminal>> Terminal::create(const robot::Robot& robot) {
  if (::isatty(STDIN_FILENO) != 1 || ::isatty(STDOUT_FILENO) != 1) {
    return Error{"standard input and output are no terminal"};
  }
  SCREEN* curses = ::newterm(nullptr, stdout, stdin);
  if (curses == nullptr) {
    const char* type = std::getenv("TERM");
    return Error{"nothing is known of a terminal of type '" + std::string(type == nullptr ? "" : type) +
                 "': set TERM, or send the output through a pipe for a plain table"};
  }
  auto screen = std::unique_ptr<Screen>(new Screen{robot, curses, {}, {}, {}, {}, {}});
  ::set_escdelay(kEscapeDelay_ms);
  ::cbreak();
  ::noecho();
  ::keypad(stdscr, TRUE);
  ::nodelay(stdscr, TRUE);
  ::curs_set(0);
  if (::has_colors()) {
    ::start_color();
    ::use_default_colors();
    ::init_pair(1, COLOR_YELLOW, -1);
    ::init_pair(2, COLOR_RED, -1);
  }
  return std::unique_ptr<Terminal>(new Terminal(std::move(screen)));
}

void Terminal::show(const monitor::Frame& frame) {
  screen_->take(frame);
  const SteadyTime now = participant::steady_now();
  if (screen_->press_keys() || now >= screen_->next_drawing) {
    screen_->next_drawing = now + kBetweenDrawings;
    screen_->draw();
  }
}

bool Terminal::ended() const { return screen_->view.ended; }

}  // namespace farrier::display
