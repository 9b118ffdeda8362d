#include "cli/diagnose/diagnose_scaled.hpp"

#include <cstdio>
#include <filesystem>
#include <optional>

#include "diagnosis/judge/scaled_diagnosis.hpp"
#include "cli/base/command.hpp"
#include "cli/base/output_file.hpp"
#include "cli/base/with_bar.hpp"
#include "report/diagnosis/scaled_json.hpp"
#include "report/diagnosis/scaled_page.hpp"
#include "report/diagnosis/scaled_text.hpp"

namespace farrier::cli {
namespace {

namespace fs = std::filesystem;

/// Returns why an option is impossible for data without units; empty if none is.
std::string refusal(const DiagnoseOptions& o) {
  if (o.benchmark) {
    return "--benchmark makes recordings in SI units: leave one of the two out";
  }
  if (!o.model_path.empty() || !o.joint.empty()) {
    return std::string(o.model_path.empty() ? "--joint" : "--model") +
           " is of a machine in SI units, and a recording in units of its own fits none: leave it out, or give a "
           "recording in SI units without --units";
  }
  return o.recording.empty() ? "name a recording; see 'farrier diagnose --help'" : "";
}

int finish(const report::ScaledResult& result, const std::string& json, const std::string& out) {
  const bool bad = result.diagnosis == nullptr;
  report::Outcome outcome;
  outcome.command = "diagnose";
  outcome.run = report::run_info(0);
  outcome.finding = diagnosis::to_string(result.verdict());
  if (bad) {
    outcome.failures.push_back("the recording cannot be judged");
    std::fputs(diagnosis::to_string(result.findings, result.recording).c_str(), stderr);
  } else {
    report::add_diagnosis(outcome.figures, *result.diagnosis);
    std::fputs(report::scaled_console(result).c_str(), stdout);
  }
  if (!json.empty()) {
    if (auto written = report::write_scaled_json(json, result, outcome); !written) {
      return fail("diagnose --units scaled", written.error().message);
    }
  }
  if (!out.empty()) {
    const auto page = report::write_scaled_page(out, result, outcome);
    if (!page) {
      return fail("diagnose --units scaled", page.error().message);
    }
    std::printf("report: %s\n", page.value().c_str());
  }
  if (!json.empty()) {
    std::printf("figures: %s\n", json.c_str());
  }
  return bad ? kBadInput : kPassed;
}

}  // namespace

int diagnose_scaled(const DiagnoseOptions& o) {
  if (const std::string why = refusal(o); !why.empty()) {
    return refuse("diagnose --units scaled", why);
  }
  std::optional<OutputDirectory> directory;
  if (!o.out.empty()) {
    auto claimed = OutputDirectory::claim(o.out);
    if (!claimed) {
      return refuse("diagnose --units scaled", claimed.error().message);
    }
    directory.emplace(std::move(claimed).value());
  }
  const auto in_out = [&](const char* name) { return o.out.empty() ? "" : (fs::path(o.out) / name).string(); };
  const std::string json = o.json_path.empty() ? in_out("figures.json") : o.json_path;
  if (const auto free = make_way({json, in_out("index.html")}, {o.recording}); !free) {
    return refuse("diagnose --units scaled", free.error().message);
  }
  const auto recording = diagnosis::read_scaled_recording(o.recording);
  if (!recording) {
    return finish({.diagnosis = nullptr, .recording = o.recording, .findings = recording.error().findings}, json,
                  o.out);
  }
  std::optional<diagnosis::ScaledDiagnosis> found;
  with_bar("diagnose", [&](const auto& progress) {
    diagnosis::DiagnosisOptions options;
    options.threads = o.threads;
    options.progress = progress;
    found = diagnosis::diagnose_scaled(recording.value(), options);
  });
  return finish({.diagnosis = &*found, .recording = o.recording}, json, o.out);
}

}  // namespace farrier::cli
