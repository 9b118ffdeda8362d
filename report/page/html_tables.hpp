#pragma once

#include <string>
#include <string_view>

#include "report/figures/outcome.hpp"

namespace farrier::report {

/// Text as HTML shows it: & < > " ' escaped.
std::string escape_html(std::string_view text);

/// A picture as it stands in a page, on a line of its own; `what` is its text for those who do not see it. Empty without
/// a path.
std::string image_html(std::string_view path, std::string_view what);

/// The same as a figure, with the text below it.
std::string captioned_image_html(std::string_view path, std::string_view caption);

/// One row per joint: its figures, those that fail marked.
std::string joint_table_html(const Figures& figures);

/// Every figure but the packet counts, with unit and bound.
std::string figures_table_html(const Figures& figures);

/// One row per decision about gains, with a heading; nothing when there are none.
std::string decisions_html(const RunInfo& run);

/// One row per process, with the samples of each topic.
std::string processes_table_html(const RunInfo& run);

/// Version, revision, seed, hash, machine.
std::string run_table_html(const RunInfo& run);

}  // namespace farrier::report
