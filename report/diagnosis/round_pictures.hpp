#pragma once

#include <string>
#include <vector>

#include "diagnosis/judge/judgement.hpp"
#include "report/page/draw_pictures.hpp"

namespace farrier::report {

/// Adds a picture per round of the selection that has candidates, with the gain of each and its interval. Returns their
/// paths.
std::vector<std::string> add_round_pictures(Drawing& drawing, const diagnosis::Judgement& judgement);

}  // namespace farrier::report
