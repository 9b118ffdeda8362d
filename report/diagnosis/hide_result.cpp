#include "report/diagnosis/hide_result.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <string_view>

#include "core/replace_file.hpp"
#include "diagnosis/judge/judgement.hpp"

namespace farrier::report {
namespace {

std::string joined_by(const std::vector<std::string>& names, const char* between) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : between) + name;
  }
  return text;
}

template <class... Values>
std::string line(const char* format, Values... values) {
  char text[256];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

std::string found_text(const JointVerdict& verdict) {
  std::string text = verdict.verdict;
  if (!verdict.effects.empty()) {
    text += ": " + joined_by(verdict.effects, ", ");
  }
  if (!verdict.tied.empty()) {
    text += ", or " + joined_by(verdict.tied, ", ");
  }
  return text;
}

std::string hidden_text(const HideTrial& trial) {
  return "hidden: " + trial.joint + ' ' + trial.effect + ' ' + trial.parameter + line(" = %.4g", trial.value) +
         (trial.unit == "1" ? "" : " " + trial.unit) + ", seed " + std::to_string(trial.seed);
}

}  // namespace

bool JointVerdict::suspects() const {
  using enum diagnosis::Verdict;
  return verdict != to_string(kNone) && verdict != to_string(kNotExcited) && verdict != to_string(kBadData) &&
         verdict != to_string(kWiring);
}

const JointVerdict* HideTrial::suspect() const {
  const JointVerdict* largest = nullptr;
  for (const JointVerdict& verdict : verdicts) {
    if (verdict.suspects() && (largest == nullptr || verdict.gain > largest->gain)) {
      largest = &verdict;
    }
  }
  return largest;
}

bool HideTrial::named() const {
  const JointVerdict* const found = suspect();
  return found != nullptr && found->joint == joint && !found->effects.empty() && found->effects.front() == effect;
}

bool HideTrial::named_or_tied() const {
  const JointVerdict* const found = suspect();
  return named() || (found != nullptr && found->joint == joint && std::ranges::count(found->tied, effect) > 0);
}

std::size_t HideTrial::false_joints() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      verdicts, [this](const JointVerdict& verdict) { return verdict.suspects() && verdict.joint != joint; }));
}

double least_named(std::size_t trials) { return std::ceil(11.0 * static_cast<double>(trials) / 12.0); }

double most_false_joints(std::size_t trials) { return std::floor(static_cast<double>(trials) / 12.0); }

void add_hide(Figures& figures, std::span<const HideTrial> trials) {
  double named = 0.0, named_or_tied = 0.0, false_joints = 0.0, nominal = 0.0, hidden = 0.0, known = 0.0;
  for (const HideTrial& trial : trials) {
    named += trial.named() ? 1.0 : 0.0;
    named_or_tied += trial.named_or_tied() ? 1.0 : 0.0;
    false_joints += static_cast<double>(trial.false_joints());
    nominal += trial.nrmse_nominal;
    hidden += trial.nrmse_hidden;
    known += trial.nrmse_known;
  }
  const auto count = static_cast<double>(trials.size());
  figures.add("hide.seeds", count);
  figures.add("hide.named", named, least_named(trials.size()));
  figures.add("hide.named_or_tied", named_or_tied);
  figures.add("hide.false_joints", false_joints, most_false_joints(trials.size()));
  figures.add("hide.nrmse_nominal", nominal / count);
  figures.add("hide.nrmse_hidden", hidden / count);
  // With a few seeds all effects may be ones that a stance does not feel.
  const bool enough = trials.size() >= kSeedsForTracking;
  figures.add("hide.nrmse_known", known / count,
              enough ? std::optional(0.5 * (nominal + hidden) / count) : std::nullopt);
}

std::string hide_text(std::span<const HideTrial> trials) {
  std::string text;
  if (trials.size() == 1) {
    const HideTrial& trial = trials.front();
    for (const JointVerdict& verdict : trial.verdicts) {
      text += line("%-12s gain %6.3f  ", verdict.joint.c_str(), verdict.gain) + found_text(verdict) +
              (&verdict == trial.suspect() ? "  <--" : "") + '\n';
    }
    return text + hidden_text(trial) + '\n';
  }
  for (const HideTrial& trial : trials) {
    const JointVerdict* const found = trial.suspect();
    text += hidden_text(trial) + "\n  " +
            (trial.named()           ? "named"
             : trial.named_or_tied() ? "tied"
                                     : "missed") +
            ": " + (found != nullptr ? found->joint + ", " + found_text(*found) : std::string("no joint")) +
            line("; %zu other joints suspected; stance NRMSE nominal %.4f, hidden %.4f, known %.4f\n",
                 trial.false_joints(), trial.nrmse_nominal, trial.nrmse_hidden, trial.nrmse_known);
  }
  return text;
}

Result<Done> write_hide_csv(const std::string& path, std::span<const HideTrial> trials) {
  std::ostringstream file;
  file
      << "seed,hidden_joint,hidden_effect,value,unit,nrmse_nominal,nrmse_hidden,nrmse_known,joint,verdict,effects,tied,"
         "gain,suspect\n";
  for (const HideTrial& trial : trials) {
    for (const JointVerdict& verdict : trial.verdicts) {
      file << trial.seed << ',' << trial.joint << ',' << trial.effect
           << line(",%.6g,%s,%.6g,%.6g,%.6g,", trial.value, trial.unit.c_str(), trial.nrmse_nominal, trial.nrmse_hidden,
                   trial.nrmse_known)
           << verdict.joint << ',' << verdict.verdict << ',' << joined_by(verdict.effects, " ") << ','
           << joined_by(verdict.tied, " ") << line(",%.6g,%d\n", verdict.gain, &verdict == trial.suspect() ? 1 : 0);
    }
  }
  return replace_file(path, file.str());
}

}  // namespace farrier::report
