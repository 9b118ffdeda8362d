#pragma once

#include <vector>

#include "report/figures/figures.hpp"
#include "trials/blind/blind_trials.hpp"

namespace farrier::cli {

/// Adds what blind trials say of the diagnosis, with its bounds for joints of oil or electric ones.
void add_benchmark_figures(report::Figures& figures, const std::vector<blind::Outcome>& outcomes, bool electric);

/// Adds what trials of healthy robots of `joints` joints say, the trials in the order of the robots.
void add_healthy_figures(report::Figures& figures, const std::vector<blind::Outcome>& outcomes, std::size_t joints);

}  // namespace farrier::cli
