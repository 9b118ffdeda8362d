#include "diagnosis/separability/settled_step.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "diagnosis/judge/fit_costs.hpp"
#include "diagnosis/judge/linearised.hpp"

namespace farrier::diagnosis {
namespace {

/// Solutions between which numbers that reach the ends of their ranges are held there.
constexpr int kMostSolutions = 5;

}  // namespace

Eigen::VectorXd settled_step(const Eigen::MatrixXd& normal, const Eigen::VectorXd& descent,
                             const std::vector<FreeNumber>& free, Model from) {
  std::vector<Eigen::Index> moving(free.size());
  std::iota(moving.begin(), moving.end(), Eigen::Index{0});
  Eigen::VectorXd held = Eigen::VectorXd::Zero(std::ssize(free));
  Eigen::VectorXd step = held;
  for (int i = 0; i < kMostSolutions && !moving.empty(); ++i) {
    std::vector<FreeNumber> numbers;
    std::ranges::transform(moving, std::back_inserter(numbers),
                           [&](auto k) { return free[static_cast<std::size_t>(k)]; });
    const Eigen::VectorXd rest = descent - normal * held;
    const Eigen::VectorXd part = bounded_step(normal(moving, moving), rest(moving), numbers, from);
    step = held;
    step(moving) = part;
    const std::size_t before = moving.size();
    std::erase_if(moving, [&](Eigen::Index k) {
      const FreeNumber& number = free[static_cast<std::size_t>(k)];
      const double now = number_at(from, number.place) + step[k];
      const bool ends = now <= number.low || now >= number.high;
      held[k] = ends ? step[k] : 0.0;
      return ends;
    });
    if (moving.size() == before) {
      break;
    }
  }
  return step;
}

}  // namespace farrier::diagnosis
