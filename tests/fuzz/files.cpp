// Files that were measured or recorded, on other machines and by other programs.

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "diagnosis/data/recording_check.hpp"
#include "diagnosis/data/scaled_recording.hpp"
#include "diagnosis/data/trace_recording.hpp"
#include "trace/trace.hpp"
#include "recording/recording_file.hpp"
#include "signals/cdr.hpp"
#include "tests/fuzz/harness.hpp"
#include "tests/fuzz/robots.hpp"

namespace farrier::fuzz {
namespace {

/// A file in memory that has a path.
class File {
 public:
  explicit File(Bytes bytes) : descriptor_(memfd_create("fuzz", 0)) {
    require(descriptor_ >= 0 && write(descriptor_, bytes.data(), bytes.size()) == static_cast<ssize_t>(bytes.size()),
            "the machine has memory for a file");
  }
  ~File() { close(descriptor_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

 private:
  int descriptor_;
};

bool finite(const std::vector<double>& values) {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

void require_findings(const std::vector<diagnosis::Finding>& findings) {
  require(!findings.empty(), "a refusal says why");
  require(std::ranges::none_of(findings, [](const auto& finding) { return finding.text.empty(); }),
          "every finding has its sentence");
}

void require_sound(const diagnosis::Recording& recording, const robot::Joint& joint) {
  for (const auto* column :
       {&recording.time_s, &recording.position, &recording.velocity, &recording.force, &recording.valve_current_A,
        &recording.pressure_a_Pa, &recording.pressure_b_Pa, &recording.supply_pressure_Pa}) {
    require(column->empty() || column->size() == recording.time_s.size(), "all columns are equally long");
    require(finite(*column), "all samples are finite");
  }
  require(recording.time_s.size() >= diagnosis::kFewestSamples, "a recording is long enough");
  diagnosis::check_recording(recording, joint);
}

}  // namespace

void recording(Bytes bytes) {
  const robot::Joint& joint = hyq().joints.front();
  for (const std::string& name : {std::string(), joint.name}) {
    const auto read = diagnosis::read_recording(File(bytes).path(), name);
    if (!read) {
      require_findings(read.error().findings);
    } else {
      require_sound(read.value(), joint);
    }
  }
}

void scaled_recording(Bytes bytes) {
  const auto read = diagnosis::read_scaled_recording(File(bytes).path());
  if (!read) {
    return require_findings(read.error().findings);
  }
  require(finite(read.value().valve) && finite(read.value().position), "all samples are finite");
  require(read.value().valve.size() == read.value().position.size(), "all columns are equally long");
}

void trace(Bytes bytes) {
  const File file(bytes);
  std::vector<std::string> names;
  for (const robot::Joint& joint : hyq().joints) {
    names.push_back(joint.name);
  }
  if (const auto rows = trace::read_trace(file.path(), names)) {
    for (const trace::TraceRow& row : rows.value()) {
      require(row.joint < names.size(), "a row is of a joint there is");
    }
  }
  const robot::Joint& joint = hyq().joints.front();
  const auto read = diagnosis::recording_of_trace(file.path(), hyq(), joint);
  if (!read) {
    return require_findings(read.error().findings);
  }
  require_sound(read.value(), joint);
}

void run_file(Bytes bytes) {
  const File file(bytes);
  auto reader = farrier::recording::RunFileReader::open(file.path());
  if (!reader) {
    return require(!reader.error().message.empty(), "a refusal says why");
  }
  std::uint64_t elapsed_ns = 0;
  for (farrier::recording::Sample sample; reader.value().next(sample);) {
    require(sample.elapsed_ns >= elapsed_ns, "elapsed time does not go back");
    elapsed_ns = sample.elapsed_ns;
    require(static_cast<std::size_t>(sample.topic) < bus::kTopicCount, "a sample is of a topic that there is");
    signals::JointMeasurement measurement;
    require(!signals::from_cdr(sample.cdr, measurement) ||
                sample.cdr.size() >= signals::cdr_size<signals::JointMeasurement>(),
            "what is read is all there");
  }
  farrier::recording::Sample none;
  require(!reader.value().next(none), "the end stays the end");
  require(reader.value().damaged_samples() == 0 || !reader.value().ending().empty(), "damaged samples are named");
  require(
      farrier::recording::step_texts(reader.value().timeline()).size() <=
          std::min<std::uint64_t>(reader.value().timeline().step_count(), farrier::recording::Timeline::kMostSteps + 1),
      "steps are named, and not more than there are");
  const bool own = reader.value().samples() > 0;
  require(!own || reader.value().nothing_of_farrier().empty(), "a file with samples has something of Farrier");
  mcap::find_metadata(file.path(), farrier::recording::kRunFacts);
}

}  // namespace farrier::fuzz
