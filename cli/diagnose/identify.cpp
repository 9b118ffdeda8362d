// farrier identify: what the estimators make of a recording, joint by joint.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <memory>

#include "control/model/model_rows.hpp"
#include "core/replace_file.hpp"
#include "estimation/poles.hpp"
#include "monitor/load_mass.hpp"
#include "participant/loop.hpp"
#include "cli/base/command.hpp"
#include "cli/base/long_work.hpp"
#include "cli/base/output_file.hpp"
#include "monitor/poles_text.hpp"
#include "tools/playback/csv_row.hpp"
#include "tools/playback/identify.hpp"
#include "report/figures/text_format.hpp"

namespace farrier::cli {
namespace {

using signals::JointModelEstimate;

struct IdentifyOptions {
  std::string path;
  std::string joint;
  std::string estimator;
  std::string csv_path;
};

/// Every estimate as a row: its time and the fields of joint/model_estimate. The file has its name once it is whole.
class EstimatesFile {
 public:
  EstimatesFile(const std::string& path, double period_s)
      : path_(path), file_(part_path(path), std::ios::binary), period_s_(period_s) {
    std::string head = "time_s,joint_name";
    JointModelEstimate any;
    playback::visit_all_columns(any, [&](const std::string& name, const auto&) { head += ',' + name; });
    file_ << head << '\n';
  }

  void write(const JointModelEstimate& estimate, const std::string& joint) {
    std::string row;
    playback::append_cell(row, static_cast<double>(estimate.tick) * period_s_);
    row += ',' + joint;
    playback::visit_all_columns(estimate, [&](const std::string&, const auto& value) {
      row += ',';
      playback::append_cell(row, value);
    });
    file_ << row << '\n';
  }

  ~EstimatesFile() { std::remove(part_path(path_).c_str()); }
  EstimatesFile(const EstimatesFile&) = delete;
  EstimatesFile& operator=(const EstimatesFile&) = delete;

  bool ended_well() { return file_.flush() && name_part(path_).ok(); }

 private:
  std::string path_;
  std::ofstream file_;
  double period_s_;
};

std::string poles_text(const JointModelEstimate& estimate) {
  return monitor::poles_text(estimation::poles<3>(control::model_of_rows(estimate.a, estimate.b).a));
}

std::string mass_text(const JointModelEstimate& estimate, double period_s) {
  const auto mass = monitor::load_mass(estimate, period_s);
  return mass ? report::short_number(*mass) : "-";
}

/// The last estimate of every joint and phase.
using Last = std::vector<PerPhase<JointModelEstimate>>;

void print(const robot::Robot& robot, const Last& last) {
  std::vector<std::vector<std::string>> rows{
      {"joint", "phase", "samples", "validity", "prediction error", "load mass", "poles"}};
  for (const robot::Joint& joint : robot.joints) {
    for (const JointModelEstimate& estimate : last[joint.number]) {
      if (estimate.tick != kNoTick) {
        rows.push_back({joint.name, to_string(estimate.phase), std::to_string(estimate.samples),
                        report::short_number(estimate.validity), report::short_number(estimate.prediction_error),
                        mass_text(estimate, robot.period_s), poles_text(estimate)});
      }
    }
  }
  std::fputs(report::aligned(rows).c_str(), stdout);
}

int identify(const IdentifyOptions& o) {
  robot::Overrides overrides;
  if (!o.estimator.empty()) {
    overrides.estimator = o.estimator;
  }
  auto run = playback::RecordedRun::open(o.path, overrides, long_work("identify, reading"));
  if (!run) {
    return refuse("identify", run.error().message);
  }
  const robot::Robot& robot = run.value().robot();
  const robot::Joint* const only = o.joint.empty() ? nullptr : robot.find(o.joint);
  if (!o.joint.empty() && only == nullptr) {
    return refuse("identify", "--joint: " + o.path + " is of " + robot.name + ", which has no joint '" + o.joint + "'");
  }
  if (auto way = make_way({o.csv_path}, {o.path}); !way) {
    return refuse("identify", way.error().message);
  }
  const playback::Measurements measured = playback::read_measurements(run.value());
  if (participant::stop_requested()) {
    return participant::stop_status();
  }
  std::unique_ptr<EstimatesFile> file;
  if (!o.csv_path.empty()) {
    file = std::make_unique<EstimatesFile>(o.csv_path, robot.period_s);
  }
  Last last(robot.joints.size());
  std::uint64_t estimates = 0;
  const auto fed = playback::identify(
      measured, robot,
      [&](const JointModelEstimate& estimate) {
        if (only != nullptr && estimate.joint != only->number) {
          return;
        }
        ++estimates;
        last[estimate.joint][estimate.phase] = estimate;
        if (file) {
          file->write(estimate, robot.joints[estimate.joint].name);
        }
      },
      long_work("identify"));
  if (participant::stop_requested()) {
    return participant::stop_status();
  }
  if (!fed) {
    return refuse("identify", fed.error().message);
  }
  if (estimates == 0) {
    const std::string whose = only == nullptr ? "" : " of " + o.joint;
    return refuse("identify", o.path + " has no joint/measurement" + whose + ": " +
                                  (measured.ending.empty() ? "record that topic" : measured.ending));
  }
  print(robot, last);
  if (measured.late > 0) {
    std::fprintf(stderr,
                 "farrier identify: %llu measurements repeat earlier ticks, as of another run, and are left out\n",
                 static_cast<unsigned long long>(measured.late));
  }
  if (file && !file->ended_well()) {
    return fail("identify", "cannot write " + o.csv_path + ": is the disk full?");
  }
  if (file) {
    std::printf("estimates: %s\n", o.csv_path.c_str());
  }
  return measured.ending.empty() ? kPassed : fail("identify", o.path + ": " + measured.ending);
}

}  // namespace

std::function<int()> declare_identify(CLI::App& app) {
  auto o = std::make_shared<IdentifyOptions>();
  app.add_option("file", o->path, "recording with joint/measurement, as farrier record makes it")
      ->required()
      ->type_name("<file>");
  app.add_option("--joint", o->joint, "this joint alone")->type_name("<name>");
  app.add_option("--estimator", o->estimator, "estimator of the robot file that every joint uses, such as grey_box")
      ->type_name("<name>")
      ->default_str("each joint's own");
  app.add_option("--csv", o->csv_path, "where every estimate goes, with its time")->type_name("<file>");
  return [o] { return identify(*o); };
}

}  // namespace farrier::cli
