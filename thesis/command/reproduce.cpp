// farrier reproduce: studies of Hubacher (2014), each claim of the text with what was measured and a verdict.

#include <CLI/CLI.hpp>
#include <unistd.h>

#include <cstdio>

#include "thesis/studies/registry.hpp"
#include "participant/loop.hpp"
#include "cli/base/command.hpp"
#include "cli/base/help.hpp"
#include "cli/base/installation.hpp"
#include "cli/base/output_file.hpp"
#include "cli/base/progress.hpp"
#include "thesis/report/pinned_verdicts.hpp"
#include "thesis/report/run_studies.hpp"
#include "thesis/report/study_page.hpp"
#include "thesis/report/study_pictures.hpp"

namespace farrier::cli {
namespace {

struct ReproduceOptions {
  std::vector<std::string> numbers;
  bool list = false;
  std::string out = "out/reproduce";
  std::string json_path;
  bool json_to_stdout = false;  ///< the claims in place of the text, besides figures.json
  std::uint64_t seed = 1;
  int seeds = 7;
  bool pin = false;  ///< prints the verdicts as pinned_verdicts.def has them, in place of the text
  int threads = 2;
};

/// The studies asked for, in the order of the text; refuses numbers there are none of.
Result<std::vector<thesis::Study>> chosen(const std::vector<thesis::Study>& all,
                                          const std::vector<std::string>& numbers) {
  std::vector<thesis::Study> some;
  for (const std::string& number : numbers) {
    if (number != "all" && thesis::find_study(all, number) == nullptr) {
      std::string near;
      for (const std::string& one : thesis::near_numbers(all, number)) {
        near += (near.empty() ? "; near it: " : ", ") + one;
      }
      return Error{"there is no study '" + number + "'" + near + "; see 'farrier reproduce --list'"};
    }
  }
  for (const thesis::Study& study : all) {
    const bool asked = std::ranges::any_of(
        numbers, [&](const std::string& number) { return number == "all" || number == study.number; });
    if (asked) {
      some.push_back(study);
    }
  }
  return some;
}

std::vector<thesis::StudyRun> run_with_bar(const std::vector<thesis::Study>& some, const ReproduceOptions& o) {
  constexpr Tick kSteps = 100;
  participant::install_signal_handlers();
  const thesis::StudyContext context{robots_directory(), o.seed, {}};
  std::vector<std::uint64_t> seeds;
  for (int i = 0; i < o.seeds; ++i) {
    seeds.push_back(o.seed + static_cast<std::uint64_t>(i));
  }
  Progress bar("reproduce", kSteps, "percent");
  return thesis::run_studies(some, context, seeds, o.threads, [&](double share) {
    bar.update(static_cast<Tick>(share * static_cast<double>(kSteps)));
    return !participant::stop_requested();
  });
}

/// True if every run of the study came to its end.
bool ended(const thesis::StudyRun& run) {
  return std::ranges::all_of(run.seeds, [](const thesis::SeedRun& one) { return one.result.ok(); });
}

/// The claims of all studies. Those of a study that a stop kept from its end are left out, and the study is a failure. So
/// is each claim whose verdict is not the pinned one.
report::Outcome outcome_of(const std::vector<thesis::StudyRun>& runs, const ReproduceOptions& o) {
  report::Outcome outcome;
  outcome.command = "reproduce";
  outcome.run = report::run_info(o.seed);
  for (const thesis::StudyRun& run : runs) {
    if (!ended(run) && participant::stop_requested()) {
      outcome.failures.push_back("study " + std::string(run.study.number) + ": " + thesis::stopped().message);
      continue;
    }
    thesis::add_claims(outcome, thesis::claims_of(run));
    thesis::add_figures(outcome, run);
  }
  for (std::string& slide : thesis::slides(outcome.claims)) {
    outcome.failures.push_back(std::move(slide));
  }
  return outcome;
}

void print(const report::Outcome& outcome, const std::vector<thesis::StudyRun>& runs) {
  for (const report::Claim& claim : outcome.claims) {
    std::fputs(thesis::claim_text(claim).c_str(), stdout);
  }
  for (const thesis::StudyRun& run : runs) {
    if (const thesis::StudyResult* result = thesis::shown(run)) {
      for (const thesis::StudyFigure& figure : result->figures) {
        std::fputs(thesis::figure_text(figure).c_str(), stdout);
      }
    }
  }
  std::fputs(thesis::totals_text(outcome).c_str(), stdout);
  for (const std::string& failure : outcome.failures) {
    std::printf("%s\n", failure.c_str());
  }
}

int reproduce_studies(const ReproduceOptions& o) {
  const std::vector<thesis::Study> all = thesis::all_studies();
  if (o.list) {
    for (const thesis::Study& study : all) {
      std::fputs(thesis::listing(study).c_str(), stdout);
    }
    return kPassed;
  }
  if (o.numbers.empty()) {
    return refuse("reproduce", "name a figure such as 8.9, or all; see 'farrier reproduce --list'");
  }
  const auto some = chosen(all, o.numbers);
  if (!some) {
    return refuse("reproduce", some.error().message);
  }
  const auto directory = OutputDirectory::claim(o.out);
  if (!directory) {
    return refuse("reproduce", directory.error().message);
  }
  const std::string json_path = o.json_path.empty() ? o.out + "/figures.json" : o.json_path;
  for (const std::string& path : {json_path, o.out + "/index.html"}) {
    if (const auto free = make_way(path); !free) {
      return refuse("reproduce", free.error().message);
    }
  }
  const auto runs = run_with_bar(some.value(), o);
  const report::Outcome outcome = outcome_of(runs, o);
  // First what was measured: a page that cannot be drawn loses no figure.
  const auto written = report::write_json(json_path, outcome);
  if (o.pin) {
    std::fputs(thesis::pinned_text(outcome.claims).c_str(), stdout);
  } else if (o.json_to_stdout) {
    std::printf("%s", report::to_json(outcome).c_str());
  } else {
    print(outcome, runs);
  }
  if (!written) {
    return fail("reproduce", written.error().message);
  }
  if (participant::stop_requested()) {
    return fail("reproduce", "stopped; " + json_path + " has the claims of the studies that ended; there is no page");
  }
  if (const auto drawn = thesis::draw_studies(o.out, runs); !drawn) {
    return fail("reproduce", drawn.error().message + "; the figures are in " + json_path);
  }
  const auto page = thesis::write_study_page(o.out, outcome, runs);
  if (!page) {
    return fail("reproduce", page.error().message + "; the figures are in " + json_path);
  }
  if (!o.json_to_stdout && !o.pin) {
    std::printf("report: %s\nfigures: %s\n", page.value().c_str(), json_path.c_str());
  }
  return o.pin || outcome.passes() ? kPassed : kFailed;
}

}  // namespace

std::function<int()> declare_reproduce(CLI::App& app) {
  auto o = std::make_shared<ReproduceOptions>();
  app.add_option("studies", o->numbers, "figures and tables by their number, such as 7.8, or all")
      ->type_name("<number>...");
  app.add_flag("--list", o->list, "name every study and what it must show")->type_name("");
  app.add_option("--out", o->out, "directory for the page and its pictures")->type_name("<dir>")->capture_default_str();
  const CLI::Option* json = app.add_option("--json", o->json_path,
                                           "where the claims go (figures.json in --out unless told); without <file>, "
                                           "standard output in place of the text")
                                ->expected(0, 1)
                                ->type_name("[<file>]");
  const CLI::Option* seed =
      app.add_option("--seed", o->seed, "seed of all that is drawn; runs this one alone without --seeds")
          ->check(between(0.0, 18446744073709551615.0))
          ->type_name("<n>")
          ->capture_default_str();
  const CLI::Option* seeds =
      app.add_option("--seeds", o->seeds, "seeds from --seed on; a claim is judged by its median over them")
          ->check(between(1, 100))
          ->type_name("<n>")
          ->capture_default_str();
  app.add_flag("--pin", o->pin, "print the verdicts as the list of the expected ones, for developers, and pass")
      ->type_name("");
  app.add_option("--threads", o->threads, "studies at a time")
      ->check(between(1, 64))
      ->type_name("<n>")
      ->capture_default_str();
  return [o, json, seed, seeds] {
    o->seeds = seed->count() > 0 && seeds->count() == 0 ? 1 : o->seeds;
    o->json_to_stdout = json->count() > 0 && o->json_path.empty();
    return reproduce_studies(*o);
  };
}

}  // namespace farrier::cli
