#include "tools/monitor/table_view.hpp"

#include <algorithm>

namespace farrier::display {
namespace {

constexpr int kPage = 10;
constexpr std::size_t kLongestFilter = 40;

Column beside(Column column, int step) {
  return static_cast<Column>((static_cast<int>(column) + step + kColumnCount) % kColumnCount);
}

}  // namespace

const char* to_string(Column column) noexcept {
  switch (column) {
    case Column::kJoint: return "joint";
    case Column::kState: return "mode";
    case Column::kPhase: return "phase";
    case Column::kError: return "error";
    case Column::kNrmse: return "nrmse";
    case Column::kMass: return "mass";
    case Column::kPoles: return "poles";
    case Column::kGeneration: return "gains";
    case Column::kRedesigns: return "redes.";
    case Column::kRate: return "Hz";
    case Column::kMissed: return "missed";
    case Column::kFaults: return "faults";
  }
  return "?";
}

const std::array<const char*, 9>& help_lines() noexcept {
  static constexpr std::array<const char*, 9> lines{
      "s, S        sort by the next, the previous column",
      "r           reverse the order",
      "/           filter: words that a joint's name, leg, mode, phase or faults must have; Enter ends, Esc clears",
      "f           only joints with a fault, and all again",
      "up, down    scroll; Page up, Page down by ten; Home to the first",
      "p           pause, and go on",
      "c           clear filter and order",
      "h, ?        this help, and away with it",
      "q           quit",
  };
  return lines;
}

void TableView::press(int key) {
  if (typing) {
    if (key == kKeyEnter || key == kKeyEscape) {
      typing = false;
      filter = key == kKeyEscape ? "" : filter;
    } else if (key == kKeyBackspace && !filter.empty()) {
      filter.pop_back();
    } else if (key >= ' ' && key < kKeyBackspace && filter.size() < kLongestFilter) {
      filter += static_cast<char>(key);
    }
    first_row = 0;
    return;
  }
  switch (key) {
    case 's': sorted_by = beside(sorted_by, 1); break;
    case 'S': sorted_by = beside(sorted_by, -1); break;
    case 'r': reversed = !reversed; break;
    case '/': typing = true; break;
    case kKeyEscape: filter.clear(); break;
    case 'f': only_faulty = !only_faulty; break;
    case 'p':
    case ' ': paused = !paused; break;
    case 'h':
    case '?': help = !help; break;
    case 'c':
      filter.clear();
      only_faulty = reversed = false;
      sorted_by = Column::kJoint;
      first_row = 0;
      break;
    case 'q': ended = true; break;
    case kKeyUp: --first_row; break;
    case kKeyDown: ++first_row; break;
    case kKeyPageUp: first_row -= kPage; break;
    case kKeyPageDown: first_row += kPage; break;
    case kKeyHome: first_row = 0; break;
    default: break;
  }
  first_row = std::max(first_row, 0);
}

}  // namespace farrier::display
