#include "tests/support/dense_solvers.hpp"

#include <algorithm>
#include <complex>
#include <vector>

#include "core/ensure.hpp"

// LAPACK as Debian's liblapack has it. Arguments: LAPACK Users' Guide (Anderson and others, 1999).
extern "C" {
void dgeev_(const char* left, const char* right, const int* n, double* a, const int* lda, double* re, double* im,
            double* vl, const int* ldvl, double* vr, const int* ldvr, double* work, const int* lwork, int* info);
void dsyev_(const char* vectors, const char* triangle, const int* n, double* a, const int* lda, double* w, double* work,
            const int* lwork, int* info);
void zgesvd_(const char* u_wanted, const char* vt_wanted, const int* m, const int* n, std::complex<double>* a,
             const int* lda, double* s, std::complex<double>* u, const int* ldu, std::complex<double>* vt,
             const int* ldvt, std::complex<double>* work, const int* lwork, double* rwork, int* info);
void dgesv_(const int* n, const int* columns, double* a, const int* lda, int* pivots, double* b, const int* ldb,
            int* info);
void zgesv_(const int* n, const int* columns, std::complex<double>* a, const int* lda, int* pivots,
            std::complex<double>* b, const int* ldb, int* info);
}

namespace farrier::test {
namespace {

constexpr int kWorkPerRow = 64;  // more than the largest of what the calls below ask for at the least

void ensure_solved(int info) { FARRIER_ENSURE(info == 0, "LAPACK solves it"); }

}  // namespace

Eigen::VectorXcd eigenvalues(const Eigen::MatrixXd& m) {
  Eigen::MatrixXd a = m;
  const int n = static_cast<int>(m.rows());
  const int work_size = kWorkPerRow * n;
  const int one = 1;
  Eigen::VectorXd re(n);
  Eigen::VectorXd im(n);
  std::vector<double> work(work_size);
  int info = 0;
  dgeev_("N", "N", &n, a.data(), &n, re.data(), im.data(), nullptr, &one, nullptr, &one, work.data(), &work_size, &info);
  ensure_solved(info);
  Eigen::VectorXcd values(n);
  for (int i = 0; i < n; ++i) {
    values(i) = {re(i), im(i)};
  }
  return values;
}

Eigen::VectorXd symmetric_eigenvalues(const Eigen::MatrixXd& m) {
  Eigen::MatrixXd a = m;
  const int n = static_cast<int>(m.rows());
  const int work_size = kWorkPerRow * n;
  Eigen::VectorXd values(n);
  std::vector<double> work(work_size);
  int info = 0;
  dsyev_("N", "L", &n, a.data(), &n, values.data(), work.data(), &work_size, &info);
  ensure_solved(info);
  return values;
}

Eigen::VectorXd singular_values(const Eigen::MatrixXcd& m) {
  Eigen::MatrixXcd a = m;
  const int rows = static_cast<int>(m.rows());
  const int columns = static_cast<int>(m.cols());
  const int work_size = kWorkPerRow * (rows + columns);
  const int one = 1;
  Eigen::VectorXd values(std::min(rows, columns));
  std::vector<std::complex<double>> work(work_size);
  std::vector<double> real_work(work_size);
  int info = 0;
  zgesvd_("N", "N", &rows, &columns, a.data(), &rows, values.data(), nullptr, &one, nullptr, &one, work.data(), &work_size,
          real_work.data(), &info);
  ensure_solved(info);
  return values;
}

Eigen::MatrixXd inverse(const Eigen::MatrixXd& m) {
  Eigen::MatrixXd a = m;
  const int n = static_cast<int>(m.rows());
  Eigen::MatrixXd x = Eigen::MatrixXd::Identity(n, n);
  std::vector<int> pivots(n);
  int info = 0;
  dgesv_(&n, &n, a.data(), &n, pivots.data(), x.data(), &n, &info);
  ensure_solved(info);
  return x;
}

Eigen::VectorXcd solve(const Eigen::MatrixXcd& m, const Eigen::VectorXcd& b) {
  Eigen::MatrixXcd a = m;
  const int n = static_cast<int>(m.rows());
  const int one = 1;
  Eigen::VectorXcd x = b;
  std::vector<int> pivots(n);
  int info = 0;
  zgesv_(&n, &one, a.data(), &n, pivots.data(), x.data(), &n, &info);
  ensure_solved(info);
  return x;
}

}  // namespace farrier::test
