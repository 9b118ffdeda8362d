#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "report/figures/figures.hpp"
#include "report/figures/run_info.hpp"

namespace farrier::report {

/// Four significant digits; whole numbers in full up to 15 digits; "-" for what is not finite.
std::string short_number(double value);

/// "310 us"; just the number where the unit is "1".
std::string value_with_unit(const Figure& figure);

/// "<= 0.1"; empty without a bound.
std::string bound_text(const Figure& figure);

/// Joints with tracking figures, in the order they were added.
std::vector<std::string> joints_of(const Figures& figures);

/// "trot.lf_kfe.stance_nrmse 0.143, must be <= 0.1" for every figure that does not hold, then the outcome's failures.
std::vector<std::string> reasons_to_fail(const Figures& figures, const std::vector<std::string>& failures);

/// "joint/sensors 24000 out", "joint/sensors 24000 in", "joint/sensors 24000 in (3 lost)".
std::vector<std::string> topic_texts(const ProcessInfo& process);

/// Rows of cells in columns as wide as their longest cell, all flush left, two spaces apart, each line behind `indent`.
std::string aligned(const std::vector<std::vector<std::string>>& rows, const std::string& indent = "");

}  // namespace farrier::report
