#include "thesis/report/run_studies.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <numeric>
#include <thread>

#include "core/ensure.hpp"

namespace farrier::thesis {
namespace {

/// An exception, such as of memory that is not there, is that study's failure.
Result<StudyResult> run_study(const Study& study, const StudyContext& context) {
  try {
    return study.run(context);
  } catch (const std::exception& thrown) {
    return Error{thrown.what()};
  }
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
}

/// Every number of a result: values, figures, and the points of the pictures.
std::vector<double> numbers_of(const StudyResult& result) {
  std::vector<double> numbers;
  for (const Measured& one : result.measured) {
    numbers.push_back(one.value);
    numbers.push_back(one.under_condition.value_or(0.0));
  }
  for (const StudyFigure& one : result.figures) {
    numbers.push_back(one.value);
  }
  for (const Picture& picture : result.pictures) {
    for (const Panel& panel : picture.panels) {
      for (const Series& series : panel.series) {
        numbers.insert(numbers.end(), series.y.begin(), series.y.end());
      }
    }
  }
  return numbers;
}

bool draws_nothing(const StudyRun& run) {
  return run.seeds.size() > 1 && run.seeds[0].result.ok() && run.seeds[1].result.ok() &&
         same(numbers_of(run.seeds[0].result.value()), numbers_of(run.seeds[1].result.value()));
}

void drop_pictures(SeedRun& run) {
  if (run.result.ok()) {
    StudyResult kept = std::move(run.result).value();
    kept.pictures.clear();
    run.result = std::move(kept);
  }
}

/// One study with one seed.
struct Job {
  std::size_t study, seed;
};

/// Runs jobs on several threads and tells the progress of all of them.
class Jobs {
 public:
  Jobs(std::vector<StudyRun>& runs, const StudyContext& context, int threads, const Progress& progress)
      : runs_(runs),
        context_(context),
        threads_(threads),
        progress_(progress),
        stride_(runs.front().seeds.size()),
        shares_(runs.size() * stride_, 0.0) {}

  void run(const std::vector<Job>& jobs) {
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
      for (std::size_t i = next++; i < jobs.size() && !stop_; i = next++) {
        run(jobs[i]);
      }
    };
    std::vector<std::jthread> helpers;
    for (int i = 1; i < threads_; ++i) {
      helpers.emplace_back(work);
    }
    work();
    helpers.clear();  // joins
  }

  bool tell(const Job& job, double share) {
    const std::lock_guard lock(mutex_);
    double& own = shares_[job.study * stride_ + job.seed];
    own = std::clamp(share, own, 1.0);
    const double sum = std::accumulate(shares_.begin(), shares_.end(), 0.0);
    if (!progress_(sum / static_cast<double>(shares_.size()))) {
      stop_ = true;
    }
    return !stop_;
  }

 private:
  void run(const Job& job) {
    StudyContext own = context_;
    SeedRun& one = runs_[job.study].seeds[job.seed];
    own.seed = one.seed;
    own.progress = [this, job](double share) { return tell(job, share); };
    one.result = run_study(runs_[job.study].study, own);
    if (job.seed > 1) {
      drop_pictures(one);
    }
    tell(job, 1.0);
  }

  std::vector<StudyRun>& runs_;
  const StudyContext& context_;
  int threads_;
  const Progress& progress_;
  std::mutex mutex_;  ///< shares_ and progress_
  std::size_t stride_;
  std::vector<double> shares_;
  std::atomic<bool> stop_ = false;
};

}  // namespace

std::vector<StudyRun> run_studies(std::span<const Study> studies, const StudyContext& context,
                                  std::span<const std::uint64_t> seeds, int threads, const Progress& progress) {
  FARRIER_ENSURE(!seeds.empty(), "studies run with at least one seed");
  std::vector<StudyRun> runs;
  for (const Study& study : studies) {
    runs.push_back({study, {}});
    for (const std::uint64_t seed : seeds) {
      runs.back().seeds.push_back({seed, stopped()});
    }
  }
  if (runs.empty()) {
    return runs;
  }
  Jobs all(runs, context, threads, progress);
  std::vector<Job> first, others;
  for (std::size_t seed = 0; seed < std::min<std::size_t>(seeds.size(), 2); ++seed) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      first.push_back({i, seed});
    }
  }
  all.run(first);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const bool once = draws_nothing(runs[i]);
    if (runs[i].seeds.size() > 1) {
      drop_pictures(runs[i].seeds[1]);
    }
    for (std::size_t seed = 2; seed < seeds.size(); ++seed) {
      if (once) {
        all.tell({i, seed}, 1.0);
      } else {
        others.push_back({i, seed});
      }
    }
    if (once) {
      runs[i].seeds.erase(runs[i].seeds.begin() + 1, runs[i].seeds.end());
    }
  }
  all.run(others);
  return runs;
}

}  // namespace farrier::thesis
