#pragma once

// A study: a figure or table of Hubacher (2014), computed again, with the claims its text makes about it. README.md
// says how to add one.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/number_as.hpp"  // for notes
#include "core/result.hpp"
#include "report/page/picture.hpp"
#include "robot/robot.hpp"
#include "thesis/study/claim.hpp"

namespace farrier::thesis {

struct Measured {
  std::string id;                                        ///< of a claim of the study
  double value;                                          ///< not finite: could not be measured
  std::string note;                                      ///< what it was made of, for people; may be empty
  std::optional<double> under_condition = std::nullopt;  ///< the same measurement of a run under the claim's condition
};

/// A value that a study measures and no claim judges.
struct StudyFigure {
  std::string id;  ///< as a claim's; "reproduce." before it names the figure
  double value;    ///< not finite: there is none
  const char* unit;
  const char* meaning;  ///< what was measured, as a sentence
};

using report::Panel;
using report::Picture;
using report::Series;
using report::Style;

struct StudyResult {
  std::vector<Measured> measured;
  std::vector<Picture> pictures;
  std::vector<StudyFigure> figures = {};
};

struct StudyContext {
  std::string robots;  ///< folder of the shipped robot files
  std::uint64_t seed = 1;
  std::function<bool(double)> progress;  ///< told the share done, [0, 1], now and then; false: stop
};

struct Study {
  const char* number;                 ///< as the text counts: "7.8", "A.2"; a table's begins with T: "T6.1"
  const char* title;                  ///< one line
  std::span<const ClaimSpec> claims;  ///< empty for a figure that shows inputs alone
  /// Refuses when it cannot be run, and with stopped() when progress says stop. May run in any thread.
  Result<StudyResult> (*run)(const StudyContext& context);
  const char* conditions = "";  ///< machine, sensors, estimator and design of its runs, in sentences
};

/// The error of a study that was told to stop.
Error stopped();

/// Reports `share`; false when the study must stop.
bool keep_going(const StudyContext& context, double share);

/// The robot of a shipped file, such as "fc1d.yaml".
Result<robot::Robot> load(const StudyContext& context, const std::string& file);

/// `count` >= 2 values from low to high; both > 0 for the logarithmic one.
std::vector<double> linear_space(double low, double high, std::size_t count);
std::vector<double> log_space(double low, double high, std::size_t count);

}  // namespace farrier::thesis
