#pragma once

#include <span>
#include <string>

#include "thesis/report/claims.hpp"

namespace farrier::thesis {

/// Where picture `index` of a study goes, from the report's folder: "pictures/7.8_1.svg".
std::string picture_path(const thesis::Study& study, std::size_t index);

/// Draws every picture of the studies that ran, with one gnuplot process, into out_dir/pictures; the data and the script
/// stay in out_dir/data. Refuses when gnuplot is missing or fails, or the disk does not take the files.
Result<Done> draw_studies(const std::string& out_dir, std::span<const StudyRun> runs);

}  // namespace farrier::thesis
