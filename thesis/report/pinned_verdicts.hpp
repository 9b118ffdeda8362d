#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "report/figures/outcome.hpp"
#include "thesis/study/claim.hpp"

namespace farrier::thesis {

/// The verdict that a claim is expected to have over the seeds 1 to 7.
struct PinnedVerdict {
  const char* id;
  Verdict verdict;
};

/// pinned_verdicts.def.
std::span<const PinnedVerdict> pinned_verdicts() noexcept;
std::optional<Verdict> pinned_verdict(std::string_view id) noexcept;

/// A sentence for each claim whose verdict is not the pinned one.
std::vector<std::string> slides(const std::vector<report::Claim>& claims);

/// The text of pinned_verdicts.def, from these claims.
std::string pinned_text(const std::vector<report::Claim>& claims);

}  // namespace farrier::thesis
