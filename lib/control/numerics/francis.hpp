#pragma once

#include <Eigen/Core>

#include <complex>

namespace farrier::control {

/// Eigenvalues of a real matrix of N = 2..6 rows by Householder's reduction to Hessenberg form and Francis's implicit
/// double shifts (Francis 1961; Golub and Van Loan 2013, algorithms 7.4.2 and 7.5.1) with the exceptional shifts of
/// Wilkinson and Reinsch (1971). Of the same accuracy as a general decomposition, in a fraction of its time: a few
/// rounding errors of the matrix's norm. Complex ones come in conjugate pairs. At most 30 shifts per eigenvalue.
/// False, and `z` says nothing, when they do not suffice or an entry is not finite.
template <int N>
bool francis_eigenvalues(const Eigen::Matrix<double, N, N>& m, Eigen::Matrix<std::complex<double>, N, 1>& z) noexcept;

}  // namespace farrier::control
