#include "gait/stepping.hpp"

#include <algorithm>
#include <map>

namespace farrier::gait {

std::string stepping_order(const RobotPlan& plan) {
  if (plan.gait.pattern == Pattern::kStand) {
    return {};
  }
  std::map<double, std::string> by_offset;
  for (const LegPlan& leg : plan.legs) {
    std::string& together = by_offset[leg.phase_offset];
    together += (together.empty() ? "" : "+") + leg.name;
  }
  std::string order;
  for (const auto& [offset, legs] : by_offset) {
    order += (order.empty() ? "" : ", ") + legs;
  }
  return order;
}

double flight_share(const RobotPlan& plan) {
  if (plan.gait.pattern == Pattern::kStand) {
    return 0.0;
  }
  // A leg stands for `duty` of the stride from its offset on. Flight lies between the end of that and the next offset.
  std::vector<double> offsets;
  for (const LegPlan& leg : plan.legs) {
    offsets.push_back(leg.phase_offset);
  }
  std::ranges::sort(offsets);
  double share = 0.0;
  for (std::size_t i = 0; i < offsets.size(); ++i) {
    const double next = i + 1 < offsets.size() ? offsets[i + 1] : offsets.front() + 1.0;
    share += std::max(0.0, next - offsets[i] - plan.gait.duty);
  }
  return share;
}

}  // namespace farrier::gait
