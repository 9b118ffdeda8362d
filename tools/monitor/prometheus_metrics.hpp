#pragma once

#include <prometheus/collectable.h>

#include <mutex>

#include "tools/monitor/metric_table.hpp"

namespace farrier::display {

/// The metrics of a state, as prometheus-cpp has them. Families without a value are left out.
std::vector<prometheus::MetricFamily> metric_families(const MetricState& state);

/// Makes metrics of the newest frame whenever Prometheus asks. Thread-safe.
class PrometheusMetrics final : public prometheus::Collectable {
 public:
  /// `robot` must outlive it.
  explicit PrometheusMetrics(const robot::Robot& robot) : state_{robot, {}} {}

  /// Takes a frame made at this date, in seconds since 1970.
  void take(const monitor::Frame& frame, double time_s);

  std::vector<prometheus::MetricFamily> Collect() const override;

 private:
  mutable std::mutex mutex_;
  MetricState state_;
};

}  // namespace farrier::display
