// A build without MuJoCo.
#include "bench/command/body_part.hpp"

namespace farrier::cli {

bool has_body_part() noexcept { return false; }

Result<Done> measure_body(const robot::Robot&, report::Figures&) {
  return Error{
      "this build is without robots as rigid bodies: install the packages of deploy/packages/body.txt, and build "
      "again"};
}

}  // namespace farrier::cli
