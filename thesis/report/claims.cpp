#include "thesis/report/claims.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <mutex>

#include "core/ensure.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::thesis {
namespace {

using thesis::ClaimSpec;
using thesis::Measured;

report::Relation relation_of(thesis::Relation relation) {
  switch (relation) {
    case thesis::Relation::kAtMost: return report::Relation::kAtMost;
    case thesis::Relation::kBelow: return report::Relation::kBelow;
    case thesis::Relation::kAtLeast: return report::Relation::kAtLeast;
  }
  return report::Relation::kNone;
}

std::string with_unit(double value, const std::string& unit) {
  return report::short_number(value) + (unit == "1" ? "" : " " + unit);
}

/// Why the verdict is not "holds".
std::string reason_of(const ClaimSpec& spec, thesis::Verdict verdict, const Measured* measured,
                      const std::string& refusal) {
  if (verdict == thesis::Verdict::kHolds) {
    return measured->note;
  }
  if (!refusal.empty()) {
    return "the study could not run: " + refusal;
  }
  if (measured == nullptr) {
    return "the study did not measure it";
  }
  std::string reason = verdict == thesis::Verdict::kRefuted ? spec.refutation->reason
                       : std::isfinite(measured->value)      ? "measured otherwise"
                                                             : "could not be measured";
  return measured->note.empty() ? reason : reason + " (" + measured->note + ")";
}

/// Declarations of studies' figures. They live as long as the program, as those of the registry do.
const report::FigureSpec& declare(const std::string& name, const std::string& unit, report::Relation relation,
                                  const std::string& meaning) {
  struct Declared {
    std::string name, unit, meaning;
    report::FigureSpec spec;
  };
  static std::deque<Declared> declared;
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  const auto known = std::ranges::find(declared, name, &Declared::name);
  if (known != declared.end()) {
    return known->spec;
  }
  Declared& one = declared.emplace_back(Declared{name, unit, meaning, {}});
  one.spec = {one.name.c_str(), one.unit.c_str(), relation, one.meaning.c_str()};
  return one.spec;
}

}  // namespace

std::vector<report::Claim> claims_of(const StudyRun& run) {
  static const std::vector<Measured> kNothing;
  const bool ran = run.result.ok();
  const std::vector<Measured>& measured = ran ? run.result.value().measured : kNothing;
  for (const Measured& one : measured) {
    FARRIER_ENSURE(std::ranges::any_of(run.study.claims, [&](const ClaimSpec& spec) { return one.id == spec.id; }),
                   ("study " + std::string(run.study.number) + " claims nothing called " + one.id).c_str());
  }
  std::vector<report::Claim> claims;
  for (const ClaimSpec& spec : run.study.claims) {
    const auto found = std::ranges::find(measured, spec.id, &Measured::id);
    const Measured* one = found == measured.end() ? nullptr : &*found;
    const double value = one == nullptr ? std::numeric_limits<double>::quiet_NaN() : one->value;
    const thesis::Verdict verdict = thesis::judge(spec, value);
    claims.push_back({.id = spec.id,
                      .figure = run.study.number,
                      .section = spec.section,
                      .sentence = spec.sentence,
                      .claim = spec.claim,
                      .name = std::string("reproduce.") + spec.id,
                      .value = value,
                      .unit = spec.unit,
                      .relation = relation_of(spec.relation),
                      .bound = spec.bound,
                      .verdict = to_string(verdict),
                      .reason = reason_of(spec, verdict, one, ran ? "" : run.result.error().message)});
  }
  return claims;
}

void add_claims(report::Outcome& outcome, const std::vector<report::Claim>& claims) {
  for (const report::Claim& claim : claims) {
    const bool bounds = claim.verdict != to_string(thesis::Verdict::kRefuted);
    outcome.figures.add(declare(claim.name, claim.unit, claim.relation, claim.claim), claim.value, bounds ? std::optional(claim.bound) : std::nullopt);
    outcome.claims.push_back(claim);
  }
}

void add_figures(report::Outcome& outcome, const StudyRun& run) {
  if (!run.result.ok()) {
    return;
  }
  for (const thesis::StudyFigure& figure : run.result.value().figures) {
    outcome.figures.add(declare("reproduce." + figure.id, figure.unit, report::Relation::kNone, figure.meaning),
                        figure.value);
  }
}

std::string figure_text(const thesis::StudyFigure& figure) {
  return figure.id + "  " + with_unit(figure.value, figure.unit) + "\n";
}

std::string claim_text(const report::Claim& claim) {
  std::string text = claim.id + "  " + claim.verdict + "\n";
  text += "    \"" + claim.sentence + "\" (" + claim.section + ")\n    " + claim.claim + "\n";
  text += "    measured " + with_unit(claim.value, claim.unit) + ", claimed " + to_string(claim.relation) + " " +
          with_unit(claim.bound, claim.unit) + "\n";
  return claim.reason.empty() ? text : text + "    " + claim.reason + "\n";
}

std::string listing(const thesis::Study& study) {
  std::string text = std::string(study.number) + "  " + study.title + "\n";
  for (const ClaimSpec& spec : study.claims) {
    text += std::string("      ") + spec.id + ": " + spec.claim + " [" +
            to_string(relation_of(spec.relation)) + " " + with_unit(spec.bound, spec.unit) + "; " + spec.section + "]\n";
  }
  return text;
}

}  // namespace farrier::thesis
