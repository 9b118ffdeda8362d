#include "cli/deploy/findings.hpp"

#include <algorithm>
#include <cstdio>

#include "cli/base/command.hpp"

namespace farrier::cli {

int print_findings(const deploy::Findings& findings, const std::string& subject) {
  for (const deploy::Finding& finding : findings) {
    std::printf("%s: %s\n  %s: %s\n", finding.fault ? "found" : "note", finding.what.c_str(),
                finding.fault ? "fix" : "if it matters", finding.fix.c_str());
  }
  const auto faults = std::ranges::count_if(findings, &deploy::Finding::fault);
  std::printf("%s: %td finding%s\n", subject.c_str(), faults, faults == 1 ? "" : "s");
  return faults == 0 ? kPassed : kFailed;
}

}  // namespace farrier::cli
