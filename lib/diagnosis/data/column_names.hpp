#pragma once

#include <optional>
#include <string>
#include <vector>

#include "diagnosis/data/recording.hpp"

namespace farrier::diagnosis {

/// Meaning of a column's name in a file that another program wrote.
struct MeantColumn {
  std::string name;        ///< "position_m", one of a recording's
  double factor = 1.0;     ///< of its values, to give that unit
  std::string group = {};  ///< what the name has beside that: a joint, or another qualifier
  bool has_unit = false;   ///< without one the meaning is a guess
};

/// Meaning of a name with a unit, as "position [mm]", "p_a (bar)", "lf_hfe.force_N" or "time_ms"; also of one without a unit,
/// as "Position". None for other names.
std::optional<MeantColumn> meant_column(const std::string& header);

/// True for a text that is a unit alone, as in a row of units under the names: "mm", "[bar]".
bool is_unit(const std::string& text);

/// Meaning of a whole header.
struct HeaderMeaning {
  std::vector<std::optional<MeantColumn>> columns;  ///< one per cell; none: not read
  std::vector<std::string> remarks = {};            ///< sentences on what was taken for what
  std::vector<Finding> findings = {};               ///< several joints without a choice; without line
};

/// The columns of a header to be read as those of these names. Exact names come first. Names with units are taken where the
/// exact one is not there. In a file of several joints those of `joint` are taken, or the only joint's.
HeaderMeaning meaning_of(const std::vector<std::string>& header, const std::vector<std::string>& names,
                         const std::string& joint);

}  // namespace farrier::diagnosis
