#include "report/figures/figures.hpp"

#include <algorithm>
#include <cmath>

#include "core/ensure.hpp"

namespace farrier::report {

const char* to_string(Relation relation) noexcept {
  switch (relation) {
    case Relation::kNone: return "";
    case Relation::kAtMost: return "<=";
    case Relation::kBelow: return "<";
    case Relation::kAtLeast: return ">=";
  }
  return "";
}

bool Figure::holds() const noexcept {
  if (!bound) {
    return true;
  }
  if (!std::isfinite(value)) {
    return false;
  }
  switch (spec->relation) {
    case Relation::kNone: return true;
    case Relation::kAtMost: return value <= *bound;
    case Relation::kBelow: return value < *bound;
    case Relation::kAtLeast: return value >= *bound;
  }
  return false;
}

void Figures::add(std::string name, double value, std::optional<double> bound) {
  const FigureSpec* spec = find_spec(name);
  FARRIER_ENSURE(spec != nullptr, ("figure " + name + " is not declared in figure_registry.cpp").c_str());
  push({std::move(name), value, bound, spec});
}

void Figures::add(const FigureSpec& spec, double value, std::optional<double> bound) {
  FARRIER_ENSURE(find_spec(spec.pattern) != nullptr,
                 (std::string("figure ") + spec.pattern + " falls under no pattern of figure_registry.cpp").c_str());
  push({spec.pattern, value, bound, &spec});
}

void Figures::push(Figure figure) {
  FARRIER_ENSURE(find(figure.name) == nullptr, ("figure " + figure.name + " was added twice").c_str());
  FARRIER_ENSURE(!figure.bound || (figure.spec->relation != Relation::kNone && std::isfinite(*figure.bound)),
                 ("figure " + figure.name + " cannot have this bound").c_str());
  figures_.push_back(std::move(figure));
}

const Figure* Figures::find(std::string_view name) const noexcept {
  const auto found = std::ranges::find(figures_, name, &Figure::name);
  return found == figures_.end() ? nullptr : &*found;
}

bool Figures::all_hold() const noexcept { return std::ranges::all_of(figures_, &Figure::holds); }

}  // namespace farrier::report
