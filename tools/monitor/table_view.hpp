#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace farrier::display {

/// Columns of the table, by any of which it may be sorted.
enum class Column : std::uint8_t {
  kJoint,
  kState,
  kPhase,
  kError,
  kNrmse,
  kMass,
  kPoles,
  kGeneration,
  kRedesigns,
  kRate,
  kMissed,
  kFaults,
};
inline constexpr int kColumnCount = 12;

/// Heading of a column.
const char* to_string(Column column) noexcept;

/// Keys that are no characters.
enum Key : int {
  kKeyEscape = 27,
  kKeyEnter = '\n',
  kKeyBackspace = 127,
  kKeyUp = 0x10000,
  kKeyDown,
  kKeyPageUp,
  kKeyPageDown,
  kKeyHome,
};

/// View of a robot that a user has chosen.
struct TableView {
  int width = 0;             ///< characters; 0: as wide as it gets
  int height = 0;            ///< lines; 0: as many as it takes
  Column sorted_by = Column::kJoint;
  bool reversed = false;
  std::string filter;        ///< words, each of which a joint's name, leg, state, phase or faults must have
  bool only_faulty = false;
  int first_row = 0;         ///< joint at the top
  bool typing = false;       ///< the filter is being typed
  bool paused = false;       ///< the frame at that moment is kept
  bool help = false;
  bool ended = false;

  /// Handles a key: a character, or a Key.
  void press(int key);
};

/// Help on the keys, a line each.
const std::array<const char*, 9>& help_lines() noexcept;

}  // namespace farrier::display
