#include "control/numerics/riccati.hpp"

#include "control/numerics/riccati_solver.hpp"

namespace farrier::control {

const char* to_string(RiccatiStatus status) noexcept {
  switch (status) {
    case RiccatiStatus::kSolved: return "solved";
    case RiccatiStatus::kNotFinite: return "not finite";
    case RiccatiStatus::kWeightsNotDefinite: return "weights not definite";
    case RiccatiStatus::kNotStabilisable: return "not stabilisable";
    case RiccatiStatus::kNotConverged: return "not converged";
    case RiccatiStatus::kClosedLoopUnstable: return "closed loop unstable";
  }
  return "unknown";
}

#define FARRIER_INSTANTIATE(N, M)                                                                            \
  template Square<N> riccati_residual<N, M>(const Square<N>&, const Columns<N, M>&, const Square<N>&,          \
                                            const InputWeight<M>&, const Columns<N, M>&, const Square<N>&) noexcept; \
  template Result<RiccatiSolution<N, M>, RiccatiStatus> solve_dare<N, M>(                                      \
      const Square<N>&, const Columns<N, M>&, const Square<N>&, const InputWeight<M>&, const Columns<N, M>&) noexcept;
FARRIER_INSTANTIATE(3, 1)
FARRIER_INSTANTIATE(4, 1)
FARRIER_INSTANTIATE(5, 1)
FARRIER_INSTANTIATE(6, 1)
#undef FARRIER_INSTANTIATE

}  // namespace farrier::control
