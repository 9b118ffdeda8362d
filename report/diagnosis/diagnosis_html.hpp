#pragma once

// Pieces of which pages of diagnoses are made. Texts are plain: what HTML needs escaped is escaped here.

#include <span>
#include <string>
#include <vector>

#include "report/diagnosis/diagnosis_result.hpp"

namespace farrier::report {

std::string paragraph(const std::string& text);

/// A list; nothing for no items.
std::string list(const std::vector<std::string>& items);

/// A picture with what it shows below; nothing for no path.
std::string picture(const std::string& path, const std::string& what);

/// A cell of a table, set as numbers are.
std::string number_cell(const std::string& text);

/// The effects with their parameters; nothing for none.
std::string effects_html(std::span<const ShownEffect> effects);

/// What round_picture() shows of a round, counted from 0.
std::string round_caption(std::size_t round);

}  // namespace farrier::report
