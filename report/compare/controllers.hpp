#pragma once

// Result of `farrier compare controllers`: every kind of controller on the same robots.

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "report/figures/figures.hpp"
#include "report/compare/vary_result.hpp"

namespace farrier::report {

/// Those that are compared; perfect knowledge is no controller.
inline constexpr std::array kControllers{Contender::kStance, Contender::kFeedbackLinearisation, Contender::kPid,
                                         Contender::kAdaptive, Contender::kGreyBox};

inline constexpr const char* kVariedTrot = "varied_trot";  ///< rows as compare varied has them
inline constexpr const char* kLoadSteps = "load_steps";    ///< a row per seed: the worse of the heavy quarters of
                                                           ///< Fig. 7.8 as stance, of the light ones as swing
inline constexpr double kGreyBoxRatioAtMost = 1.05;

/// Adds trot.controllers.<controller>.<test>.*: every one of kControllers has rows.
void add_controllers(Figures& figures, std::string_view test, std::span<const VaryRow> rows);

/// For people: a line per controller.
std::string controllers_text(std::string_view test, std::span<const VaryRow> rows);

}  // namespace farrier::report
