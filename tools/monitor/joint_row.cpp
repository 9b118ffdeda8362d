#include "tools/monitor/joint_row.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "core/fault.hpp"
#include "core/text.hpp"
#include "monitor/poles_text.hpp"

namespace farrier::display {
namespace {

std::string digits(const char* format, double value) {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// Number and text of one cell.
struct Cell {
  double key = NAN;
  std::string text = "-";
};

Cell cell_of(Column column, const monitor::JointFrame& joint, const robot::Joint& of) {
  const bool heard = joint.newest.tick != kNoTick;
  switch (column) {
    case Column::kJoint:
      return {static_cast<double>(of.number), of.name};
    case Column::kState:
      if (heard && joint.newest.state <= signals::JointState::kTracking) {
        return {static_cast<double>(joint.newest.state), signals::to_string(joint.newest.state)};
      }
      break;
    case Column::kPhase:
      if (heard && known(joint.newest.phase)) {
        return {static_cast<double>(joint.newest.phase), signals::to_string(joint.newest.phase)};
      }
      break;
    case Column::kError:
      if (heard) {
        return {joint.force_error_rms, digits("%.3g", joint.force_error_rms) + (of.rotary ? " Nm" : " N")};
      }
      break;
    case Column::kNrmse:
      if (heard && joint.nrmse()) {
        return {*joint.nrmse(), digits("%.3f", *joint.nrmse())};
      }
      break;
    case Column::kMass:
      if (joint.mass_kg_or_kgm2) {
        return {*joint.mass_kg_or_kgm2, digits("%.3g", *joint.mass_kg_or_kgm2) + (of.rotary ? " kgm2" : " kg")};
      }
      break;
    case Column::kPoles:
      if (joint.estimate.tick != kNoTick) {
        return {std::abs(joint.poles[0]), monitor::poles_text(joint.poles)};
      }
      break;
    case Column::kGeneration:
      if (heard) {
        return {static_cast<double>(joint.newest.generation), std::to_string(joint.newest.generation)};
      }
      break;
    case Column::kRedesigns:
      return {static_cast<double>(joint.redesigns), std::to_string(joint.redesigns)};
    case Column::kRate:
      if (heard) {
        return {joint.rate_Hz, digits("%.0f", joint.rate_Hz)};
      }
      break;
    case Column::kMissed:
      if (heard) {
        return {static_cast<double>(joint.missed_ticks), std::to_string(joint.missed_ticks)};
      }
      break;
    case Column::kFaults:
      if (heard) {
        const std::string silent =
            joint.age_s > monitor::kSilent_s ? "silent for " + digits("%.0f", joint.age_s) + " s" : "";
        const std::string faults = to_string(FaultSet(joint.faults));
        return {static_cast<double>(std::popcount(joint.faults) + (silent.empty() ? 0 : 1)),
                silent + (silent.empty() || faults.empty() ? "" : ", ") + faults};
      }
      return {NAN, "not heard of"};
  }
  return {};
}

Tone tone_of(const monitor::JointFrame& joint) {
  if (joint.newest.tick == kNoTick) {
    return Tone::kFaint;
  }
  if (FaultSet(joint.faults).failed() || joint.age_s > monitor::kSilent_s) {
    return Tone::kBad;
  }
  const bool tracks = joint.newest.state == signals::JointState::kTracking;
  return joint.faults != 0 || !tracks ? Tone::kWarning : Tone::kPlain;
}

bool passes(const JointRow& row, const std::string& leg, const TableView& view) {
  if (view.only_faulty && (row.tone == Tone::kPlain || row.tone == Tone::kFaint)) {
    return false;
  }
  const auto cell = [&](Column column) { return row.cells[static_cast<std::size_t>(column)]; };
  const std::string all = lower(row.joint->name + '\n' + leg + '\n' + cell(Column::kState) + '\n' +
                                cell(Column::kPhase) + '\n' + cell(Column::kFaults));
  std::istringstream words(lower(view.filter));
  for (std::string word; words >> word;) {
    if (all.find(word) == std::string::npos) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string clean(text);
  std::ranges::replace_if(
      clean, [](char c) { return c < ' ' || c > '~'; }, '?');
  return clean;
}

std::vector<JointRow> joint_rows(const monitor::Frame& frame, const robot::Robot& robot, const TableView& view) {
  std::vector<JointRow> rows;
  for (const robot::Joint& joint : robot.joints) {
    const monitor::JointFrame& shown = frame.joints[joint.number];
    JointRow row{&joint, {}, {}, tone_of(shown)};
    for (int i = 0; i < kColumnCount; ++i) {
      Cell cell = cell_of(static_cast<Column>(i), shown, joint);
      row.keys[static_cast<std::size_t>(i)] = cell.key;
      row.cells[static_cast<std::size_t>(i)] = std::move(cell.text);
    }
    if (passes(row, robot.plan.legs[static_cast<std::size_t>(joint.leg)].name, view)) {
      rows.push_back(std::move(row));
    }
  }
  const auto column = static_cast<std::size_t>(view.sorted_by);
  std::ranges::stable_sort(rows, [&](const JointRow& x, const JointRow& y) {
    const double a = x.keys[column], b = y.keys[column];
    if (std::isnan(a) || std::isnan(b)) {
      return !std::isnan(a) && std::isnan(b);
    }
    return view.reversed ? a > b : a < b;
  });
  return rows;
}

}  // namespace farrier::display
