#pragma once

#include <cstddef>
#include <functional>

#include "diagnosis/judge/judgement.hpp"

namespace farrier::diagnosis {

/// Work by `threads` >= 1, each taking the next piece. `progress` gets the share that is done of `rounds` calls of as
/// many pieces, from the calling thread.
ForEach by_threads(int threads, const std::function<void(double)>& progress, std::size_t rounds);

}  // namespace farrier::diagnosis
