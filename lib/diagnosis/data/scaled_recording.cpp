#include "diagnosis/data/scaled_recording.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>
#include <utility>

#include "diagnosis/data/csv_columns.hpp"
#include "diagnosis/judge/finding_text.hpp"
#include "diagnosis/data/sample_statistics.hpp"

namespace farrier::diagnosis {
namespace {

/// Columns, in the order of kScaledNames.
enum Column : std::size_t { kSample, kValve, kPosition };

constexpr double kLeastSpan = 1e-6;
constexpr double kMostMagnitude = 1e6;

const std::vector<std::string> kScaledNames = {"sample", "valve", "position"};

void check_scaled_names(CsvColumns& csv) {
  for (std::size_t i = 0; i < kScaledNames.size(); ++i) {
    if (!csv.present[i]) {
      csv.findings.push_back({"missing_column", csv.header_line,
                              "line " + std::to_string(csv.header_line) + ", column " + kScaledNames[i] +
                                  " is missing; a recording in scaled units has sample, valve and position"});
    }
  }
}

/// Sample numbers count the rows: one that is missing moves everything behind it.
void check_numbers(std::span<const double> sample, std::span<const std::size_t> line, std::vector<Finding>& findings) {
  Places broken, repeated, backwards, missing;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    if (std::isfinite(sample[i]) && std::abs(sample[i] - std::round(sample[i])) > 0.0) {
      broken.add(line[i]);
    }
    const double step = i > 0 ? sample[i] - sample[i - 1] : 1.0;
    if (std::abs(step) <= 0.0) {
      repeated.add(line[i]);
    } else if (step < 0.0) {
      backwards.add(line[i]);
    } else if (step > 1.0) {
      missing.add(line[i]);
    }
  }
  const auto add = [&](const char* what, const Places& places, const std::string& sentence) {
    if (places.count() > 0) {
      findings.push_back({what, places.first(), places.text() + ", column sample: " + sentence});
    }
  };
  add("not_whole", broken,
      counted(broken.count(), "number") + " not whole; count the samples 0, 1, 2, ... (with times in seconds, give a "
                                          "recording in SI units and --model)");
  add("duplicate_sample", repeated,
      counted(repeated.count(), "row") + " with the number of the row before; delete repeated rows");
  add("sample_backwards", backwards,
      "goes back " + counted(backwards.count(), "time") +
          "; put the rows in the order of their samples, or keep one recording of several");
  add("missing_sample", missing,
      "samples are missing before " + counted(missing.count(), "row") +
          "; keep the longest part without a gap, or record without loss");
}

/// Each half is fitted and judged for itself: in neither may a column stand still.
void check_values(const std::string& name, std::span<const double> values, std::span<const std::size_t> line,
                  std::vector<Finding>& findings) {
  if (values.size() < kFewestSamples || std::ranges::any_of(values, [](double v) { return !std::isfinite(v); })) {
    return;
  }
  const std::size_t middle = values.size() / 2;
  const auto span_of = [](std::span<const double> part) { return std::ranges::max(part) - std::ranges::min(part); };
  const double all = span_of(values);
  if (all <= 0.0) {
    findings.push_back({"constant", 0, "column " + name + " is " + rounded(values.front()) +
                                           " throughout; record an arm that moves, with the valve to either side"});
  } else if (all < kLeastSpan || magnitude(values, 1.0) > kMostMagnitude) {
    findings.push_back({"out_of_range", 0,
                        "column " + name + " spans " + rounded(all) + " about " + rounded(values.front()) +
                            "; scale it so that its values are of the order of one"});
  } else {
    for (const std::size_t begin : {std::size_t{0}, middle}) {
      if (span_of(values.subspan(begin, begin == 0 ? middle : values.size() - middle)) <= 0.0) {
        findings.push_back({"constant", line[begin],
                            "line " + std::to_string(line[begin]) + ", column " + name + " is constant over the " +
                                (begin == 0 ? "first" : "second") + " half; keep a part that moves throughout"});
      }
    }
  }
}

}  // namespace

Result<ScaledRecording, RecordingProblems> read_scaled_recording(const std::string& path) {
  CsvColumns csv = read_columns(path, kScaledNames);
  if (!csv.header.empty()) {
    check_scaled_names(csv);
    if (csv.present[kSample]) {
      check_numbers(csv.columns[kSample], csv.line, csv.findings);
    }
    for (const Column column : {kValve, kPosition}) {
      check_values(kScaledNames[column], csv.columns[column], csv.line, csv.findings);
    }
    if (csv.line.size() < kFewestSamples) {
      csv.findings.push_back({"too_short", 0, "the file holds " + counted(csv.line.size(), "sample") +
                                                  "; record at least " + counted(kFewestSamples, "sample")});
    }
  }
  if (!csv.findings.empty()) {
    sort_by_line(csv.findings);
    return RecordingProblems{std::move(csv.findings)};
  }
  ScaledRecording recording;
  recording.source = std::filesystem::path(path).filename().string();
  recording.valve = std::move(csv.columns[kValve]);
  recording.position = std::move(csv.columns[kPosition]);
  for (const std::string& name : csv.header) {
    if (std::ranges::find(kScaledNames, name) == kScaledNames.end()) {
      recording.remarks.push_back((name.empty() ? "A column without a name" : "Column " + shown(name)) +
                                  " is not read: the model goes from the valve to the position.");
    }
  }
  return recording;
}

}  // namespace farrier::diagnosis
