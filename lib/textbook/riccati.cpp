#include "control/numerics/riccati.hpp"

#include "control/numerics/riccati_solver.hpp"
#include "textbook/spectrum.hpp"

namespace farrier::control {

template <>
struct riccati::Analysis<Eigen::Dynamic> {
  static double spectral_radius(const Eigen::MatrixXd& m) { return any_size::spectral_radius(m); }
  static double stabilisability(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
    return any_size::stabilisability(a, b);
  }
};

template Square<2> riccati_residual<2, 1>(const Square<2>&, const Columns<2, 1>&, const Square<2>&,
                                          const InputWeight<1>&, const Columns<2, 1>&, const Square<2>&) noexcept;
template Result<RiccatiSolution<2, 1>, RiccatiStatus> solve_dare<2, 1>(const Square<2>&, const Columns<2, 1>&,
                                                                      const Square<2>&, const InputWeight<1>&,
                                                                      const Columns<2, 1>&) noexcept;

template Eigen::MatrixXd riccati_residual<Eigen::Dynamic, Eigen::Dynamic>(
    const Eigen::MatrixXd&, const Eigen::MatrixXd&, const Eigen::MatrixXd&, const Eigen::MatrixXd&,
    const Eigen::MatrixXd&, const Eigen::MatrixXd&) noexcept;
template Result<RiccatiSolution<Eigen::Dynamic, Eigen::Dynamic>, RiccatiStatus>
solve_dare<Eigen::Dynamic, Eigen::Dynamic>(const Eigen::MatrixXd&, const Eigen::MatrixXd&, const Eigen::MatrixXd&,
                                           const Eigen::MatrixXd&, const Eigen::MatrixXd&) noexcept;

}  // namespace farrier::control
