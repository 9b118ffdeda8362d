#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "estimation/poles.hpp"
#include "estimation/stable_map.hpp"
#include "data.hpp"
#include "tests/support/allocation_guard.hpp"
#include "tests/support/dense_solvers.hpp"

namespace farrier::estimation {
namespace stable_map_test {

using testing::normal;
using Complex = std::complex<double>;

constexpr double kLimit = 0.999;
constexpr double kTolerance = 1e-9;  // what map_to_stable promises

/// Real matrix with the eigenvalues r e^(+-i angle) and `real`, in a basis without special directions.
Eigen::Matrix3d with_pair(double modulus, double angle, double real) {
  Eigen::Matrix3d blocks = Eigen::Matrix3d::Zero();
  blocks.topLeftCorner<2, 2>() << modulus * std::cos(angle), -modulus * std::sin(angle), modulus * std::sin(angle),
      modulus * std::cos(angle);
  blocks(2, 2) = real;
  Eigen::Matrix3d basis;
  basis << 1.0, 0.3, -0.2, 0.1, 1.0, 0.4, -0.5, 0.2, 1.0;
  return basis * blocks * basis.inverse();
}

TEST(StableMap, LeavesAStableMatrixAlone) {
  Eigen::Matrix3d a = with_pair(0.95, 0.4, 0.9);
  const Eigen::Matrix3d before = a;
  EXPECT_EQ(map_to_stable<3>(a, kLimit), StabilityStatus::kStable);
  EXPECT_EQ(a, before);
}

TEST(StableMap, PutsOnlyTheUnstableEigenvaluesOnTheLimit) {
  Eigen::Matrix3d pair = with_pair(1.3, 0.4, 0.7);
  EXPECT_EQ(map_to_stable<3>(pair, kLimit), StabilityStatus::kMappedToStable);
  EXPECT_LT((pair - with_pair(kLimit, 0.4, 0.7)).norm(), kTolerance) << "angle, eigenvectors and the real pole stay";

  Eigen::Matrix3d real = with_pair(0.8, 1.1, -1.2);
  EXPECT_EQ(map_to_stable<3>(real, kLimit), StabilityStatus::kMappedToStable);
  EXPECT_LT((real - with_pair(0.8, 1.1, -kLimit)).norm(), kTolerance);

  Eigen::Matrix3d all = with_pair(2.0, 2.0, 1.0);
  EXPECT_EQ(map_to_stable<3>(all, kLimit), StabilityStatus::kMappedToStable);
  EXPECT_LT((all - with_pair(kLimit, 2.0, kLimit)).norm(), kTolerance);
}

TEST(StableMap, KeepsTheEigenvectors) {
  Eigen::Matrix2d a;
  a << 1.2, 0.5, 0.1, 0.4;
  const Eigen::Matrix2d before = a;
  ASSERT_EQ(map_to_stable<2>(a, kLimit), StabilityStatus::kMappedToStable);
  EXPECT_LT((a * before - before * a).norm(), kTolerance) << "matrices with the same eigenvectors commute";
}

template <int N>
void expect_all_stable() {
  int mapped = 0;
  for (int k = 0; k < 3000; ++k) {
    Eigen::Matrix<double, N, N> a = normal<N, N>(1, "a", k);
    const Eigen::Matrix<double, N, N> before = a;
    const StabilityStatus status = map_to_stable<N>(a, kLimit);
    ASSERT_NE(status, StabilityStatus::kNotYetSet);
    ASSERT_NE(status, StabilityStatus::kEigenvalueError) << before;
    EXPECT_LE(test::eigenvalues(a).cwiseAbs().maxCoeff(), kLimit + kTolerance) << before;
    EXPECT_EQ(status == StabilityStatus::kStable, std::abs(poles(before)[0]) <= kLimit);
    mapped += status == StabilityStatus::kMappedToStable ? 1 : 0;
  }
  EXPECT_GT(mapped, 1000);
}

TEST(StableMap, MakesEveryMatrixWithEigenvectorsStable) {
  expect_all_stable<2>();
  expect_all_stable<3>();
}

TEST(StableMap, MapsARepeatedEigenvalueThatHasItsEigenvectors) {
  Eigen::Matrix3d a = 1.5 * Eigen::Matrix3d::Identity();
  EXPECT_EQ(map_to_stable<3>(a, kLimit), StabilityStatus::kMappedToStable);
  EXPECT_LT((a - kLimit * Eigen::Matrix3d::Identity()).norm(), kTolerance);
}

TEST(StableMap, RefusesANearlyDefectiveMatrixAndLeavesItAlone) {
  for (const double gap : {0.0, 1e-18, 1e-17}) {
    Eigen::Matrix3d a;
    a << 1.5, 1.0, 0.0, gap, 1.5, 0.0, 0.0, 0.0, 0.3;
    const Eigen::Matrix3d before = a;
    EXPECT_EQ(map_to_stable<3>(a, kLimit), StabilityStatus::kEigenvalueError) << gap;
    EXPECT_EQ(a, before);
  }
}

TEST(StableMap, RefusesAMatrixThatIsNotFinite) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, 1e300}) {
    Eigen::Matrix3d a = Eigen::Matrix3d::Identity();
    a(1, 2) = bad;
    EXPECT_EQ(map_to_stable<3>(a, kLimit), StabilityStatus::kEigenvalueError);
  }
}

TEST(StableMap, DoesNotAllocate) {
  Eigen::Matrix3d a = with_pair(1.3, 0.4, 1.7);
  const test::AllocationGuard guard;
  const StabilityStatus status = map_to_stable<3>(a, kLimit);
  EXPECT_EQ(guard.allocations(), 0u);
  EXPECT_EQ(status, StabilityStatus::kMappedToStable);
}

TEST(StableMap, NamesEveryStatusAndKeepsTheNumbersOfTheThesis) {
  std::set<std::string> names;
  for (int i = 1; i <= 4; ++i) {
    names.insert(to_string(static_cast<StabilityStatus>(i)));
  }
  EXPECT_EQ(names.size(), 4u);
  EXPECT_EQ(names.count("unknown status"), 0u);
  EXPECT_EQ(static_cast<int>(StabilityStatus::kEigenvalueError), 4);  // Table F.1
}

}  // namespace stable_map_test
}  // namespace farrier::estimation
