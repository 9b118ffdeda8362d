#pragma once

// The common form of all results: named figures, each declared once (figure_registries.hpp). Tables for people, JSON and
// the HTML report all show the same Figures.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace farrier::report {

/// Relation of a figure to its bound.
enum class Relation {
  kNone,     ///< never bounded
  kAtMost,   ///< value <= bound
  kBelow,    ///< value < bound
  kAtLeast,  ///< value >= bound
};

/// "<=", "<", ">="; empty for kNone.
const char* to_string(Relation relation) noexcept;

/// Declaration of a figure, or of a family of them.
struct FigureSpec {
  const char* pattern;   ///< dotted name; angle brackets in a part, as in trot.<joint>.travel_rad, stand for one name
  const char* unit;      ///< "1" for ratios and counts
  Relation relation;     ///< a figure with a relation may be given a bound; one without never has one
  const char* sentence;  ///< what it is
};

/// Every declared figure.
std::span<const FigureSpec> figure_specs() noexcept;

/// The declaration `name` falls under, null for none.
const FigureSpec* find_spec(std::string_view name) noexcept;

/// Returns the texts in `name` for the angle brackets of `pattern`, in order; nothing if the name does not fit.
std::optional<std::vector<std::string_view>> match(std::string_view pattern, std::string_view name);

/// Markdown table of every declared figure, for docs/figures.md.
std::string figures_table_markdown();

struct Figure {
  std::string name;
  double value;
  std::optional<double> bound;
  const FigureSpec* spec;

  /// True without a bound. A value that is not finite never holds a bound.
  bool holds() const noexcept;
};

/// The figures of one run, in the order they were added.
class Figures {
 public:
  /// Adding an undeclared name, a name twice, or a bound that is not finite or whose figure declares no relation
  /// is a bug and aborts.
  void add(std::string name, double value, std::optional<double> bound = std::nullopt);
  /// A figure whose declaration the registry leaves to a table elsewhere: `spec.pattern` is its name, must fall under a
  /// pattern of the registry, and outlives this object.
  void add(const FigureSpec& spec, double value, std::optional<double> bound = std::nullopt);

  std::span<const Figure> all() const noexcept { return figures_; }
  /// Null for none of that name.
  const Figure* find(std::string_view name) const noexcept;
  bool all_hold() const noexcept;

 private:
  void push(Figure figure);

  std::vector<Figure> figures_;
};

}  // namespace farrier::report
