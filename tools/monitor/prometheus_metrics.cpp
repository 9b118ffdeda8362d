#include "tools/monitor/prometheus_metrics.hpp"

#include <prometheus/metric_family.h>

namespace farrier::display {

std::vector<prometheus::MetricFamily> metric_families(const MetricState& state) {
  std::vector<prometheus::MetricFamily> families;
  for (const MetricSpec& spec : metric_specs()) {
    const bool counts = spec.kind == MetricKind::kCounter;
    prometheus::MetricFamily family{
        spec.name, spec.help, counts ? prometheus::MetricType::Counter : prometheus::MetricType::Gauge, {}};
    spec.fill(state, [&](double value, std::initializer_list<std::string_view> labels) {
      prometheus::ClientMetric& metric = family.metric.emplace_back();
      std::size_t i = 0;
      for (const std::string_view label : labels) {
        metric.label.push_back({spec.labels.at(i++), std::string(label)});
      }
      (counts ? metric.counter.value : metric.gauge.value) = value;
    });
    if (!family.metric.empty()) {
      families.push_back(std::move(family));
    }
  }
  return families;
}

void PrometheusMetrics::take(const monitor::Frame& frame, double time_s) {
  const std::scoped_lock lock(mutex_);
  state_.take(frame, time_s);
}

std::vector<prometheus::MetricFamily> PrometheusMetrics::Collect() const {
  const std::scoped_lock lock(mutex_);
  return state_.frame_time_s > 0.0 ? metric_families(state_) : std::vector<prometheus::MetricFamily>{};
}

}  // namespace farrier::display
