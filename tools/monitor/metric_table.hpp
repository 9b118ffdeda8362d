#pragma once

#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "tools/monitor/metric_state.hpp"

namespace farrier::display {

enum class MetricKind : std::uint8_t { kGauge, kCounter };

/// Gets one value with the values of the metric's labels, in their order.
using Sample = std::function<void(double value, std::initializer_list<std::string_view> labels)>;

/// Declaration of a metric. Names have base units of Prometheus, counters end in _total.
struct MetricSpec {
  const char* name;
  MetricKind kind;
  std::array<const char*, 4> labels;                             ///< null: no more
  const char* help;                                              ///< one sentence
  void (*fill)(const MetricState& state, const Sample& sample);  ///< values there are; what is not known is left out
};

/// Every metric, once.
std::span<const MetricSpec> metric_specs() noexcept;

/// Markdown table of all, for docs/metrics.md.
std::string metrics_table_markdown();

}  // namespace farrier::display
