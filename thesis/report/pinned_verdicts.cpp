#include "thesis/report/pinned_verdicts.hpp"

#include <algorithm>
#include <map>

namespace farrier::thesis {
namespace {

constexpr PinnedVerdict kPinned[] = {
#define FARRIER_PINNED(id, verdict) {id, Verdict::verdict},
#include "thesis/report/pinned_verdicts.def"
#undef FARRIER_PINNED
};

std::string constant_of(const std::string& verdict) {
  std::string name = "k" + verdict;
  name[1] = static_cast<char>(name[1] - 'a' + 'A');
  return name;
}

}  // namespace

std::span<const PinnedVerdict> pinned_verdicts() noexcept { return kPinned; }

std::optional<Verdict> pinned_verdict(std::string_view id) noexcept {
  const auto* const found = std::ranges::find_if(kPinned, [&](const PinnedVerdict& pinned) { return pinned.id == id; });
  return found == std::end(kPinned) ? std::nullopt : std::optional(found->verdict);
}

std::vector<std::string> slides(const std::vector<report::Claim>& claims) {
  std::vector<std::string> sentences;
  for (const report::Claim& claim : claims) {
    const auto pinned = pinned_verdict(claim.id);
    if (!pinned) {
      sentences.push_back(claim.id + " has the verdict '" + claim.verdict + "' and none is pinned");
    } else if (claim.verdict != to_string(*pinned)) {
      sentences.push_back(claim.id + " is pinned as '" + to_string(*pinned) + "' and is now '" + claim.verdict + "'");
    }
  }
  return sentences;
}

std::string pinned_text(const std::vector<report::Claim>& claims) {
  std::string text =
      "// The verdict of every claim over the seeds 1 to 7. The command 'farrier reproduce all --pin' prints this "
      "file.\n";
  std::map<std::string, std::string> by_id;
  for (const report::Claim& claim : claims) {
    by_id[claim.id] = constant_of(claim.verdict);
  }
  bool second = false;  // of two in a line
  for (const auto& [id, verdict] : by_id) {
    text += "FARRIER_PINNED(\"" + id + "\", " + verdict + (second ? ")\n" : ") ");
    second = !second;
  }
  text += second ? "\n" : "";
  return text;
}

}  // namespace farrier::thesis
