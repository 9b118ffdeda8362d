#include "tools/monitor/prometheus_exposer.hpp"

#include <prometheus/exposer.h>

#include <exception>

#include "participant/clock.hpp"
#include "tools/monitor/prometheus_metrics.hpp"

namespace farrier::display {
namespace {

class ExposedMetrics final : public Display {
 public:
  ExposedMetrics(const ListenAddress& address, const robot::Robot& robot)
      : metrics_(std::make_shared<PrometheusMetrics>(robot)), exposer_(address.text()) {
    exposer_.RegisterCollectable(metrics_);
  }

  void show(const monitor::Frame& frame) override {
    metrics_->take(frame, static_cast<double>(participant::date_now_ns()) * 1e-9);
  }

 private:
  std::shared_ptr<PrometheusMetrics> metrics_;
  prometheus::Exposer exposer_;
};

}  // namespace

Result<std::unique_ptr<Display>> expose_to_prometheus(const ListenAddress& address, const robot::Robot& robot) {
  if (address.port == 0) {
    return Error{"any free port is one that Prometheus could not find: give a port, as :9464"};
  }
  // Asked first: the server's own exception has no reason in it.
  FARRIER_TRY(check_listening(address));
  try {
    return std::unique_ptr<Display>(new ExposedMetrics(address, robot));
  } catch (const std::exception& problem) {
    return Error{"cannot listen on " + address.text() + ": " + problem.what()};
  }
}

}  // namespace farrier::display
