#pragma once

#include <Eigen/Core>

#include <complex>

namespace farrier::control {

/// Eigenvalues of a real matrix of N = 2..6 rows. Method: Householder's reduction to Hessenberg form and Francis's
/// implicit double shifts (Francis 1961; Golub and Van Loan 2013, algorithms 7.4.2 and 7.5.1) with the exceptional
/// shifts of Wilkinson and Reinsch (1971). The accuracy is that of a general decomposition, a few rounding errors of
/// the matrix's norm, in a fraction of its time. Complex eigenvalues come in conjugate pairs. At most 30 shifts per
/// eigenvalue. Returns false, with `z` undefined, if they do not suffice or an entry is not finite.
template <int N>
bool francis_eigenvalues(const Eigen::Matrix<double, N, N>& m, Eigen::Matrix<std::complex<double>, N, 1>& z) noexcept;

}  // namespace farrier::control
