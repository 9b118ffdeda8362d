#pragma once

#include <span>
#include <string>
#include <vector>

#include "trials/body/adaptation_study.hpp"

namespace farrier::trials {

/// Searches one fixed design for all plants, by successive halving (Jamieson and Talwalkar 2016) with one refinement. The
/// file's gains and gains that are drawn at random walk through rows in which fixed designs differ. The best quarter goes
/// on beside gains that are drawn around them. The best quarter of those goes on with more rows, and the best of these with
/// more seeds. Fewer falls are better, then a smaller force error in stance. Terrains and seeds are not those of the study.
class FixedSearch {
 public:
  /// `with_observer`: the bandwidth of the disturbance observer is drawn too. The robot must outlive the search.
  FixedSearch(const robot::Robot& on_ground, bool with_observer);
  FixedSearch(const FixedSearch&) = delete;
  FixedSearch& operator=(const FixedSearch&) = delete;

  /// Runs of the next round; none: the search has ended.
  std::vector<TrotJob> next();
  /// Takes the rows of that round, in their order. A failure counts as a fall.
  void take(std::span<const TrotRow> rows);

  /// A candidate after some rounds, with all its runs so far.
  struct Candidate {
    int number;  ///< 0: the file's gains
    control::FeedbackLinearisationGains gains;
    int falls = 0, runs = 0;
    double errors = 0.0;  ///< sum over the runs without a fall
    double nrmse() const noexcept { return runs > falls ? errors / (runs - falls) : 0.0; }
  };
  /// Those that are left, the best first.
  const std::vector<Candidate>& candidates() const noexcept { return candidates_; }
  int round() const noexcept { return round_; }

 private:
  const robot::Robot& on_ground_;
  bool with_observer_;
  std::string kind_;  // of candidates, in the names of runs
  std::vector<Candidate> candidates_;
  std::vector<StudyDesign> designs_;       // of the round, by condition and candidate
  std::vector<std::size_t> candidate_of_;  // of each job of the round
  int round_ = 0;
};

}  // namespace farrier::trials
