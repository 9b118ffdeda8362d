#pragma once

#include <cstdint>

namespace farrier::bench {

/// Cost of one sample of recursive least squares with three measurements, against the thesis's own form.
struct RlsBench {
  double update_s;             ///< wall time per estimation::Rls<4>::update, [A, B] of three states and one input
  double update_bias_s;        ///< per Rls<5>::update: with a constant beside them
  double textbook_s;           ///< per textbook::TextbookRls<4>::update, (6.21) with 12 x 12 matrices
  double difference;           ///< largest of the two estimates of [A, B] in one run, over its largest entry
  std::int64_t allocations;    ///< of the updates of Rls, -1 when they were not counted
};

/// Runs `samples` (>= 1) of white, persistently exciting data through each, fifty times over in turn; the fastest
/// round counts. `allocations_so_far` reads the program's counter of allocations; null where there is none.
RlsBench bench_rls(int samples, std::int64_t (*allocations_so_far)() = nullptr);

}  // namespace farrier::bench
