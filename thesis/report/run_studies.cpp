#include "thesis/report/run_studies.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <numeric>
#include <thread>

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

}  // namespace

std::vector<StudyRun> run_studies(std::span<const thesis::Study> studies, const thesis::StudyContext& context,
                                  int threads, const Progress& progress) {
  std::vector<StudyRun> runs;
  for (const thesis::Study& study : studies) {
    runs.push_back({study, thesis::stopped()});
  }
  std::vector<double> shares(studies.size(), 0.0);
  std::mutex mutex;  // shares and progress
  std::atomic<bool> stop = false;
  std::atomic<std::size_t> next = 0;

  const auto told = [&](std::size_t i, double share) {
    const std::lock_guard lock(mutex);
    shares[i] = std::clamp(share, shares[i], 1.0);
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    if (!progress(sum / static_cast<double>(shares.size()))) {
      stop = true;
    }
    return !stop;
  };
  const auto work = [&] {
    for (std::size_t i = next++; i < runs.size() && !stop; i = next++) {
      thesis::StudyContext own = context;
      own.progress = [&told, i](double share) { return told(i, share); };
      runs[i].result = run_study(runs[i].study, own);
      told(i, 1.0);
    }
  };
  std::vector<std::jthread> helpers;
  for (int i = 1; i < threads; ++i) {
    helpers.emplace_back(work);
  }
  work();
  helpers.clear();  // joins
  return runs;
}

}  // namespace farrier::thesis
