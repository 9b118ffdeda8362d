#include "report/walk/supply_section.hpp"

#include <algorithm>
#include <array>

#include "core/number_as.hpp"
#include "report/figures/text_format.hpp"
#include "report/page/html_tables.hpp"
#include "world/energy_audit.hpp"

namespace farrier::report {
namespace supply_section_parts {
namespace {

constexpr double kPercentOf = 100.0;
constexpr double kMilliampere = 1000.0;  // of an ampere
constexpr double kKilojoule = 1000.0;    // joules
constexpr double kLegShown_s = 2.0;
constexpr double kNearLow = 1.1;  // the limit is drawn where the pressure comes near it
constexpr std::size_t kMostSupplyPoints = 2000;

/// A quantity of supply/state in the unit that people use.
struct Quantity {
  const char* name;
  double signals::SupplyState::*value;
  double unit;  ///< by which the value is multiplied
};
constexpr std::array kQuantities{
    Quantity{"pressure, bar", &signals::SupplyState::pressure_Pa, 1.0 / kPascalPerBar},
    Quantity{"flow of the pump, l/min", &signals::SupplyState::pump_flow_m3_s, kLitrePerMinute},
    Quantity{"drawn by the actuators, l/min", &signals::SupplyState::flow_m3_s, kLitrePerMinute},
    Quantity{"spilled by the relief valve, l/min", &signals::SupplyState::relief_flow_m3_s, kLitrePerMinute},
    Quantity{"leakage of shut valves, l/min", &signals::SupplyState::leakage_flow_m3_s, kLitrePerMinute},
    Quantity{"power of the pump, W", &signals::SupplyState::power_W, 1.0}};

std::string quantities_table(const WalkRun& run) {
  std::string html = "<table><thead><tr><th>supply</th><th>least</th><th>mean</th><th>largest</th></tr></thead>\n";
  for (const Quantity& quantity : kQuantities) {
    double least = run.supply.front().state.*quantity.value, largest = least, sum = 0.0;
    for (const trace::SupplyRow& row : run.supply) {
      least = std::min(least, row.state.*quantity.value);
      largest = std::max(largest, row.state.*quantity.value);
      sum += row.state.*quantity.value;
    }
    html += "<tr><td>" + std::string(quantity.name) + "</td>";
    for (const double value : {least, sum / static_cast<double>(run.supply.size()), largest}) {
      html += "<td class=\"number\">" + number_as("%.1f", quantity.unit * value) + "</td>";
    }
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

Series series_of(const WalkRun& run, const Quantity& quantity, const char* label, int colour) {
  Series series{.label = label, .colour = colour};
  const std::size_t step = std::max<std::size_t>(1, run.supply.size() / kMostSupplyPoints);
  for (std::size_t i = 0; i < run.supply.size(); i += step) {
    series.add(run.time_s(run.supply[i].state.tick), quantity.unit * (run.supply[i].state.*quantity.value));
  }
  return series;
}

Picture supply_picture(const WalkRun& run, const std::string& caption) {
  Panel pressure{.y_label = "pressure, bar", .series = {series_of(run, kQuantities[0], "supply", 1)}};
  const auto pressure_of = [](const trace::SupplyRow& row) { return row.state.pressure_Pa; };
  const double least_Pa = pressure_of(*std::ranges::min_element(run.supply, {}, pressure_of));
  if (run.robot.supply_guard && least_Pa < kNearLow * run.robot.supply_guard->low_Pa) {
    Series low{.label = "counts as low", .style = Style::kDashed, .colour = 5};
    for (const trace::SupplyRow* row : {&run.supply.front(), &run.supply.back()}) {
      low.add(run.time_s(row->state.tick), run.robot.supply_guard->low_Pa / kPascalPerBar);
    }
    pressure.series.push_back(low);
  }
  const Panel flows{
      .x_label = "time, s",
      .y_label = "flow, l/min",
      .series = {series_of(run, kQuantities[2], "actuators", 2), series_of(run, kQuantities[3], "relief", 4),
                 series_of(run, kQuantities[4], "leakage", 3), series_of(run, kQuantities[1], "pump", 0)}};
  return {.caption = caption, .panels = {pressure, flows}, .key = Key::kAbove, .stacked = true, .height_px = 560.0};
}

/// The account of a stretch of the run.
struct Account {
  std::string name;
  world::EnergyAudit audit;
};

/// The accounts of the whole run and, if the run has one, of the part that is judged.
std::vector<Account> accounts_of(const WalkRun& run) {
  const auto at = [](const trace::SupplyRow& row) { return world::audit_in(row.truth); };
  std::vector<Account> accounts{{"whole run", at(run.supply.back()) - at(run.supply.front())}};
  const auto settled = std::ranges::find_if(run.supply, [&](const trace::SupplyRow& row) {
    return run.time_s(row.state.tick) >= run.plan.walk_s + kWalkSettles_s;
  });
  if (settled != run.supply.end() && !run.figures.fell_s) {
    accounts.push_back({"trot, from " + number_as("%.0f", run.time_s(settled->state.tick)) + " s on",
                        at(run.supply.back()) - at(*settled)});
  }
  return accounts;
}

Panel energy_panel(const Account& account) {
  Panel panel{.title = account.name + ": " + number_as("%.1f", account.audit.pump_J / kKilojoule) + " kJ from the pump",
              .x_label = "% of the pump's work"};
  Series bars{.style = Style::kBars, .colour = 1};
  for (auto term = world::kEnergyTerms.rbegin(); term != world::kEnergyTerms.rend() - 1; ++term) {
    const double share = kPercentOf * (account.audit.*term->energy_J) / account.audit.pump_J;
    bars.add(share, static_cast<double>(panel.rows.size()));
    bars.low.push_back(share);
    bars.high.push_back(share);
    panel.rows.emplace_back(std::string(term->sentence) + ", " + number_as("%.1f", share) + " %");
  }
  panel.series = {bars};
  return panel;
}

std::string energy_table(const std::vector<Account>& accounts) {
  std::string html = "<table><thead><tr><th>energy</th>";
  for (const Account& account : accounts) {
    html += "<th>" + escape_html(account.name) + ", J</th><th>%</th>";
  }
  html += "</tr></thead>\n";
  const auto add = [&](const char* name, auto energy_J) {
    html += "<tr><td>" + std::string(name) + "</td>";
    for (const Account& account : accounts) {
      const double value_J = energy_J(account.audit);
      html += "<td class=\"number\">" + number_as("%.1f", value_J) + "</td><td class=\"number\">" +
              number_as("%.2f", kPercentOf * value_J / account.audit.pump_J) + "</td>";
    }
    html += "</tr>\n";
  };
  for (const world::EnergyTerm& term : world::kEnergyTerms) {
    add(term.sentence, [&term](const world::EnergyAudit& audit) { return audit.*term.energy_J; });
  }
  add("residual", [](const world::EnergyAudit& audit) { return audit.residual_J(); });
  return html + "</table>\n";
}

/// Pressures in the chambers of a joint's actuator, and that of the supply.
Panel chambers_panel(const WalkRun& run, const robot::Joint& joint, double from_s) {
  Series a{.label = "A", .colour = 1}, b{.label = "B", .colour = 2};
  Series supply{.label = "supply", .style = Style::kDashed, .colour = 5};
  for (const trace::TraceRow& row : run.shown_joints(kLegShown_s)) {
    if (row.joint == joint.number && run.time_s(row.tick) >= from_s) {
      a.add(run.time_s(row.tick), row.pressure_a_Pa / kPascalPerBar);
      b.add(run.time_s(row.tick), row.pressure_b_Pa / kPascalPerBar);
    }
  }
  for (const trace::SupplyRow& row : run.supply) {
    if (run.time_s(row.state.tick) >= from_s) {
      supply.add(run.time_s(row.state.tick), row.state.pressure_Pa / kPascalPerBar);
    }
  }
  return {.y_label = joint.name + ", bar", .series = {a, b, supply}};
}

Picture leg_picture(const WalkRun& run, int leg, double from_s, const std::string& caption) {
  Picture picture{.caption = caption, .key = Key::kAbove, .stacked = true, .height_px = 900.0};
  Panel currents{.x_label = "time, s", .y_label = "valve current, mA"};
  for (const robot::Joint& joint : run.robot.joints) {
    if (joint.leg != leg) {
      continue;
    }
    picture.panels.push_back(chambers_panel(run, joint, from_s));
    Series current{.label = joint.name, .colour = static_cast<int>(currents.series.size()) + 1};
    for (const trace::TraceRow& row : run.shown_joints(kLegShown_s)) {
      if (row.joint == joint.number && run.time_s(row.tick) >= from_s) {
        current.add(run.time_s(row.tick), kMilliampere * row.valve_current_A);
      }
    }
    currents.series.push_back(current);
  }
  picture.panels.push_back(currents);
  for (Panel& panel : picture.panels) {
    panel.x_range = Range{from_s, from_s + kLegShown_s};
  }
  return picture;
}

}  // namespace
}  // namespace supply_section_parts

std::string supply_section(Drawing& drawing, const WalkRun& run) {
  using namespace supply_section_parts;
  if (run.supply.empty()) {
    return "";
  }
  std::string html = "<h2>Supply</h2>\n" + quantities_table(run);
  const std::string supply = "pressure and flows of the supply over the whole run";
  html += image_html(drawing.add("supply", supply_picture(run, supply)), supply);

  const std::vector<Account> accounts = accounts_of(run);
  Picture bars{.caption = "where the work of the pump has gone", .columns = accounts.size(), .height_px = 380.0};
  for (const Account& account : accounts) {
    bars.panels.push_back(energy_panel(account));
  }
  html += "<h2>Energy</h2>\n" + image_html(drawing.add("energy", bars), bars.caption) + energy_table(accounts);

  html += "<h2>Actuators</h2>\n<p>The last " + number_as("%.0f", kLegShown_s) +
          " s: pressures in the chambers of each actuator, A extends it, and the currents of the valves. A leg opens "
          "with a "
          "click.</p>\n";
  const double from_s = run.shown_from_s(kLegShown_s);
  for (std::size_t leg = 0; leg < run.robot.plan.legs.size(); ++leg) {
    const std::string& name = run.robot.plan.legs[leg].name;
    const std::string caption = "chamber pressures and valve currents of leg " + name;
    html += std::string("<details") + (leg == 0 ? " open" : "") + "><summary>leg " + escape_html(name) +
            "</summary>\n" +
            image_html(drawing.add("leg_" + name, leg_picture(run, static_cast<int>(leg), from_s, caption)), caption) +
            "</details>\n";
  }
  return html;
}

}  // namespace farrier::report
