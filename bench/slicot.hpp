#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

extern "C" void sb02od_(const char* dico, const char* jobb, const char* fact, const char* uplo, const char* jobl,
                        const char* sort, const int* n, const int* m, const int* p, const double* a, const int* lda,
                        const double* b, const int* ldb, const double* q, const int* ldq, const double* r,
                        const int* ldr, const double* l, const int* ldl, double* rcond, double* x, const int* ldx,
                        double* alfar, double* alfai, double* beta, double* s, const int* lds, double* t,
                        const int* ldt, double* u, const int* ldu, const double* tol, int* iwork, double* dwork,
                        const int* ldwork, int* bwork, int* info, std::size_t, std::size_t, std::size_t, std::size_t,
                        std::size_t, std::size_t);

namespace farrier::bench {

/// Workspace of SB02OD for n states and m inputs.
constexpr std::size_t slicot_doubles(std::size_t n, std::size_t m) {
  const std::size_t pencil = 2 * n + m;
  return 6 * n + 2 * pencil * pencil + 4 * n * n + std::max({7 * (2 * n + 1) + 16, 16 * n, 3 * m});
}
constexpr std::size_t slicot_integers(std::size_t n, std::size_t m) { return 4 * n + m; }

/// Stabilising solution of the discrete algebraic Riccati equation (7.4) by SLICOT's SB02OD, into n x n `solution`.
/// Method: generalised Schur form of the extended pencil, which needs no inverse of R (Van Dooren 1981). Matrices are
/// stored by column; the cross weight `l` is n x m, or null for none. Returns false if SLICOT reports a failure.
inline bool solve_dare_by_slicot(int n, int m, const double* a, const double* b, const double* q, const double* r,
                                 const double* l, double* solution, std::span<double> doubles,
                                 std::span<int> integers) {
  const int two_n = 2 * n;
  const int pencil = two_n + m;
  const double tolerance = 0.0;  // SLICOT's own: the machine precision
  double rcond = 0.0;
  int info = 0;
  double* next = doubles.data();
  const auto take = [&next](int count) {
    double* taken = next;
    next += count;
    return taken;
  };
  double* alpha_real = take(two_n);
  double* alpha_imaginary = take(two_n);
  double* beta = take(two_n);
  double* s = take(pencil * pencil);
  double* t = take(pencil * pencil);
  double* u = take(two_n * two_n);
  const int work = static_cast<int>(doubles.data() + doubles.size() - next);
  sb02od_("D", "B", "N", "U", l != nullptr ? "N" : "Z", "S", &n, &m, &n, a, &n, b, &n, q, &n, r, &m,
          l != nullptr ? l : a, &n, &rcond, solution, &n, alpha_real, alpha_imaginary, beta, s, &pencil, t, &pencil, u,
          &two_n, &tolerance, integers.data(), next, &work, integers.data() + two_n + m, &info, 1, 1, 1, 1, 1, 1);
  return info == 0;
}

/// The same for one input, without a cross weight; allocates nothing.
template <int N>
bool solve_dare_by_slicot(const Eigen::Matrix<double, N, N>& a, const Eigen::Matrix<double, N, 1>& b,
                          const Eigen::Matrix<double, N, N>& q, double r, Eigen::Matrix<double, N, N>& solution) {
  std::array<double, slicot_doubles(N, 1)> doubles;
  std::array<int, slicot_integers(N, 1)> integers;
  return solve_dare_by_slicot(N, 1, a.data(), b.data(), q.data(), &r, nullptr, solution.data(), doubles, integers);
}

}  // namespace farrier::bench
