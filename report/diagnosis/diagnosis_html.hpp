#pragma once

// Parts of the pages of diagnoses. Texts are plain: characters that HTML needs escaped are escaped here.

#include <span>
#include <string>
#include <vector>

#include "report/diagnosis/diagnosis_result.hpp"

namespace farrier::report {

std::string paragraph(const std::string& text);

/// A list; nothing for no items.
std::string list(const std::vector<std::string>& items);

/// A cell of a table, set as numbers are.
std::string number_cell(const std::string& text);

/// The effects with their parameters; nothing for none.
std::string effects_html(std::span<const ShownEffect> effects);

/// Caption of round_picture() for a round, counted from 0.
std::string round_caption(std::size_t round);

}  // namespace farrier::report
