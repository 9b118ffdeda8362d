#include "trials/body/fixed_search.hpp"

#include <algorithm>
#include <string_view>
#include <tuple>

#include "core/noise.hpp"

namespace farrier::trials {
namespace {

constexpr int kCandidates = 32;   // of the first two rounds each
constexpr std::size_t kKept = 4;  // a quarter of each round goes on
constexpr std::array kSeedsOfRound{1, 1, 1, 3};
constexpr int kRefined = 1;       // round with gains around the best of the round before
constexpr double kNearby = 0.15;  // of the range of a parameter, either way
constexpr std::uint64_t kFirstSeed = 101;
// The first two rounds have the first four.
constexpr std::array<std::string_view, 8> kSearchedRows{"gain_50", "gain_175", "overlap_3", "leakage",
                                                        "nominal", "hot_air",  "worn",      "coil_lost"};
constexpr std::ptrdiff_t kRowsOfFirstRound = 4;

bool is_searched(const PlantRow& row, int round) {
  const auto end = round <= kRefined ? kSearchedRows.begin() + kRowsOfFirstRound : kSearchedRows.end();
  return std::find(kSearchedRows.begin(), end, row.name) != end;
}

using Gains = control::FeedbackLinearisationGains;

/// Gains by candidate: uniform over the whole range, or within kNearby of others.
Gains drawn_gains(int candidate, bool with_observer, const Gains* around = nullptr) {
  const auto drawn = [&](const char* parameter, double Gains::*gain, double low, double high) {
    const double share = NoiseStream(kFirstSeed, "fixed search", parameter).uniform(candidate);
    return around == nullptr ? low + (high - low) * share
                             : std::clamp(around->*gain + (2.0 * share - 1.0) * kNearby * (high - low), low, high);
  };
  Gains gains;
  gains.velocity_compensation = drawn("velocity_compensation", &Gains::velocity_compensation, 0.4, 1.1);
  gains.force_1_s = drawn("force_1_s", &Gains::force_1_s, 250.0, 900.0);
  // Half of the first candidates have no integral.
  gains.integral_1_s2 = std::max(0.0, drawn("integral_1_s2", &Gains::integral_1_s2, -5000.0, 5000.0));
  gains.velocity_lead_s = drawn("velocity_lead_s", &Gains::velocity_lead_s, 0.0, 0.004);
  gains.swing_gain = drawn("swing_gain", &Gains::swing_gain, 0.6, 1.5);
  gains.observer_1_s = with_observer ? drawn("observer_1_s", &Gains::observer_1_s, 0.0, 200.0) : 0.0;
  return gains;
}

}  // namespace

FixedSearch::FixedSearch(const robot::Robot& on_ground, bool with_observer)
    : on_ground_(on_ground),
      with_observer_(with_observer),
      kind_(with_observer ? "candidate with observer" : "candidate") {
  candidates_.push_back({.number = 0, .gains = on_ground.joints.front().feedback_linearisation});
  while (candidates_.size() < kCandidates) {
    const auto number = static_cast<int>(candidates_.size());
    candidates_.push_back({.number = number, .gains = drawn_gains(number, with_observer)});
  }
}

std::vector<TrotJob> FixedSearch::next() {
  if (static_cast<std::size_t>(round_) == kSeedsOfRound.size()) {
    return {};
  }
  designs_.clear();
  designs_.reserve(candidates_.size() * kStudyConditions.size());
  candidate_of_.clear();
  std::vector<TrotJob> jobs;
  // Seeds go on where the last round ended.
  std::uint64_t first = kFirstSeed;
  for (int round = 0; round < round_; ++round) {
    first += static_cast<std::uint64_t>(kSeedsOfRound[static_cast<std::size_t>(round)]);
  }
  const std::uint64_t end = first + static_cast<std::uint64_t>(kSeedsOfRound[static_cast<std::size_t>(round_)]);
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    for (const StudyCondition& condition : kStudyConditions) {
      designs_.push_back(
          fixed_design(on_ground_, kind_ + " " + std::to_string(candidates_[i].number), "", candidates_[i].gains));
      StudyDesign& design = designs_.back();
      design.robot = with_gait(design.robot, condition);
      for (const PlantRow& row : plant_rows()) {
        for (std::uint64_t seed = first; is_searched(row, round_) && seed < end; ++seed) {
          jobs.push_back({&design.robot, study_case(design, row, condition, seed)});
          candidate_of_.push_back(i);
        }
      }
    }
  }
  return jobs;
}

void FixedSearch::take(std::span<const TrotRow> rows) {
  for (std::size_t i = 0; i < rows.size() && i < candidate_of_.size(); ++i) {
    Candidate& candidate = candidates_[candidate_of_[i]];
    ++candidate.runs;
    if (is_lost(rows[i])) {
      ++candidate.falls;
    } else {
      candidate.errors += stance_nrmse(rows[i].figures.force_nrmse);
    }
  }
  std::ranges::stable_sort(candidates_, {}, [](const Candidate& c) { return std::tuple(c.falls, c.nrmse()); });
  ++round_;
  if (static_cast<std::size_t>(round_) < kSeedsOfRound.size()) {
    candidates_.resize(std::max<std::size_t>(1, candidates_.size() / kKept));
  }
  const std::size_t parents = candidates_.size();
  for (std::size_t i = 0; round_ == kRefined && candidates_.size() < kCandidates; ++i) {
    const auto number = kCandidates + static_cast<int>(i);
    candidates_.push_back(
        {.number = number, .gains = drawn_gains(number, with_observer_, &candidates_[i % parents].gains)});
  }
}

}  // namespace farrier::trials
