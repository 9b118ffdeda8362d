#include "thesis/studies/registry.hpp"

#include <algorithm>
#include <charconv>
#include <tuple>

#include "config/suggest.hpp"

namespace farrier::thesis {
namespace {

constexpr std::span<const Study> (*kGroups[])() = {
    chapter4_step,       chapter4_models,         chapter4_points,   chapter4_loads,     chapter6_inputs,
    chapter6_signals,    chapter6_forgetting,     chapter6_table,    chapter7_tracking,  chapter7_gain_maps,
    chapter7_load_cycle, chapter7_estimates,      chapter8,          chapter9_estimates, chapter9_gates,
    chapter9_weights,    chapter9_gains,          chapter9_sines,    chapter9_steps,     chapter9_fixed,
    chapter9_ramps,      chapter9_identification, chapter9_pressure, chapter10,          section4_sensitivity,
    section5_update,     section6_sampling,       section7_weights,  appendix_parameters};

int number_of(std::string_view text) {
  int value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Place within a chapter: figures, then tables, then sections.
int kind_of(std::string_view number) { return number.starts_with('T') ? 1 : number.starts_with('S') ? 2 : 0; }

/// Chapters by number, then appendices by letter.
std::tuple<int, int, int> order_of(std::string_view number) {
  const int kind = kind_of(number);
  number.remove_prefix(kind > 0 ? 1 : 0);
  const std::size_t dot = number.find('.');
  const std::string_view chapter = number.substr(0, dot);
  constexpr int kAfterChapters = 1000;
  const bool appendix = !chapter.empty() && chapter.front() >= 'A' && chapter.front() <= 'Z';
  return {appendix ? kAfterChapters + chapter.front() : number_of(chapter), kind,
          dot == std::string_view::npos ? 0 : number_of(number.substr(dot + 1))};
}

std::string_view chapter_of(std::string_view number) {
  number.remove_prefix(kind_of(number) > 0 ? 1 : 0);
  return number.substr(0, number.find('.'));
}

}  // namespace

std::vector<Study> all_studies() {
  std::vector<Study> studies;
  for (const auto group : kGroups) {
    const std::span<const Study> more = group();
    studies.insert(studies.end(), more.begin(), more.end());
  }
  std::ranges::stable_sort(studies, {}, [](const Study& study) { return order_of(study.number); });
  return studies;
}

const Study* find_study(std::span<const Study> studies, std::string_view number) noexcept {
  const auto found = std::ranges::find_if(studies, [&](const Study& study) { return study.number == number; });
  return found == studies.end() ? nullptr : &*found;
}

std::vector<std::string> near_numbers(std::span<const Study> studies, const std::string& unknown) {
  constexpr std::size_t kMost = 8;
  std::vector<std::string> near;
  std::vector<std::string> known;
  for (const Study& study : studies) {
    known.emplace_back(study.number);
    if (!unknown.empty() && chapter_of(study.number) == chapter_of(unknown)) {
      near.emplace_back(study.number);
    }
  }
  // The numbers of a chapter stand in their order: those that follow the unknown one and those just before it.
  if (near.size() > kMost) {
    const auto after =
        std::ranges::find_if(near, [&](const std::string& number) { return order_of(number) > order_of(unknown); });
    const auto centre = static_cast<std::size_t>(after - near.begin());
    const std::size_t first = std::min(centre > kMost / 2 ? centre - kMost / 2 : 0, near.size() - kMost);
    near = {near.begin() + static_cast<std::ptrdiff_t>(first),
            near.begin() + static_cast<std::ptrdiff_t>(first + kMost)};
  }
  if (near.empty()) {
    const config::Suggestion one = config::suggest(unknown, known);
    if (!one.name.empty()) {
      near.push_back(one.name);
    }
  }
  return near;
}

}  // namespace farrier::thesis
