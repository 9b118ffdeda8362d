#pragma once

#include <span>
#include <string>

#include "thesis/report/claims.hpp"

namespace farrier::thesis {

/// Where picture `index` of a study goes, from the report's folder: "pictures/7.8_1.svg".
std::string picture_path(const thesis::Study& study, std::size_t index);

/// Draws every picture of the studies that ran. Refuses as report::Drawing::draw does.
Result<Done> draw_studies(const std::string& out_dir, std::span<const StudyRun> runs);

}  // namespace farrier::thesis
