#pragma once

#if FARRIER_HAVE_SLICOT

#include <Eigen/Core>

#include <array>
#include <cstddef>

extern "C" void sb02od_(const char* dico, const char* jobb, const char* fact, const char* uplo, const char* jobl,
                        const char* sort, const int* n, const int* m, const int* p, const double* a, const int* lda,
                        const double* b, const int* ldb, const double* q, const int* ldq, const double* r,
                        const int* ldr, const double* l, const int* ldl, double* rcond, double* x, const int* ldx,
                        double* alfar, double* alfai, double* beta, double* s, const int* lds, double* t,
                        const int* ldt, double* u, const int* ldu, const double* tol, int* iwork, double* dwork,
                        const int* ldwork, int* bwork, int* info, std::size_t, std::size_t, std::size_t, std::size_t,
                        std::size_t, std::size_t);

namespace farrier::lab {

/// Stabilising solution of the discrete algebraic Riccati equation by SLICOT's SB02OD (Van Dooren 1981: generalised
/// Schur form of the extended pencil), one input, no cross weight. False when SLICOT reports a failure.
template <int N>
bool solve_dare_by_slicot(const Eigen::Matrix<double, N, N>& a, const Eigen::Matrix<double, N, 1>& b,
                          const Eigen::Matrix<double, N, N>& q, double r, Eigen::Matrix<double, N, N>& solution) {
  constexpr int kPencil = 2 * N + 1;
  constexpr int kWork = 7 * kPencil + 16 > 16 * N ? 7 * kPencil + 16 : 16 * N;
  const int n = N;
  const int m = 1;
  const int two_n = 2 * N;
  const int work = kWork;
  const int pencil = kPencil;
  const double tolerance = 0.0;  // SLICOT's own: the machine precision
  double rcond = 0.0;
  int info = 0;
  std::array<double, 2 * N> alpha_real;
  std::array<double, 2 * N> alpha_imaginary;
  std::array<double, 2 * N> beta;
  std::array<double, kPencil * kPencil> s;
  std::array<double, kPencil * kPencil> t;
  std::array<double, 4 * N * N> u;
  std::array<double, kWork> dwork;
  std::array<int, 2 * N> iwork;
  std::array<int, 2 * N> bwork;
  const double l = 0.0;
  sb02od_("D", "B", "N", "U", "Z", "S", &n, &m, &n, a.data(), &n, b.data(), &n, q.data(), &n, &r, &m, &l, &n, &rcond,
          solution.data(), &n, alpha_real.data(), alpha_imaginary.data(), beta.data(), s.data(), &pencil, t.data(),
          &pencil, u.data(), &two_n, &tolerance, iwork.data(), dwork.data(), &work, bwork.data(), &info, 1, 1, 1, 1, 1,
          1);
  return info == 0;
}

}  // namespace farrier::lab

#endif
