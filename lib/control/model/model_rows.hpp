#pragma once

#include <array>

#include "control/model/discretise.hpp"

namespace farrier::control {

// Models as signals carry them: matrices row by row.

using MatrixRows = std::array<double, 9>;
using ColumnEntries = std::array<double, 3>;

inline MatrixRows rows_of(const Eigen::Matrix3d& matrix) noexcept {
  MatrixRows rows;
  Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rows.data()) = matrix;
  return rows;
}

inline ColumnEntries entries_of(const Eigen::Vector3d& column) noexcept { return {column(0), column(1), column(2)}; }

inline DiscreteModel model_of_rows(const MatrixRows& a, const ColumnEntries& b) noexcept {
  return {Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(a.data()),
          Eigen::Map<const Eigen::Vector3d>(b.data())};
}

}  // namespace farrier::control
