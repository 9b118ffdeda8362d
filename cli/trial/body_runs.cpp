#include "cli/trial/body_runs.hpp"

#include <algorithm>
#include <cstdio>

#include "cli/base/progress.hpp"
#include "participant/loop.hpp"
#include "report/body/body_rows_file.hpp"

namespace farrier::cli {

std::string key_of(const std::string& trial, const std::string& name) { return trial + ": " + name; }

BodyRuns::BodyRuns(Settings settings) : settings_(std::move(settings)) {
  if (settings_.go_on) {
    for (trials::TrotRow& row : report::read_rows(settings_.kept_path, settings_.origin)) {
      rows_.insert_or_assign(key_of(row.trial, row.name), std::move(row));
    }
  }
}

std::vector<trials::TrotRow> BodyRuns::run(const std::string& title, const std::vector<trials::TrotJob>& jobs) {
  std::vector<trials::TrotJob> left;
  std::ranges::copy_if(jobs, std::back_inserter(left), [this](const trials::TrotJob& job) {
    return !rows_.contains(key_of(job.one.trial, job.one.name));
  });
  auto ended = static_cast<Tick>(jobs.size() - left.size());
  if (settings_.go_on) {
    std::fprintf(stderr, "%s: has %lld of %zu runs\n", settings_.kept_path.c_str(), static_cast<long long>(ended),
                 jobs.size());
  }
  Progress bar(title, static_cast<Tick>(jobs.size()), "runs");
  const auto done = [&](const trials::TrotRow& row) {
    keep(row);
    bar.update(++ended);
  };
  trials::run_trot_jobs(left, settings_.joints, settings_.threads, done, [] { return !participant::stop_requested(); });
  std::vector<trials::TrotRow> rows;
  for (const trials::TrotJob& job : jobs) {
    if (const auto row = rows_.find(key_of(job.one.trial, job.one.name)); row != rows_.end()) {
      rows.push_back(row->second);
    }
  }
  return rows;
}

void BodyRuns::keep(const trials::TrotRow& row) {
  if (row.failure.empty()) {
    if (const auto written = report::append_row(settings_.kept_path, settings_.origin, row); !written) {
      not_kept_ = written.error().message;
    }
  }
  rows_.insert_or_assign(key_of(row.trial, row.name), row);
}

}  // namespace farrier::cli
