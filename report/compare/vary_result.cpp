#include "report/compare/vary_result.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>

#include "core/median.hpp"
#include "core/replace_file.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::report {
namespace {

constexpr std::array kFixed{Contender::kStance, Contender::kSwing, Contender::kFeedbackLinearisation};

/// NaN counts as worse than any number.
double or_worst(double nrmse) noexcept { return std::isnan(nrmse) ? std::numeric_limits<double>::infinity() : nrmse; }

std::vector<const VaryRow*> of(std::span<const VaryRow> rows, Contender contender) {
  std::vector<const VaryRow*> found;
  for (const VaryRow& row : rows) {
    if (row.contender == contender) {
      found.push_back(&row);
    }
  }
  return found;
}

std::vector<double> stance_of(std::span<const VaryRow> rows, Contender contender) {
  std::vector<double> values;
  for (const VaryRow* row : of(rows, contender)) {
    values.push_back(or_worst(row->stance_nrmse));
  }
  return values;
}

double worst(const std::vector<double>& values) {
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : *std::ranges::max_element(values);
}

std::set<std::uint64_t> failed_seeds(std::span<const VaryRow> rows, Contender contender) {
  std::set<std::uint64_t> seeds;
  for (const VaryRow* row : of(rows, contender)) {
    if (row->failed()) {
      seeds.insert(row->seed);
    }
  }
  return seeds;
}

/// A joint of one seed's robot under adaptation and under another.
struct Pair {
  const VaryRow* adaptive;
  const VaryRow* other;
  double ratio() const noexcept { return or_worst(other->stance_nrmse) / or_worst(adaptive->stance_nrmse); }
};

std::vector<Pair> against(std::span<const VaryRow> rows, Contender contender) {
  std::map<std::pair<std::uint64_t, std::string_view>, const VaryRow*> others;
  for (const VaryRow* row : of(rows, contender)) {
    others[{row->seed, row->joint}] = row;
  }
  std::vector<Pair> pairs;
  for (const VaryRow* row : of(rows, Contender::kAdaptive)) {
    if (const auto found = others.find({row->seed, row->joint}); found != others.end()) {
      pairs.push_back({row, found->second});
    }
  }
  return pairs;
}

std::vector<Pair> wins_of(std::span<const VaryRow> rows, Contender contender) {
  std::vector<Pair> wins = against(rows, contender);
  std::erase_if(wins, [](const Pair& pair) { return !(pair.ratio() < 1.0); });
  return wins;
}

std::string padded_cell(std::string text, std::size_t width, bool right = false) {
  const std::size_t gap = width - std::min(width, text.size());
  return right ? std::string(gap, ' ') + text : text + std::string(gap, ' ');
}

std::string line_of(std::initializer_list<std::string> numbers) {
  std::string text;
  for (const std::string& number : numbers) {
    text += padded_cell(number, 11, true);
  }
  return text + '\n';
}

constexpr std::size_t kNameWidth = 24;

}  // namespace

const char* to_string(Contender contender) noexcept {
  switch (contender) {
    case Contender::kAdaptive:
      return "adaptive";
    case Contender::kPerfect:
      return "perfect";
    case Contender::kStance:
      return "stance";
    case Contender::kSwing:
      return "swing";
    case Contender::kFeedbackLinearisation:
      return "feedback_linearisation";
    case Contender::kPid:
      return "pid";
    case Contender::kGreyBox:
      return "greybox";
  }
  return "unknown";
}

void add_vary(Figures& figures, std::span<const VaryRow> rows) {
  std::set<std::uint64_t> seeds;
  for (const VaryRow& row : rows) {
    seeds.insert(row.seed);
  }
  const std::vector<double> adaptive = stance_of(rows, Contender::kAdaptive);
  const std::vector<double> perfect = stance_of(rows, Contender::kPerfect);
  std::vector<double> ratios;
  std::vector<double> within_supply;
  for (const Pair& pair : against(rows, Contender::kPerfect)) {
    ratios.push_back(1.0 / pair.ratio());
    if (pair.other->peak_demand <= 1.0) {
      within_supply.push_back(or_worst(pair.adaptive->stance_nrmse));
    }
  }
  const auto diverged = std::ranges::count_if(of(rows, Contender::kAdaptive), &VaryRow::diverged);
  figures.add("trot.vary.seeds", static_cast<double>(seeds.size()));
  figures.add("trot.vary.adaptive_stance_nrmse_median", median(adaptive));
  figures.add("trot.vary.perfect_stance_nrmse_median", median(perfect));
  figures.add("trot.vary.median_ratio_perfect", median(adaptive) / median(perfect), kMedianRatioPerfect);
  figures.add("trot.vary.ratio_perfect_median", median(ratios));
  figures.add("trot.vary.adaptive_worst", worst(adaptive), kWorstAdaptive);
  figures.add("trot.vary.adaptive_worst_within_supply", worst(within_supply));
  figures.add("trot.vary.perfect_worst", worst(perfect));
  figures.add("trot.vary.beyond_supply", static_cast<double>(ratios.size() - within_supply.size()));
  figures.add("trot.vary.adaptive_diverged", static_cast<double>(diverged), 0.0);
  for (const Contender contender : kContenders) {
    figures.add(std::string("trot.vary.") + to_string(contender) + ".seeds_failed",
                static_cast<double>(failed_seeds(rows, contender).size()),
                contender == Contender::kAdaptive ? std::optional(0.0) : std::nullopt);
  }
  for (const Contender contender : kFixed) {
    const std::string prefix = std::string("trot.vary.") + to_string(contender) + ".";
    figures.add(prefix + "median_ratio", median(stance_of(rows, contender)) / median(adaptive));
    figures.add(prefix + "wins", static_cast<double>(wins_of(rows, contender).size()));
  }
}

std::string vary_text(std::span<const VaryRow> rows, std::size_t longest) {
  std::string text = padded_cell("stance NRMSE", kNameWidth) + line_of({"median", "worst", "swing med.", "failed"});
  for (const Contender contender : kContenders) {
    std::vector<double> swing;
    for (const VaryRow* row : of(rows, contender)) {
      swing.push_back(or_worst(row->swing_nrmse));
    }
    const std::vector<double> stance = stance_of(rows, contender);
    text += padded_cell(to_string(contender), kNameWidth) +
            line_of({short_number(median(stance)), short_number(worst(stance)), short_number(median(swing)),
                     std::to_string(failed_seeds(rows, contender).size())});
  }
  std::vector<Pair> wins;
  for (const Contender contender : kFixed) {
    const std::vector<Pair> more = wins_of(rows, contender);
    wins.insert(wins.end(), more.begin(), more.end());
  }
  if (wins.empty()) {
    return text + "\nno fixed baseline beats adaptation anywhere\n";
  }
  std::ranges::stable_sort(wins, {}, &Pair::ratio);
  text += "\nwhere a fixed baseline beats adaptation (" + std::to_string(wins.size()) + "):\n" +
          padded_cell("baseline", kNameWidth) +
          line_of({"seed", "joint", "NRMSE", "adaptive", "supply x", "friction x", "valve x", "load"});
  for (const Pair& pair : std::span(wins).first(std::min(longest, wins.size()))) {
    const VaryRow& row = *pair.other;
    text += padded_cell(to_string(row.contender), kNameWidth) +
            line_of({std::to_string(row.seed), row.joint, short_number(row.stance_nrmse),
                     short_number(pair.adaptive->stance_nrmse), short_number(row.supply_factor),
                     short_number(row.friction_factor), short_number(row.valve_factor),
                     short_number(row.stance_mass_kg_or_kgm2)});
  }
  return wins.size() > longest ? text + "... and " + std::to_string(wins.size() - longest) + " more\n" : text;
}

Result<Done> write_vary_csv(const std::string& path, std::span<const VaryRow> rows) {
  std::ostringstream file;
  file.precision(std::numeric_limits<double>::max_digits10);
  file << "seed,controller,joint,supply_factor,friction_factor,valve_factor,stance_mass_kg_or_kgm2,peak_demand,"
          "stance_nrmse,swing_nrmse,left_tracking\n";
  for (const VaryRow& row : rows) {
    file << row.seed << ',' << to_string(row.contender) << ',' << row.joint << ',' << row.supply_factor << ','
         << row.friction_factor << ',' << row.valve_factor << ',' << row.stance_mass_kg_or_kgm2 << ','
         << row.peak_demand << ',' << row.stance_nrmse << ',' << row.swing_nrmse << ',' << (row.left_tracking ? 1 : 0)
         << '\n';
  }
  return replace_file(path, file.str());
}

}  // namespace farrier::report
