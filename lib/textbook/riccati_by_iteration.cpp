#include "control/numerics/riccati.hpp"

#include "control/numerics/riccati_solver.hpp"
#include "control/numerics/sizes.hpp"

namespace farrier::control {

template <int N>
Result<RiccatiSolution<N>, RiccatiStatus> solve_dare_by_iteration(const Square<N>& a, const Columns<N, 1>& b,
                                                                  const Square<N>& q, double r, const Columns<N, 1>& n,
                                                                  int max_iterations,
                                                                  double relative_tolerance) noexcept {
  const Problem<N, 1> p{a, b, q, r, n};
  if (!is_finite<N, 1>(p)) {
    return RiccatiStatus::kNotFinite;
  }
  if (!has_definite_weights<N, 1>(p)) {
    return RiccatiStatus::kWeightsNotDefinite;
  }
  Square<N> s = symmetric_part<N>(q) - n * n.transpose() / r;  // (8.2)
  for (int i = 1; i <= max_iterations; ++i) {
    const Square<N> residual = residual_of<N, 1>(p, s);
    const double relative = relative_norm<N>(residual, s);
    if (!std::isfinite(relative)) {
      break;
    }
    if (relative <= relative_tolerance) {
      return judge<N, 1>(p, s, i, relative);
    }
    s += symmetric_part<N>(residual);  // (8.1)
  }
  return name_failure<N, 1>(p, RiccatiStatus::kNotConverged);
}

#define FARRIER_INSTANTIATE(N)                                                   \
  template Result<RiccatiSolution<N>, RiccatiStatus> solve_dare_by_iteration<N>( \
      const Square<N>&, const Columns<N, 1>&, const Square<N>&, double, const Columns<N, 1>&, int, double) noexcept;
FARRIER_FOR_EACH_SIZE(FARRIER_INSTANTIATE)
#undef FARRIER_INSTANTIATE

}  // namespace farrier::control
