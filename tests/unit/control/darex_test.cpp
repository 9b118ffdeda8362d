// DAREX, SLICOT's benchmark collection for discrete-time algebraic Riccati equations (Abels and Benner 1999, SLICOT
// Working Note 1999-16): solved to 1e-10 or refused by name; examples that read a data file are left out.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "control/numerics/riccati.hpp"
#include "bench/slicot.hpp"
#include "tests/support/dense_solvers.hpp"

extern "C" void bb02ad_(const char* def, const int* nr, double* dpar, int* ipar, const int* bpar, char* chpar, int* vec,
                        int* n, int* m, int* p, double* a, const int* lda, double* b, const int* ldb, double* c,
                        const int* ldc, double* q, const int* ldq, double* r, const int* ldr, double* s, const int* lds,
                        double* x, const int* ldx, double* dwork, const int* ldwork, int* info, std::size_t,
                        std::size_t);

namespace farrier::control {
namespace darex_test {

constexpr double kResidual = 1e-10;

template <int N>
using Square = Eigen::Matrix<double, N, N>;
template <int N>
using Column = Eigen::Matrix<double, N, 1>;

TEST(Darex, Example13HasItsPublishedSolution) {
  Eigen::Matrix2d a, q, x;
  a << 0.0, 1.0, 0.0, 0.0;
  q << 1.0, 2.0, 2.0, 4.0;
  x << 1.0, 2.0, 2.0, 2.0 + std::sqrt(5.0);
  const auto solution = solve_dare<2>(a, Eigen::Vector2d(0.0, 1.0), q, 1.0, Eigen::Vector2d::Zero());
  ASSERT_TRUE(solution.ok()) << to_string(solution.error());
  EXPECT_LE(solution.value().relative_residual, kResidual);
  EXPECT_LE((solution.value().s - x).norm(), kResidual * x.norm());
}

TEST(Darex, Example23HasItsPublishedSolutionAtEveryScale) {
  for (const double epsilon : {1.0, 1e2, 1e4, 1e6}) {
    Eigen::Matrix2d a = Eigen::Matrix2d::Zero();
    a(0, 1) = epsilon;
    const auto solution =
        solve_dare<2>(a, Eigen::Vector2d(0.0, 1.0), Eigen::Matrix2d::Identity(), 1.0, Eigen::Vector2d::Zero());
    ASSERT_TRUE(solution.ok()) << epsilon << ": " << to_string(solution.error());
    EXPECT_LE(solution.value().relative_residual, kResidual);
    const Eigen::Matrix2d x = Eigen::Vector2d(1.0, 1.0 + epsilon * epsilon).asDiagonal();
    EXPECT_LE((solution.value().s - x).norm(), kResidual * x.norm()) << epsilon;
  }
}

template <int N>
void expect_example_41() {
  Square<N> a = Square<N>::Zero();
  Square<N> x = Square<N>::Zero();
  for (int i = 0; i < N; ++i) {
    x(i, i) = i + 1.0;
    if (i > 0) {
      a(i - 1, i) = 1.0;
    }
  }
  const auto solution = solve_dare<N>(a, Column<N>::Unit(N - 1), Square<N>::Identity(), 1.0, Column<N>::Zero());
  ASSERT_TRUE(solution.ok()) << N << ": " << to_string(solution.error());
  EXPECT_LE(solution.value().relative_residual, kResidual) << N;
  EXPECT_LE((solution.value().s - x).norm(), kResidual * x.norm()) << N;
}

TEST(Darex, Example41HasItsPublishedSolutionForEverySizeServed) {
  expect_example_41<2>();
  expect_example_41<3>();
  expect_example_41<4>();
  expect_example_41<5>();
  expect_example_41<6>();
}

TEST(Darex, Example11HasNoWeightOnItsInputAndIsRefusedByName) {
  Eigen::Matrix2d a, q;
  a << 2.0, -1.0, 1.0, 0.0;
  q << 0.0, 0.0, 0.0, 1.0;
  const auto solution = solve_dare<2>(a, Eigen::Vector2d(1.0, 0.0), q, 0.0, Eigen::Vector2d::Zero());
  ASSERT_FALSE(solution.ok());
  EXPECT_EQ(solution.error(), RiccatiStatus::kWeightsNotDefinite);
}

constexpr int kMost = 100;  // states of the largest example
using Eigen::MatrixXd;

struct Example {
  int n = 0, m = 0, info = 0;
  MatrixXd a, b, q, r, s, x;
  bool has_solution = false;
};

Example darex(int group, int number) {
  Example e;
  const std::array all{&e.a, &e.b, &e.q, &e.r, &e.s, &e.x};
  for (MatrixXd* matrix : all) {
    *matrix = MatrixXd::Zero(kMost, kMost);
  }
  MatrixXd c(kMost, kMost), work(kMost, kMost);
  const std::array<int, 2> nr{group, number};
  std::array<double, 4> dpar{};
  std::array<int, 3> ipar{};
  const std::array<int, 7> bpar{1, 1, 1, 0, 1, 1, 1};  // Q, B, R and S, all in full
  std::array<char, 255> text{};
  std::array<int, 10> vec{};
  const int most = kMost;
  const int size = kMost * kMost;
  int p = 0;
  bb02ad_("D", nr.data(), dpar.data(), ipar.data(), bpar.data(), text.data(), vec.data(), &e.n, &e.m, &p, e.a.data(),
          &most, e.b.data(), &most, c.data(), &most, e.q.data(), &most, e.r.data(), &most, e.s.data(), &most,
          e.x.data(), &most, work.data(), &size, &e.info, 1, text.size());
  e.has_solution = vec[9] != 0;
  const std::array<std::pair<int, int>, 6> shapes{
      {{e.n, e.n}, {e.n, e.m}, {e.n, e.n}, {e.m, e.m}, {e.n, e.m}, {e.n, e.n}}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    *all[i] = all[i]->topLeftCorner(shapes[i].first, shapes[i].second).eval();
  }
  return e;
}

constexpr double kPublished = 1e-6;  // of the published solution; some are ill-conditioned on purpose

// The examples that need no data file. Refused are those whose R is singular: 1.1 has R = 0, 1.2 and 1.4 an R of rank
// one for two inputs, and (8.5) asks for R > 0.
struct Expected {
  int group, number;
  bool solved;
};
constexpr std::array<Expected, 12> kExpected{{{1, 1, false},
                                              {1, 2, false},
                                              {1, 3, true},
                                              {1, 4, false},
                                              {1, 9, true},
                                              {1, 12, true},
                                              {2, 1, true},
                                              {2, 2, true},
                                              {2, 3, true},
                                              {2, 4, true},
                                              {2, 5, true},
                                              {4, 1, true}}};

TEST(Darex, EveryExampleWithoutADataFileIsSolvedOrRefusedByName) {
  constexpr std::array<std::pair<int, int>, 3> kGroups{{{1, 13}, {2, 5}, {4, 1}}};
  std::size_t seen = 0;
  for (const auto& [group, examples] : kGroups) {
    for (int number = 1; number <= examples; ++number) {
      const Example e = darex(group, number);
      if (e.info != 0) {
        continue;  // reads a data file
      }
      ASSERT_LT(seen, kExpected.size());
      const Expected& expected = kExpected[seen++];
      ASSERT_TRUE(expected.group == group && expected.number == number) << group << "." << number;
      const auto solution = solve_dare<Eigen::Dynamic, Eigen::Dynamic>(e.a, e.b, e.q, e.r, e.s);
      std::printf("  DAREX %d.%d, %d states, %d inputs: ", group, number, e.n, e.m);
      EXPECT_EQ(solution.ok(), expected.solved) << group << "." << number;
      if (!solution) {
        std::printf("%s\n", to_string(solution.error()));
        EXPECT_EQ(solution.error(), RiccatiStatus::kWeightsNotDefinite) << group << "." << number;
        EXPECT_LE(test::singular_values(e.r)(e.m - 1), kResidual) << group << "." << number;
        continue;
      }
      std::printf("solved, residual %.1e\n", solution.value().relative_residual);
      EXPECT_LE(solution.value().relative_residual, kResidual) << group << "." << number;
      EXPECT_LT(solution.value().radius_bound, 1.0) << group << "." << number;
      if (e.has_solution) {
        EXPECT_LE((solution.value().s - e.x).norm(), kPublished * e.x.norm()) << group << "." << number;
      }
    }
  }
  EXPECT_EQ(seen, kExpected.size());
}

}  // namespace darex_test
}  // namespace farrier::control
