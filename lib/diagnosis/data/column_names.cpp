#include "diagnosis/data/column_names.hpp"

#include <algorithm>
#include <numbers>
#include <string_view>

#include "core/text.hpp"
#include "core/units.hpp"
#include "diagnosis/judge/finding_text.hpp"

namespace farrier::diagnosis {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

/// Units by the SI unit of a recording that they are a multiple of.
struct NamedUnit {
  const char* text;
  const char* si;
  double factor;
};
constexpr NamedUnit kNamedUnits[] = {{"s", "s", 1.0},
                                     {"sec", "s", 1.0},
                                     {"seconds", "s", 1.0},
                                     {"ms", "s", 1e-3},
                                     {"msec", "s", 1e-3},
                                     {"us", "s", 1e-6},
                                     {"µs", "s", 1e-6},
                                     {"ns", "s", 1e-9},
                                     {"nsec", "s", 1e-9},
                                     {"m", "m", 1.0},
                                     {"cm", "m", 1e-2},
                                     {"mm", "m", 1e-3},
                                     {"um", "m", 1e-6},
                                     {"m/s", "m_s", 1.0},
                                     {"m_s", "m_s", 1.0},
                                     {"cm/s", "m_s", 1e-2},
                                     {"mm/s", "m_s", 1e-3},
                                     {"mm_s", "m_s", 1e-3},
                                     {"N", "N", 1.0},
                                     {"kN", "N", 1e3},
                                     {"rad", "rad", 1.0},
                                     {"mrad", "rad", 1e-3},
                                     {"deg", "rad", kDegree},
                                     {"°", "rad", kDegree},
                                     {"rad/s", "rad_s", 1.0},
                                     {"rad_s", "rad_s", 1.0},
                                     {"deg/s", "rad_s", kDegree},
                                     {"deg_s", "rad_s", kDegree},
                                     {"°/s", "rad_s", kDegree},
                                     {"Nm", "Nm", 1.0},
                                     {"N.m", "Nm", 1.0},
                                     {"N·m", "Nm", 1.0},
                                     {"N*m", "Nm", 1.0},
                                     {"kNm", "Nm", 1e3},
                                     {"A", "A", 1.0},
                                     {"mA", "A", 1e-3},
                                     {"uA", "A", 1e-6},
                                     {"Pa", "Pa", 1.0},
                                     {"kPa", "Pa", 1e3},
                                     {"MPa", "Pa", 1e6},
                                     {"bar", "Pa", 1e5},
                                     {"mbar", "Pa", 1e2},
                                     {"psi", "Pa", kPascalPerPsi}};

/// Words for a quantity, by the name of the column that has the unit.
struct QuantityWord {
  const char* text;
  const char* si;
  const char* name;
};
constexpr QuantityWord kWords[] = {{"time", "s", "time_s"},
                                   {"t", "s", "time_s"},
                                   {"timestamp", "s", "time_s"},
                                   {"time_stamp", "s", "time_s"},
                                   {"stamp", "s", "time_s"},
                                   {"elapsed", "s", "time_s"},
                                   {"valve_current", "A", "valve_current_A"},
                                   {"valve", "A", "valve_current_A"},
                                   {"current", "A", "valve_current_A"},
                                   {"i_valve", "A", "valve_current_A"},
                                   {"servo_current", "A", "valve_current_A"},
                                   {"pressure_a", "Pa", "pressure_a_Pa"},
                                   {"p_a", "Pa", "pressure_a_Pa"},
                                   {"pa", "Pa", "pressure_a_Pa"},
                                   {"pressure_b", "Pa", "pressure_b_Pa"},
                                   {"p_b", "Pa", "pressure_b_Pa"},
                                   {"pb", "Pa", "pressure_b_Pa"},
                                   {"supply_pressure", "Pa", "supply_pressure_Pa"},
                                   {"pressure_supply", "Pa", "supply_pressure_Pa"},
                                   {"p_s", "Pa", "supply_pressure_Pa"},
                                   {"ps", "Pa", "supply_pressure_Pa"},
                                   {"p_supply", "Pa", "supply_pressure_Pa"},
                                   {"position", "m", "position_m"},
                                   {"pos", "m", "position_m"},
                                   {"x", "m", "position_m"},
                                   {"displacement", "m", "position_m"},
                                   {"velocity", "m_s", "velocity_m_s"},
                                   {"vel", "m_s", "velocity_m_s"},
                                   {"v", "m_s", "velocity_m_s"},
                                   {"speed", "m_s", "velocity_m_s"},
                                   {"force", "N", "force_N"},
                                   {"load_cell", "N", "force_N"},
                                   {"f", "N", "force_N"},
                                   {"angle", "rad", "angle_rad"},
                                   {"position", "rad", "angle_rad"},
                                   {"pos", "rad", "angle_rad"},
                                   {"q", "rad", "angle_rad"},
                                   {"velocity", "rad_s", "velocity_rad_s"},
                                   {"vel", "rad_s", "velocity_rad_s"},
                                   {"dq", "rad_s", "velocity_rad_s"},
                                   {"qd", "rad_s", "velocity_rad_s"},
                                   {"omega", "rad_s", "velocity_rad_s"},
                                   {"speed", "rad_s", "velocity_rad_s"},
                                   {"torque", "Nm", "torque_Nm"},
                                   {"tau", "Nm", "torque_Nm"},
                                   {"effort", "Nm", "torque_Nm"},
                                   {"swing", "", "swing"}};

std::string lowered(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return result;
}

/// In lower case, with one "_" in place of all that is no letter and no digit.
std::string plain(std::string_view text) {
  std::string result;
  for (const char c : lowered(text)) {
    const bool kept = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (kept || (!result.empty() && result.back() != '_')) {
      result += kept ? c : '_';
    }
  }
  return result.ends_with('_') ? result.substr(0, result.size() - 1) : result;
}

/// Letters first as they are: mPa is no MPa.
const NamedUnit* unit_of_text(std::string_view text) {
  const auto exact =
      std::ranges::find(kNamedUnits, text, [](const NamedUnit& unit) { return std::string_view(unit.text); });
  if (exact != std::end(kNamedUnits)) {
    return &*exact;
  }
  const std::string small = lowered(text);
  const NamedUnit* found = nullptr;
  for (const NamedUnit& unit : kNamedUnits) {
    if (lowered(unit.text) == small) {
      if (found != nullptr) {
        return nullptr;  // two units in letters of the other size
      }
      found = &unit;
    }
  }
  return found;
}

/// A name in its parts: the unit in brackets or at its end, and the rest.
struct Parts {
  std::string rest;
  const NamedUnit* unit = nullptr;
};

Parts parts_of(const std::string& header) {
  for (const auto& [open, close] : {std::pair('[', ']'), std::pair('(', ')'), std::pair('<', '>')}) {
    const std::size_t begin = header.rfind(open);
    if (begin != std::string::npos && header.ends_with(close)) {
      std::string inside = header.substr(begin + 1, header.size() - begin - 2);
      return {header.substr(0, begin), unit_of_text(inside)};
    }
  }
  for (std::size_t at = header.find_first_of("_ ,/", 1); at != std::string::npos;
       at = header.find_first_of("_ ,/", at + 1)) {
    if (const NamedUnit* const unit = unit_of_text(std::string_view(header).substr(at + 1))) {
      return {header.substr(0, at), unit};
    }
  }
  return {header, nullptr};
}

/// The name for a quantity in a unit; without a unit the first that the word may mean. Empty for none.
std::string name_for(const std::string& word, const NamedUnit* unit) {
  for (const QuantityWord& known : kWords) {
    if (word == known.text && (unit == nullptr || std::string_view(known.si) == unit->si)) {
      return known.name;
    }
  }
  return "";
}

}  // namespace

bool is_unit(const std::string& text) {
  const bool brackets = text.size() > 2 && (text.front() == '[' || text.front() == '(');
  return unit_of_text(brackets ? text.substr(1, text.size() - 2) : text) != nullptr;
}

std::optional<MeantColumn> meant_column(const std::string& header) {
  const Parts parts = parts_of(header);
  const std::string all = plain(parts.rest);
  const auto meant = [&](const std::string& name, std::string_view group) {
    return MeantColumn{.name = name,
                       .factor = parts.unit == nullptr ? 1.0 : parts.unit->factor,
                       .group = std::string(group),
                       .has_unit = parts.unit != nullptr || name == "swing"};
  };
  if (const std::string name = name_for(all, parts.unit); !name.empty()) {
    return meant(name, "");
  }
  if (parts.unit == nullptr) {
    return std::nullopt;
  }
  // The longest word at either end names the quantity.
  for (std::size_t at = all.find('_'); at != std::string::npos; at = all.find('_', at + 1)) {
    if (const std::string name = name_for(all.substr(at + 1), parts.unit); !name.empty()) {
      return meant(name, all.substr(0, at));
    }
  }
  for (std::size_t at = all.rfind('_'); at != std::string::npos && at > 0; at = all.rfind('_', at - 1)) {
    if (const std::string name = name_for(all.substr(0, at), parts.unit); !name.empty()) {
      return meant(name, all.substr(at + 1));
    }
  }
  return std::nullopt;
}

HeaderMeaning meaning_of(const std::vector<std::string>& header, const std::vector<std::string>& names,
                         const std::string& joint) {
  HeaderMeaning meaning;
  meaning.columns.resize(header.size());
  std::vector<std::optional<MeantColumn>> guesses;
  const auto is_taken = [&](const std::string& name) {
    return std::ranges::any_of(meaning.columns, [&](const auto& column) { return column && column->name == name; });
  };
  for (std::size_t i = 0; i < header.size(); ++i) {
    guesses.push_back(meant_column(header[i]));
    if (std::ranges::find(names, header[i]) != names.end()) {
      meaning.columns[i] = MeantColumn{.name = header[i], .has_unit = true};
    }
  }
  const auto take_group = [&](const std::string& group) {
    const std::vector<std::optional<MeantColumn>> before = meaning.columns;
    for (std::size_t i = 0; i < header.size(); ++i) {
      const auto& guess = guesses[i];
      const bool free = guess && !std::ranges::any_of(
                                     before, [&](const auto& column) { return column && column->name == guess->name; });
      if (!meaning.columns[i] && free && guess->has_unit && guess->group == group &&
          std::ranges::find(names, guess->name) != names.end()) {
        meaning.columns[i] = guess;
        const std::string times = guess->factor == 1.0 ? "" : ", times " + rounded(guess->factor);
        meaning.remarks.push_back("Column " + shown(header[i]) + " is read as " + guess->name + times + ".");
      }
    }
  };
  take_group("");
  // Columns of joints, where the quantity has none without one.
  std::vector<std::string> groups;
  for (const auto& guess : guesses) {
    if (guess && guess->has_unit && !guess->group.empty() && !is_taken(guess->name) &&
        std::ranges::find(names, guess->name) != names.end() &&
        std::ranges::find(groups, guess->group) == groups.end()) {
      groups.push_back(guess->group);
    }
  }
  const auto of_joint = std::ranges::find(groups, plain(joint));
  const bool moves = is_taken("position_m") || is_taken("angle_rad");
  if (of_joint != groups.end()) {
    take_group(*of_joint);
  } else if (groups.size() == 1 && !moves) {
    take_group(groups.front());
  } else if (!groups.empty() && !moves) {
    meaning.findings.push_back(
        {"several_joints", 0,
         "columns of " + join(groups, ", ") + (joint.empty() ? "" : ", and none of " + joint) +
             "; give --joint one of them, or keep the columns of one as time_s, position_m and force_N"});
  }
  return meaning;
}

}  // namespace farrier::diagnosis
