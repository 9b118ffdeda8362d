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

report::Relation relation_of(thesis::Relation relation) {
  switch (relation) {
    case thesis::Relation::kAtMost:
      return report::Relation::kAtMost;
    case thesis::Relation::kBelow:
      return report::Relation::kBelow;
    case thesis::Relation::kAtLeast:
      return report::Relation::kAtLeast;
  }
  return report::Relation::kNone;
}

std::string with_unit(double value, const std::string& unit) {
  return report::short_number(value) + (unit == "1" ? "" : " " + unit);
}

/// The values of a claim over the seeds, the best first.
struct Values {
  std::vector<double> sorted;
  double middle() const { return sorted[sorted.size() / 2]; }
  double worst() const { return sorted.back(); }
};

Values sorted_values(const ClaimSpec& spec, std::vector<double> values) {
  std::ranges::stable_sort(values, [&](double a, double b) { return better(spec, a, b); });
  return {std::move(values)};
}

const Measured* find_measured(const SeedRun& run, const char* id) {
  if (!run.result.ok()) {
    return nullptr;
  }
  const auto& measured = run.result.value().measured;
  const auto found = std::ranges::find(measured, id, &Measured::id);
  return found == measured.end() ? nullptr : &*found;
}

/// The explanation of a verdict. `refusal` is empty if the study ran.
std::string reason_of(const ClaimSpec& spec, Verdict verdict, double value, const Measured* measured,
                      const std::string& refusal) {
  if (!refusal.empty()) {
    return "the study could not run: " + refusal;
  }
  if (measured == nullptr) {
    return "the study did not measure it";
  }
  std::string reason;
  switch (verdict) {
    case Verdict::kHolds:
      return measured->note;
    case Verdict::kNeeds:
      reason = spec_of(*spec.condition).meaning;
      break;
    case Verdict::kRefuted:
      reason = spec.refutation->proof;
      break;
    case Verdict::kFails:
      reason = std::isfinite(value) ? "measured otherwise" : "could not be measured";
      break;
  }
  return measured->note.empty() ? reason : reason + " (" + measured->note + ")";
}

report::Claim claim_of(const StudyRun& run, const ClaimSpec& spec) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> values, conditioned;
  std::string refusal;
  for (const SeedRun& one : run.seeds) {
    const Measured* measured = find_measured(one, spec.id);
    refusal = one.result.ok() ? refusal : one.result.error().message;
    values.push_back(measured == nullptr ? kNone : measured->value);
    conditioned.push_back(measured == nullptr ? kNone : measured->under_condition.value_or(kNone));
  }
  const Values plain = sorted_values(spec, values);
  const Values under = sorted_values(spec, std::move(conditioned));
  const double value = plain.middle();
  const Verdict verdict = judge(spec, value, under.middle());
  // The note of the run whose value is the median.
  const auto at =
      std::ranges::find_if(values, [&](double one) { return one == value || (std::isnan(one) && std::isnan(value)); });
  report::Claim claim{
      .id = spec.id,
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
      .reason = reason_of(spec, verdict, value,
                          find_measured(run.seeds[static_cast<std::size_t>(at - values.begin())], spec.id),
                          std::isfinite(value) ? "" : refusal),
      .kind = to_string(spec.kind),
      .values = std::move(values),
      .worst = plain.worst(),
      .tried = verdict == Verdict::kFails ? spec.tried : ""};
  if (spec.condition) {
    const ConditionSpec& condition = spec_of(*spec.condition);
    claim.condition =
        report::ClaimCondition{condition.name, condition.meaning, condition.source, under.middle(), under.worst()};
  }
  return claim;
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

const StudyResult* shown(const StudyRun& run) noexcept {
  return run.seeds.front().result.ok() ? &run.seeds.front().result.value() : nullptr;
}

std::vector<report::Claim> claims_of(const StudyRun& run) {
  for (const SeedRun& one : run.seeds) {
    for (const Measured& measured : one.result.ok() ? one.result.value().measured : std::vector<Measured>{}) {
      FARRIER_ENSURE(
          std::ranges::any_of(run.study.claims, [&](const ClaimSpec& spec) { return measured.id == spec.id; }),
          ("study " + std::string(run.study.number) + " claims nothing called " + measured.id).c_str());
    }
  }
  std::vector<report::Claim> claims;
  for (const ClaimSpec& spec : run.study.claims) {
    claims.push_back(claim_of(run, spec));
  }
  return claims;
}

void add_claims(report::Outcome& outcome, std::vector<report::Claim> claims) {
  for (report::Claim& claim : claims) {
    const bool bounds = claim.verdict == to_string(Verdict::kHolds);
    outcome.figures.add(declare(claim.name, claim.unit, claim.relation, claim.claim), claim.value,
                        bounds ? std::optional(claim.bound) : std::nullopt);
    outcome.claims.push_back(std::move(claim));
  }
  std::ranges::stable_partition(outcome.claims,
                                [](const report::Claim& claim) { return claim.verdict == to_string(Verdict::kFails); });
}

void add_figures(report::Outcome& outcome, const StudyRun& run) {
  const StudyResult* result = shown(run);
  if (result == nullptr) {
    return;
  }
  for (const StudyFigure& figure : result->figures) {
    outcome.figures.add(declare("reproduce." + figure.id, figure.unit, report::Relation::kNone, figure.meaning),
                        figure.value);
  }
}

std::string totals_text(const report::Outcome& outcome) {
  constexpr std::pair<ClaimKind, const char*> kKinds[] = {{ClaimKind::kText, "claims of the text"},
                                                          {ClaimKind::kProof, "proofs of ours"},
                                                          {ClaimKind::kAim, "aims of ours"}};
  std::string text;
  for (const auto& [kind, name] : kKinds) {
    const auto count = [&, kind = kind](Verdict verdict) {
      return std::to_string(std::ranges::count_if(outcome.claims, [&](const report::Claim& claim) {
        return claim.kind == to_string(kind) && claim.verdict == to_string(verdict);
      }));
    };
    const bool any = std::ranges::any_of(
        outcome.claims, [kind = kind](const report::Claim& claim) { return claim.kind == to_string(kind); });
    if (any) {
      text += std::string(name) + ": " + count(Verdict::kHolds) + " hold, " + count(Verdict::kNeeds) +
              " need a condition, " + count(Verdict::kRefuted) + " are refuted, " + count(Verdict::kFails) + " fail\n";
    }
  }
  return text;
}

std::string figure_text(const thesis::StudyFigure& figure) {
  return figure.id + "  " + with_unit(figure.value, figure.unit) + "\n";
}

std::string claim_text(const report::Claim& claim) {
  std::string text = claim.id + "  " + claim.verdict +
                     (claim.kind == to_string(ClaimKind::kText) ? "" : " (" + claim.kind + ")") + "\n";
  text += "    \"" + claim.sentence + "\" (" + claim.section + ")\n    " + claim.claim + "\n";
  text += "    measured " + with_unit(claim.value, claim.unit);
  if (claim.values.size() > 1) {
    text += " (median of " + std::to_string(claim.values.size()) + " seeds, worst " +
            with_unit(claim.worst, claim.unit) + ")";
  }
  text += ", claimed " + std::string(to_string(claim.relation)) + " " + with_unit(claim.bound, claim.unit) + "\n";
  if (claim.condition) {
    text += "    with " + claim.condition->name + ": " + with_unit(claim.condition->value, claim.unit) + ", worst " +
            with_unit(claim.condition->worst, claim.unit) + "\n";
  }
  for (const std::string& more : {claim.reason, claim.tried}) {
    text += more.empty() ? "" : "    " + more + "\n";
  }
  return text;
}

std::string listing(const thesis::Study& study) {
  std::string text = std::string(study.number) + "  " + study.title + "\n";
  for (const ClaimSpec& spec : study.claims) {
    text += std::string("      ") + spec.id + ": " + spec.claim + " [" + to_string(relation_of(spec.relation)) + " " +
            with_unit(spec.bound, spec.unit) + "; " + spec.section + "]\n";
  }
  return text;
}

}  // namespace farrier::thesis
