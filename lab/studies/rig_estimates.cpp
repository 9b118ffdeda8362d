#include "lab/studies/rig_estimates.hpp"

#include <algorithm>
#include <cmath>

#include "control/model_analysis.hpp"
#include "control/transfer_function.hpp"
#include "estimation/excitation_gate.hpp"
#include "estimation/linear_regression.hpp"
#include "lab/studies/bode.hpp"
#include "robot/joint_model.hpp"

namespace farrier::studies {
namespace {

using estimation::EstimationMethod;
using estimation::GateKind;

constexpr int kColumns = 4;  // x, v, F, u

control::SingleInOut<3> force_system(const control::DiscreteModel& model, double period_s) {
  return {model.a, model.b, Eigen::RowVector3d::UnitZ(), 0.0, period_s};
}

/// A current answered by a force of its own size, with the memory of a tick: phase zero, no resonance.
control::DiscreteModel wrong_model() {
  return {0.5 * Eigen::Matrix3d::Identity(), Eigen::Vector3d(0.0, 0.0, 0.5)};
}

template <class Engine>
control::DiscreteModel model_of(const Engine& engine) {
  const auto theta = engine.parameters();
  return {theta.template leftCols<3>(), theta.col(3)};
}

/// The models' indices between two times.
Span models_between(const ChirpEstimates& run, double from_s, double to_s) {
  const auto at = [&](double t) {
    return static_cast<std::size_t>(std::lower_bound(run.time_s.begin(), run.time_s.end(), t) - run.time_s.begin());
  };
  return {at(from_s), at(to_s)};
}

/// RMS of the difference in dB over the grid within [from_Hz, to_Hz].
double rms_difference_dB(const std::vector<double>& a, const std::vector<double>& b, double from_Hz, double to_Hz) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (chirp_grid()[i] >= from_Hz && chirp_grid()[i] <= to_Hz) {
      sum += (a[i] - b[i]) * (a[i] - b[i]);
      count += 1.0;
    }
  }
  return std::sqrt(sum / count);
}

void learn(estimation::LinearRegression& regression, const RigTrace& trace, const Eigen::Vector3d& scale,
           double current_max_A, estimation::ExcitationGate& gate, const estimation::EstimatorParams& params,
           ChirpEstimates& out) {
  // The gates' own figures: what they look at is not asked of the gate that decides.
  estimation::PersistenceGate persistence(params.pe.value_or(estimation::PersistenceParams{}), kColumns);
  estimation::SpectrumGate spectrum(params.fft.value_or(estimation::SpectrumParams{}));
  const auto signal_at = [&](std::size_t i) {
    return Eigen::Vector4d(trace.measured_position_m[i] / scale(0), trace.measured_velocity_m_s[i] / scale(1),
                           trace.measured_force_N[i] / scale(2), trace.current_A[i] / current_max_A);
  };
  const auto each = static_cast<std::size_t>(std::llround(kModel_s / trace.period_s));
  for (std::size_t i = 1; i < trace.time_s.size(); ++i) {
    const Eigen::Vector4d h = signal_at(i - 1);
    const Eigen::Vector3d y = signal_at(i).head<3>();
    gate.observe(h);
    const bool open = gate.open();
    Eigen::Vector3d error, lambda;
    std::visit(
        [&](auto& engine) {
          if constexpr (std::decay_t<decltype(engine)>::kSize == kColumns) {
            error = y - engine.parameters() * h;
            if (open) {
              estimation::teach(engine, 1.0, h, y, h);
            }
            lambda = engine.forgetting();
            if (i % each == 0) {
              out.time_s.push_back(trace.time_s[i]);
              out.models.push_back(model_of(engine));
              out.learning.push_back(open);
            }
          }
        },
        regression);
    out.tick_s.push_back(trace.time_s[i]);
    out.forgetting.push_back(open ? lambda : Eigen::Vector3d::Ones());
    out.error.push_back(error);
    out.open.push_back(open);
    if (params.gate == GateKind::kPe) {
      persistence.observe(h);
      out.singular_values.push_back(persistence.singular_values());
    } else if (params.gate == GateKind::kFft) {
      spectrum.observe(h);
      out.frequencies.push_back(spectrum.frequencies());
    }
  }
}

}  // namespace

estimation::EstimatorParams params_of(const ChirpCase& one) {
  estimation::EstimatorParams params;
  params.method = one.method;
  params.gate = one.gate;
  params.forgetting_factor = 0.92;  // Fig. 9.1
  params.bias = false;
  params.position = true;
  params.initial_covariance = 1e5;
  params.covariance_limit = 1e9;
  params.aff = estimation::AdaptiveForgettingParams{};
  params.pe = estimation::PersistenceParams{.window_ticks = 400, .information_min = 1e-4, .information_max = 1e2};
  params.fft = estimation::SpectrumParams{.window_ticks = 256, .magnitude_min = 5e-3, .frequencies_min = 4};
  return params;
}

Result<ChirpEstimates> estimate_chirp(const robot::Robot& rig, const ChirpCase& one, std::uint64_t seed) {
  const robot::Joint& joint = rig.joints[0];
  const control::Normalisation& n = joint.normalisation;
  const auto trace = drive(rig, {.current_A = chirp(one.amplitude * n.current_A, kChirp_Hz, kChirp_s),
                                 .duration_s = kChirp_s, .added_kg = one.added_kg}, seed);
  if (!trace) {
    return trace.error();
  }
  const estimation::EstimatorParams params = params_of(one);
  const Eigen::Vector3d scale(n.position, n.velocity, n.force);
  const Eigen::Vector3d noise(joint.noise.position, joint.noise.velocity, joint.noise.force);
  ChirpEstimates out;
  out.period_s = rig.period_s;
  out.first = wrong_model();
  plant::LoadParams load = joint.swing_load;
  load.mass += one.added_kg;
  out.nominal = control::normalise(robot::model_of(joint, load, rig.period_s), n);
  auto regression = estimation::make_regression(params, noise.cwiseQuotient(scale).cwiseAbs2(), out.first.a, out.first.b);
  if (!regression) {
    return regression.error();
  }
  auto gate = estimation::ExcitationGate::create(params);
  if (!gate) {
    return gate.error();
  }
  learn(regression.value(), trace.value(), scale, n.current_A, gate.value(), params, out);
  return out;
}

const std::vector<double>& chirp_grid() {
  static const std::vector<double> grid = control::logarithmic_grid(0.3, 200.0, 90);
  return grid;
}

std::vector<std::complex<double>> force_response(const control::DiscreteModel& model, double period_s) {
  return control::responses(force_system(model, period_s), chirp_grid());
}

bool has_fictive_peak(const control::DiscreteModel& model, double period_s) {
  constexpr double kHighest_Hz = 10.0;
  constexpr double kProminence_dB = 3.0;
  const std::vector<double> dB = decibels(force_response(model, period_s));
  std::size_t end = 0;
  while (chirp_grid()[end] <= kHighest_Hz) {
    ++end;
  }
  for (std::size_t i = 1; i < end; ++i) {
    const auto at = dB.begin() + static_cast<std::ptrdiff_t>(i);
    if (dB[i] > dB[i - 1] && dB[i] >= dB[i + 1]) {
      const double left = *std::min_element(dB.begin(), at);
      const double right = *std::min_element(at, dB.end());
      if (dB[i] - std::max(left, right) >= kProminence_dB) {
        return true;
      }
    }
  }
  return false;
}

double fictive_share(const ChirpEstimates& run, double from_s, double to_s) {
  const Span span = models_between(run, from_s, to_s);
  double peaks = 0.0;
  for (std::size_t i = span.begin; i < span.end; ++i) {
    peaks += has_fictive_peak(run.models[i], run.period_s) ? 1.0 : 0.0;
  }
  return peaks / static_cast<double>(span.end - span.begin);
}

double distance_dB(const ChirpEstimates& run, double from_s, double to_s, double from_Hz, double to_Hz) {
  const std::vector<double> nominal = decibels(force_response(run.nominal, run.period_s));
  const Span span = models_between(run, from_s, to_s);
  double sum = 0.0;
  for (std::size_t i = span.begin; i < span.end; ++i) {
    sum += rms_difference_dB(decibels(force_response(run.models[i], run.period_s)), nominal, from_Hz, to_Hz);
  }
  return sum / static_cast<double>(span.end - span.begin);
}

double first_distance_dB(const ChirpEstimates& run, double from_Hz, double to_Hz) {
  return rms_difference_dB(decibels(force_response(run.first, run.period_s)),
                           decibels(force_response(run.nominal, run.period_s)), from_Hz, to_Hz);
}

double roughness_dB(const ChirpEstimates& run, double from_s, double to_s) {
  const Span span = models_between(run, from_s, to_s);
  double sum = 0.0;
  for (std::size_t i = span.begin + 1; i < span.end; ++i) {
    sum += rms_difference_dB(decibels(force_response(run.models[i], run.period_s)),
                             decibels(force_response(run.models[i - 1], run.period_s)), 1.0, 100.0);
  }
  return sum / static_cast<double>(span.end - span.begin - 1);
}

std::vector<Span> open_spans(const ChirpEstimates& run, std::size_t shortest) {
  std::vector<Span> spans;
  for (std::size_t i = 0; i < run.open.size(); ++i) {
    if (run.open[i] && (i == 0 || !run.open[i - 1])) {
      spans.push_back({i, i});
    }
    if (run.open[i]) {
      spans.back().end = i + 1;
    }
  }
  std::erase_if(spans, [=](const Span& span) { return span.end - span.begin < shortest; });
  return spans;
}

std::vector<Panel> estimates_panels(const std::string& title, const ChirpEstimates& run) {
  constexpr std::size_t kDrawn = 40;
  std::vector<Curve> curves;
  const std::size_t each = std::max<std::size_t>(1, run.models.size() / kDrawn);
  for (std::size_t i = 0; i < run.models.size(); i += each) {
    if (run.learning[i]) {
      curves.push_back({"", force_response(run.models[i], run.period_s), 0,
                        static_cast<double>(i) / static_cast<double>(run.models.size()), Style::kLine});
    }
  }
  curves.push_back({"first", force_response(run.first, run.period_s), 4, -1.0, Style::kLine});
  curves.push_back({"nominal", force_response(run.nominal, run.period_s), 1, -1.0, Style::kLine});
  curves.push_back({"last", force_response(run.models.back(), run.period_s), 3, -1.0, Style::kLine});
  return bode_panels(title, chirp_grid(), curves);
}

Picture forgetting_picture(const std::string& caption, const ChirpEstimates& run) {
  Picture picture{caption, 1, {}};
  constexpr const char* kNames[] = {"position", "velocity", "force"};
  for (int row = 0; row < 3; ++row) {
    Series series{"", run.tick_s, {}, Style::kLine, row + 1};
    for (const Eigen::Vector3d& lambda : run.forgetting) {
      series.y.push_back(lambda(row));
    }
    picture.panels.push_back({.title = kNames[row], .x_label = "time (s)", .y_label = "forgetting factor (1)",
                              .series = {std::move(series)}});
  }
  return picture;
}

}  // namespace farrier::studies
