#pragma once

// Result of `farrier compare body`.

#include <span>
#include <string>

#include "report/figures/figures.hpp"
#include "trials/body/body_contenders.hpp"

namespace farrier::report {

/// Force error of the file's design over that of perfect knowledge, at most, of every place and phase.
inline constexpr double kKnowledgeRatioAtMost = 1.3;

/// Adds compare.body.*. The ratios have their bound if the results have the file's design and perfect knowledge.
void add_contenders(Figures& figures, std::span<const trials::ContenderResult> results);

/// For people: a line for each contender.
std::string contenders_text(std::span<const trials::ContenderResult> results);

}  // namespace farrier::report
