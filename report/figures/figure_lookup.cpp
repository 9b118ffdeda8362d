#include "report/figures/figure_registries.hpp"

namespace farrier::report {
namespace {

// Cuts the first dotted part off `rest`.
std::string_view next_part(std::string_view& rest) noexcept {
  const std::size_t dot = rest.find('.');
  const std::string_view part = rest.substr(0, dot);
  rest = dot == std::string_view::npos ? std::string_view{} : rest.substr(dot + 1);
  return part;
}

// Returns the text of the angle brackets in one part: <joint>, light_<quarter>, <quarter>_nrmse; never an empty one.
std::optional<std::string_view> placeholder(std::string_view wanted, std::string_view given) noexcept {
  const std::size_t open = wanted.find('<');
  const std::size_t close = wanted.find('>');
  if (open == std::string_view::npos || close == std::string_view::npos) {
    return std::nullopt;
  }
  const std::string_view before = wanted.substr(0, open);
  const std::string_view after = wanted.substr(close + 1);
  if (given.size() <= before.size() + after.size() || !given.starts_with(before) || !given.ends_with(after)) {
    return std::nullopt;
  }
  return given.substr(before.size(), given.size() - before.size() - after.size());
}

std::vector<FigureSpec> joined_specs() {
  std::vector<FigureSpec> specs;
  for (const auto part : {process_figure_specs(), diagnosis_figure_specs(), body_figure_specs()}) {
    specs.insert(specs.end(), part.begin(), part.end());
  }
  return specs;
}

}  // namespace

std::span<const FigureSpec> figure_specs() noexcept {
  static const std::vector<FigureSpec> kSpecs = joined_specs();
  return kSpecs;
}

std::optional<std::vector<std::string_view>> match(std::string_view pattern, std::string_view name) {
  std::vector<std::string_view> names;
  while (!pattern.empty() && !name.empty()) {
    const std::string_view wanted = next_part(pattern);
    const std::string_view given = next_part(name);
    if (const auto stands_for = placeholder(wanted, given)) {
      names.push_back(*stands_for);
    } else if (wanted != given) {
      return std::nullopt;
    }
  }
  if (!pattern.empty() || !name.empty()) {
    return std::nullopt;
  }
  return names;
}

const FigureSpec* find_spec(std::string_view name) noexcept {
  for (const FigureSpec& spec : figure_specs()) {
    if (match(spec.pattern, name)) {
      return &spec;
    }
  }
  return nullptr;
}

std::string figures_table_markdown() {
  std::string table = "| figure | unit | bound | meaning |\n|---|---|---|---|\n";
  for (const FigureSpec& spec : figure_specs()) {
    table += "| `" + std::string(spec.pattern) + "` | " + spec.unit + " | " +
             (spec.relation == Relation::kNone ? "" : "`" + std::string(to_string(spec.relation)) + "`") + " | " +
             spec.sentence + " |\n";
  }
  return table;
}

}  // namespace farrier::report
