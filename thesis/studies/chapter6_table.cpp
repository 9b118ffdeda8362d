// Hubacher (2014), Table 6.1: what estimators make of few or many frequencies and of a small or large amplitude.

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "thesis/studies/registry.hpp"
#include "thesis/rig/table_6_1.hpp"

namespace farrier::thesis {
namespace chapter6_table_studies {
namespace {

using thesis::Table61Cell;

constexpr const char* kGood =
    "The linear estimator performs very well for input signals having rich frequency content and low amplitude ...";
constexpr const char* kBlurred = "The performance decreases when high amplitude signals are used ...";
constexpr const char* kLimited =
    "Low frequency content signals do not excite the system enough to give accurate estimates.";
constexpr const char* kAsked =
    "... other estimators may be used in the future, such as nonlinear estimators that are able to cope with the high "
    "nonlinearities ...";

constexpr const char* kGain =
    "Grey box: largest error of the gain over 0.5 to 100 Hz, 60 ms after the changes of load.";
constexpr const char* kPhase = "Grey box: the same, of the phase.";
constexpr const char* kMass = "Grey box: the same, of the mass over the mass.";
constexpr const char* kNoisy = "Grey box: the same, of the mass, with the sensors of fc1d.yaml.";

constexpr const char* kOrder = "... good ... acceptable ... limited ... the worst ...";

// "Good", "acceptable" and "limited" are no numbers. Here good is within 3 dB and no more.
constexpr double kGood_dB = 3.0;

constexpr ClaimSpec gain(const char* id) { return aim({id, "6.3.2", kAsked, kGain, "dB", Relation::kAtMost, 2.0}); }
constexpr ClaimSpec phase(const char* id) { return aim({id, "6.3.2", kAsked, kPhase, "deg", Relation::kAtMost, 10.0}); }
constexpr ClaimSpec mass(const char* id) { return aim({id, "6.3.2", kAsked, kMass, "1", Relation::kAtMost, 0.1}); }
/// The grey box with a wrong actuator. Its bound is that of the true one.
constexpr ClaimSpec wrong(const char* id) {
  return fails(
      "K_v alone wrong by 20 %, beta_e alone wrong by 20 %, and both by 5 %, which leaves 0.04 to 0.1 of the mass with "
      "many frequencies and more than twice the mass with few. Estimated together with the load, they cost nothing "
      "(6.1.greybox_finds...)",
      aim({id, "6.3.2", kAsked,
           "Grey box that takes a K_v 20 % too large and a beta_e 20 % too small as known: largest error of the mass "
           "over the mass.",
           "1", Relation::kAtMost, 0.1}));
}
constexpr ClaimSpec finds(const char* id) {
  return aim({id, "6.3.2", kAsked,
              "Grey box that is given the same wrong actuator, takes it for uncertain by 20 % and estimates it: "
              "largest error of the mass "
              "over the mass.",
              "1", Relation::kAtMost, 0.1});
}
constexpr ClaimSpec noisy(const char* id) { return aim({id, "6.3.2", kAsked, kNoisy, "1", Relation::kAtMost, 0.2}); }

constexpr ClaimSpec kClaims[] = {
    {"6.1.rls.rich_low.gain_error_dB", "Table 6.1", kGood,
     "Least squares, rich and low: median over changes of the largest gain error, 60 ms after.", "dB",
     Relation::kAtMost, kGood_dB},
    {"6.1.rls.rich_high.gain_error_dB", "Table 6.1", kBlurred, "The same, rich and high.", "dB", Relation::kAtLeast,
     kGood_dB},
    {"6.1.rls.poor_low.gain_error_dB", "Table 6.1", kLimited, "The same, few frequencies and low.", "dB",
     Relation::kAtLeast, kGood_dB},
    {"6.1.rls.poor_high.gain_error_dB", "Table 6.1", kLimited, "The same, few frequencies and high.", "dB",
     Relation::kAtLeast, kGood_dB},
    {"6.1.rls.order.good_is_best", "Table 6.1", kOrder,
     "Gain error of rich and low, over the least of the three others: below 1.", "1", Relation::kBelow, 1.0},
    {"6.1.rls.order.acceptable_is_second", "Table 6.1", kOrder,
     "Gain error of rich and high, over the lesser of those with few frequencies: below 1.", "1", Relation::kBelow,
     1.0},
    {"6.1.rls.order.poor_high_is_worst", "Table 6.1", kOrder,
     "Gain error with few frequencies and high, over the largest of the three others: 1 or more.", "1",
     Relation::kAtLeast, 1.0},
    finds("6.1.greybox_finds.rich_low.mass_error"),
    finds("6.1.greybox_finds.rich_high.mass_error"),
    finds("6.1.greybox_finds.poor_low.mass_error"),
    finds("6.1.greybox_finds.poor_high.mass_error"),
    wrong("6.1.greybox_wrong.rich_low.mass_error"),
    wrong("6.1.greybox_wrong.rich_high.mass_error"),
    wrong("6.1.greybox_wrong.poor_low.mass_error"),
    wrong("6.1.greybox_wrong.poor_high.mass_error"),
    gain("6.1.greybox.rich_low.gain_error_dB"),
    phase("6.1.greybox.rich_low.phase_error_deg"),
    mass("6.1.greybox.rich_low.mass_error"),
    noisy("6.1.greybox.rich_low.noisy_mass_error"),
    gain("6.1.greybox.rich_high.gain_error_dB"),
    phase("6.1.greybox.rich_high.phase_error_deg"),
    mass("6.1.greybox.rich_high.mass_error"),
    noisy("6.1.greybox.rich_high.noisy_mass_error"),
    gain("6.1.greybox.poor_low.gain_error_dB"),
    phase("6.1.greybox.poor_low.phase_error_deg"),
    mass("6.1.greybox.poor_low.mass_error"),
    noisy("6.1.greybox.poor_low.noisy_mass_error"),
    gain("6.1.greybox.poor_high.gain_error_dB"),
    phase("6.1.greybox.poor_high.phase_error_deg"),
    mass("6.1.greybox.poor_high.mass_error"),
    noisy("6.1.greybox.poor_high.noisy_mass_error")};

using Errors = std::array<double, 3>;

double largest(const Errors& errors) { return std::ranges::max(errors); }

double middle(Errors errors) {
  std::ranges::sort(errors);
  return errors[1];
}

std::string cell_name(const Table61Cell& cell) {
  return std::string(cell.rich ? "rich" : "poor") + (cell.high ? "_high" : "_low");
}

/// "RLS 1.2, AFF 3.4": what the linear methods make of the same cell.
std::string beside(const std::vector<Table61Cell>& cells, const Table61Cell& cell, Errors Table61Cell::*errors) {
  std::string note;
  for (const Table61Cell& other : cells) {
    if (other.rich == cell.rich && other.high == cell.high && other.noisy == cell.noisy &&
        std::string_view(other.method) != cell.method) {
      char text[48];
      std::snprintf(text, sizeof text, "%s%s %.3g", note.empty() ? "" : ", ", other.method, largest(other.*errors));
      note += text;
    }
  }
  return note;
}

/// Every method in every cell, the largest error of the three changes.
std::vector<StudyFigure> every_cell(const std::vector<Table61Cell>& cells) {
  std::vector<StudyFigure> figures;
  for (const Table61Cell& cell : cells) {
    const std::string id =
        std::string("6.1.") + cell.method + "." + cell_name(cell) + (cell.noisy ? ".noisy." : ".clean.");
    figures.push_back({id + "gain_dB", largest(cell.gain_error_dB), "dB",
                       "Largest error of the gain over 0.5 to 100 Hz, 60 ms after any change of load."});
    figures.push_back({id + "phase_deg", largest(cell.phase_error_deg), "deg", "The same, of the phase."});
    figures.push_back({id + "mass", largest(cell.mass_error), "1", "The same, of the mass over the mass."});
  }
  return figures;
}

/// Errors by cell: the cells one above the other, the methods side by side within each.
Panel panel_of(const std::vector<Table61Cell>& cells, bool noisy, const char* title, const char* x_label,
               Errors Table61Cell::*errors, double bound) {
  Panel panel{.title = title, .x_label = x_label, .log_x = true};
  panel.rows = {"rich, high", "rich, low", "poor, high", "poor, low"};
  int colour = 1;
  for (const char* method : {"rls", "aff", "greybox", "greybox_wrong", "greybox_finds"}) {
    Series series{method, {}, {}, Style::kDiscs, colour};
    for (const Table61Cell& cell : cells) {
      if (cell.noisy == noisy && std::string_view(cell.method) == method) {
        const double at = (cell.rich ? 0.0 : 2.0) + (cell.high ? 0.0 : 1.0) + 0.15 * (2.5 - colour);
        for (const double error : cell.*errors) {
          series.x.push_back(std::clamp(error, 1e-4, 1e4));
          series.y.push_back(at);
        }
      }
    }
    panel.series.push_back(std::move(series));
    ++colour;
  }
  panel.series.push_back({"bound of the grey box", {bound, bound}, {-0.5, 3.5}, Style::kDashed, 0});
  return panel;
}

/// The order of Table 6.1, from the median gain errors of least squares.
void add_order(const std::vector<Table61Cell>& cells, StudyResult& result) {
  const auto error = [&](bool rich, bool high) {
    const auto cell = std::ranges::find_if(cells, [&](const Table61Cell& one) {
      return std::string_view(one.method) == "rls" && !one.noisy && one.rich == rich && one.high == high;
    });
    return middle(cell->gain_error_dB);
  };
  const double good = error(true, false), acceptable = error(true, true), limited = error(false, false),
               worst = error(false, true);
  char note[96];
  std::snprintf(note, sizeof note, "good %.3g, acceptable %.3g, limited %.3g, worst %.3g dB", good, acceptable, limited,
                worst);
  result.measured.push_back({"6.1.rls.order.good_is_best", good / std::min({acceptable, limited, worst}), note});
  result.measured.push_back({"6.1.rls.order.acceptable_is_second", acceptable / std::min(limited, worst), note});
  result.measured.push_back({"6.1.rls.order.poor_high_is_worst", worst / std::max({good, acceptable, limited}), note});
}

Result<StudyResult> run_table(const StudyContext& context) {
  const auto made = FARRIER_TRY(thesis::table_6_1(context.seed));
  const std::vector<Table61Cell>& cells = made;
  StudyResult result;
  for (const Table61Cell& cell : cells) {
    const std::string id = std::string("6.1.") + cell.method + "." + cell_name(cell) + ".";
    const std::string_view method = cell.method;
    if (method == "rls" && !cell.noisy) {
      result.measured.push_back({id + "gain_error_dB", middle(cell.gain_error_dB), ""});
    }
    if (method == "greybox" && !cell.noisy) {
      result.measured.push_back(
          {id + "gain_error_dB", largest(cell.gain_error_dB), beside(cells, cell, &Table61Cell::gain_error_dB)});
      result.measured.push_back(
          {id + "phase_error_deg", largest(cell.phase_error_deg), beside(cells, cell, &Table61Cell::phase_error_deg)});
      result.measured.push_back(
          {id + "mass_error", largest(cell.mass_error), beside(cells, cell, &Table61Cell::mass_error)});
    }
    if ((method == "greybox_wrong" || method == "greybox_finds") && !cell.noisy) {
      result.measured.push_back({id + "mass_error", largest(cell.mass_error), ""});
    }
    if (method == "greybox" && cell.noisy) {
      result.measured.push_back(
          {id + "noisy_mass_error", largest(cell.mass_error), beside(cells, cell, &Table61Cell::mass_error)});
    }
  }
  add_order(cells, result);
  result.figures = every_cell(cells);
  result.pictures = {
      {"Errors 60 ms after each of three changes of load; what is beyond 10000, or none, is drawn there",
       2,
       {panel_of(cells, false, "gain, perfect sensors", "largest error (dB)", &Table61Cell::gain_error_dB, 2.0),
        panel_of(cells, true, "gain, rig's sensors", "largest error (dB)", &Table61Cell::gain_error_dB, 2.0),
        panel_of(cells, false, "mass, perfect sensors", "error over mass", &Table61Cell::mass_error, 0.1),
        panel_of(cells, true, "mass, rig's sensors", "error over mass", &Table61Cell::mass_error, 0.2)}}};
  return result;
}

constexpr Study kStudies[] = {
    {"T6.1", "Estimators by frequencies and amplitude of the valve's signal", kClaims, run_table,
     "Joint of Table A.1 through the loads of Fig. 6.1, judged 60 ms after each change. Least squares (rls, lambda "
     "0.85; aff, its "
     "own) starts from 10.5 kg. The grey box knows K_v, beta_e, p_s, V_pl and d_p of its joint; greybox_wrong is given "
     "K_v 20 % too "
     "large and beta_e 20 % too small; greybox_finds is given the same and estimates both. Sensors are perfect or "
     "those of fc1d.yaml. For least squares a claim takes the median of the "
     "three changes, for the grey box the largest."}};

}  // namespace
}  // namespace chapter6_table_studies

std::span<const Study> chapter6_table() { return chapter6_table_studies::kStudies; }

}  // namespace farrier::thesis
