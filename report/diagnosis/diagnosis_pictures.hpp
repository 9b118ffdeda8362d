#pragma once

#include <string>
#include <vector>

#include "core/result.hpp"
#include "report/diagnosis/diagnosis_result.hpp"

namespace farrier::report {

/// Samples from which a picture of the worst second begins, and how many it shows.
struct WorstWindow {
  std::size_t begin, size;
};

/// The second in which a simulation is furthest off in the mean square; the whole of a shorter recording.
WorstWindow worst_second(const std::vector<double>& measured, const std::vector<double>& simulated, double period_s);

/// Pictures of one channel, paths relative to the report; empty for what there is no data of.
struct ChannelPictures {
  std::string time;        ///< measured and simulated over the worst second, errors below
  std::string dependence;  ///< residual before over each driver, by bins
  std::string spectrum;    ///< residual's power density before and after
};

struct DiagnosisPictures {
  std::vector<ChannelPictures> channels;  ///< as in the diagnosis
  std::string wiring;                     ///< both sides of the law that shows a fault of wiring
  std::vector<std::string> rounds;        ///< candidates' gains with their intervals, one per round that has any
};

/// Draws them. Refuses as Drawing::draw does.
Result<DiagnosisPictures> draw_diagnosis(const std::string& out_dir, const DiagnosisResult& result);

}  // namespace farrier::report
