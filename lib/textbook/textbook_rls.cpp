#include "textbook/textbook_rls.hpp"

#include <Eigen/LU>

namespace farrier::textbook {

template <int N>
void TextbookRls<N>::update(const Eigen::Matrix<double, N, 1>& h, const Eigen::Vector3d& y) noexcept {
  for (int row = 0; row < 3; ++row) {
    h_.template block<1, N>(row, N * row) = h.transpose();
  }
  ph_.noalias() = p_ * h_.transpose();
  Eigen::Matrix3d s = lambda_ * Eigen::Matrix3d::Identity();
  s.noalias() += h_ * ph_;
  k_.noalias() = ph_ * s.inverse();
  const Eigen::Vector3d error = y - h_ * theta_;
  theta_.noalias() += k_ * error;
  hp_.noalias() = h_ * p_;
  p_.noalias() -= k_ * hp_;
  p_ /= lambda_;
}

template class TextbookRls<3>;
template class TextbookRls<4>;
template class TextbookRls<5>;

}  // namespace farrier::textbook
