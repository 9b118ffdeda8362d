#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "report/figures/outcome.hpp"

namespace farrier::cli {

/// One part of a long measurement.
struct Part {
  std::string name;  ///< unique among the parts: "lockstep cyclone"
  /// Adds its figures. Refuses, or throws a std::exception, when it cannot go on; figures added before then stay.
  std::function<Result<Done>(report::Figures&)> measure;
};

/// Measures parts one after another and keeps what came of each in a file, which is replaced after every part. A part that
/// fails costs the others nothing.
class PartsRun {
 public:
  /// `path`: of the file. `origin`: what the figures depend on besides the parts, such as the build and the options; parts
  /// of another origin are never taken over.
  PartsRun(std::string path, std::string origin) : path_(std::move(path)), origin_(std::move(origin)) {}

  /// Reads the file and returns the names of the parts that it has from a run of the same origin that did not fail; run()
  /// does not measure them again. No file, and one that is no such file, has none.
  std::vector<std::string> take_over();

  /// Measures every part that is not taken over and adds all figures to the outcome, in the order of the parts. A part that
  /// failed is a failure of the outcome, "<part>: <reason>"; so is one that was not begun because `stopped` said true, and
  /// a file that could not be written.
  void run(std::span<const Part> parts, report::Outcome& outcome, const std::function<bool()>& stopped);

 private:
  struct Measured {
    std::string name;
    std::string failure;  ///< empty: it did not fail
    report::Figures figures;
  };

  const Measured* find(const std::string& name) const;
  void measure(const Part& part);
  Result<Done> write() const;

  std::string path_;
  std::string origin_;
  std::vector<Measured> measured_;  ///< also parts that are taken over and that run() is not given
};

}  // namespace farrier::cli
