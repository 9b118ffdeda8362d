#include "trace/force_error.hpp"

#include <cmath>

namespace farrier::trace {

double relative_error(std::span<const TraceRow> rows, Tick from, Tick to) noexcept {
  double errors = 0.0;
  double references = 0.0;
  for (const TraceRow& row : rows) {
    if (row.tick >= from && row.tick < to) {
      const double error = row.force_reference_N_or_Nm - row.force_N_or_Nm;
      errors += error * error;
      references += row.force_reference_N_or_Nm * row.force_reference_N_or_Nm;
    }
  }
  return std::sqrt(errors / references);
}

}  // namespace farrier::trace
