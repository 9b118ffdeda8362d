// Hubacher (2014), Figs 6.1 and C.1: the loads and a valve current of the studies of Figs 6.2 to 6.5 and C.2.

#include "plant/nominal.hpp"
#include "thesis/rig/walking_cycle.hpp"
#include "thesis/studies/registry.hpp"

namespace farrier::thesis {
namespace chapter6_inputs_studies {
namespace {

using thesis::CycleSample;

Result<StudyResult> run_loads(const StudyContext&) {
  const auto& loads = thesis::walking_cycle();
  Series mass{"", {}, {}, Style::kLine, 0}, damping{"", {}, {}, Style::kLine, 1};
  for (std::size_t i = 0; i < loads.size(); ++i) {
    for (const double t : {0.25 * static_cast<double>(i), 0.25 * static_cast<double>(i + 1)}) {
      mass.x.push_back(t);
      mass.y.push_back(loads[i].mass);
      damping.x.push_back(t);
      damping.y.push_back(loads[i].damping);
    }
  }
  StudyResult result;
  result.pictures = {{"Load of the joint. The numbers are ours: the text prints the order and not the values",
                      1,
                      {{.title = "load mass",
                        .x_label = "time (s)",
                        .y_label = "mass (kg)",
                        .log_y = true,
                        .series = {std::move(mass)}},
                       {.title = "load friction",
                        .x_label = "time (s)",
                        .y_label = "friction (Ns/m)",
                        .series = {std::move(damping)}}}}};
  return result;
}

Result<StudyResult> run_multisine(const StudyContext& context) {
  Series current{"", {}, {}, Style::kLine, 0};
  for (const CycleSample& sample : thesis::drive(thesis::walking_cycle(), false, thesis::kSmallOpening, context.seed)) {
    current.x.push_back(static_cast<double>(current.x.size()) * thesis::kCyclePeriod_s);
    current.y.push_back(100.0 * sample.current_A / plant::kNominalCurrent_A);
  }
  StudyResult result;
  result.pictures = {{"Sines of 5 and 10 Hz",
                      1,
                      {{.title = "",
                        .x_label = "time (s)",
                        .y_label = "valve current (% of nominal)",
                        .series = {std::move(current)}}}}};
  return result;
}

constexpr const char* kInputs = "These are inputs of ours, so nothing is claimed of them.";

constexpr Study kStudies[] = {{"6.1", "Load of the joint the estimator is tried on", {}, run_loads, kInputs},
                              {"C.1", "Valve current with two frequencies", {}, run_multisine, kInputs}};

}  // namespace
}  // namespace chapter6_inputs_studies

std::span<const Study> chapter6_inputs() { return chapter6_inputs_studies::kStudies; }

}  // namespace farrier::thesis
