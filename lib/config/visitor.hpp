#pragma once

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "config/problem.hpp"
#include "core/choice.hpp"

namespace farrier::config {

/// Inclusive bounds of a parameter, in its own unit; infinite where they depend on other parameters.
struct Range {
  double min;
  double max;
};

/// Value of a parameter that may be left out of the file.
template <class T>
struct Default {
  T value;
};
template <class T>
Default(T) -> Default<T>;

/// Marks a parameter that may be left out of the file: the struct's own initialiser is its default. Use Default only where
/// the default depends on something else.
struct Initial {};
inline constexpr Initial kInitial;

/// Marks a group that may be left out because every parameter in it may: the struct's own initialisers then stand.
struct Defaults {};

using farrier::Option;

/// Rule for a text that is not a name: an address, the name of a device.
struct TextRule {
  const char* what;  ///< "IPv4 address"
  bool (*holds)(const std::string& text);
  const char* remedy;  ///< "give four numbers ..."
};

/// Name of a parameter, with its unit, and the sentence that explains it.
struct Entry {
  const char* name;
  const char* sentence;
};

/// Where a group of parameters stands in its file; for checks that span several groups.
struct Place {
  std::string file;
  std::string where;
  int line = 0;
  std::map<std::string, int> lines;  ///< of the keys given in the file

  /// A problem with the group's parameter `key`, or with the group itself when `key` is empty.
  Problem problem(const std::string& key, std::string message) const;
};

/// A map whose keys are names the author of the file chose, in the order of the file.
template <class T>
using Named = std::vector<std::pair<std::string, T>>;

template <class T>
const T* find(const Named<T>& items, const std::string& name) noexcept {
  for (const auto& item : items) {
    if (item.first == name) {
      return &item.second;
    }
  }
  return nullptr;
}

/// A struct of parameters is described once, by a free function found beside it. Example:
///
///     void declare(config::Visitor& v, Valve& valve) {
///       v.number("current_max_A", valve.current_max_A, {1e-4, 1.0}, "Current of the full-open valve.");
///       v.number("cut_off_Hz", valve.cut_off_Hz, {1, 1e4}, kInitial, "...");
///     }
///
/// Everything else follows from it. The reader checks (reader.hpp), the printer writes (printer.hpp), and the table of
/// parameters is made from it (reference_table.hpp). A name ends with its unit; a parameter without kInitial or
/// Default is required.
class Visitor {
 public:
  virtual ~Visitor() = default;

  void number(const char* name, double& value, Range range, const char* sentence) {
    visit_number({name, sentence}, value, range, std::nullopt);
  }
  void number(const char* name, double& value, Range range, Default<double> fallback, const char* sentence) {
    visit_number({name, sentence}, value, range, fallback.value);
  }
  void number(const char* name, double& value, Range range, Initial, const char* sentence) {
    visit_number({name, sentence}, value, range, value);
  }
  /// A number that has no value where the file gives none.
  void number(const char* name, std::optional<double>& value, Range range, const char* sentence) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    double number = value.value_or(kNone);
    visit_number({name, sentence}, number, range, kNone);
    value = std::isnan(number) ? std::nullopt : std::optional(number);
  }
  void integer(const char* name, int& value, Range range, const char* sentence) {
    visit_integer({name, sentence}, value, range, std::nullopt);
  }
  void integer(const char* name, int& value, Range range, Default<int> fallback, const char* sentence) {
    visit_integer({name, sentence}, value, range, fallback.value);
  }
  void integer(const char* name, int& value, Range range, Initial, const char* sentence) {
    visit_integer({name, sentence}, value, range, value);
  }
  void flag(const char* name, bool& value, const char* sentence) { visit_flag({name, sentence}, value, std::nullopt); }
  void flag(const char* name, bool& value, Default<bool> fallback, const char* sentence) {
    visit_flag({name, sentence}, value, fallback.value);
  }
  void flag(const char* name, bool& value, Initial, const char* sentence) {
    visit_flag({name, sentence}, value, value);
  }
  /// Text that is a name: letters, digits, "_" and "-", at most `longest` characters.
  void name(const char* name, std::string& value, std::size_t longest, const char* sentence) {
    visit_name({name, sentence}, value, longest, nullptr);
  }
  void name(const char* name, std::string& value, std::size_t longest, Default<const char*> fallback,
            const char* sentence) {
    visit_name({name, sentence}, value, longest, fallback.value);
  }
  /// Text of another kind, as the rule says.
  void text(const char* name, std::string& value, const TextRule& rule, const char* sentence) {
    visit_text({name, sentence}, value, rule);
  }
  /// List of numbers, each in the range; absent is empty.
  void numbers(const char* name, std::vector<double>& values, Range range, const char* sentence) {
    visit_numbers({name, sentence}, values, range);
  }
  /// List of names, not empty.
  void names(const char* name, std::vector<std::string>& values, const char* sentence) {
    visit_names({name, sentence}, values, true);
  }
  /// The same, but the list may be absent, which is empty.
  void names(const char* name, std::vector<std::string>& values, Defaults, const char* sentence) {
    visit_names({name, sentence}, values, false);
  }
  template <class E>
  void choice(const char* name, E& value, std::span<const Option<E>> options, const char* sentence) {
    choose<E>({name, sentence}, value, options, std::nullopt);
  }
  template <class E>
  void choice(const char* name, E& value, std::span<const Option<E>> options, Default<E> fallback,
              const char* sentence) {
    choose<E>({name, sentence}, value, options, fallback.value);
  }

  template <class E>
  void choice(const char* name, E& value, std::span<const Option<E>> options, Initial, const char* sentence) {
    choose<E>({name, sentence}, value, options, value);
  }

  template <class T>
  void group(const char* name, T& value, const char* sentence) {
    if (enter_group({name, sentence}, true, true)) {
      declare(*this, value);
      leave();
    }
  }
  template <class T>
  void group(const char* name, T& value, Defaults, const char* sentence) {
    if (enter_group({name, sentence}, false, true)) {
      declare(*this, value);
      leave();
    }
  }
  /// A group that may be absent; present in the file, it becomes present in the struct.
  template <class T>
  void group(const char* name, std::optional<T>& value, const char* sentence) {
    group(name, value, T{}, sentence);
  }
  /// The same, beginning as `fresh`.
  template <class T>
  void group(const char* name, std::optional<T>& value, const T& fresh, const char* sentence) {
    if (enter_group({name, sentence}, false, value.has_value())) {
      if (!value.has_value()) {
        value = fresh;
      }
      declare(*this, *value);
      leave();
    }
  }
  /// A map from names to groups, not empty; names are at most `longest` characters.
  template <class T>
  void groups(const char* name, Named<T>& items, std::size_t longest, const char* sentence) {
    visit_groups({name, sentence}, items, longest, true);
  }
  /// The same, but the whole map may be absent.
  template <class T>
  void groups(const char* name, Named<T>& items, std::size_t longest, Defaults, const char* sentence) {
    visit_groups({name, sentence}, items, longest, false);
  }
  /// A map from names to names, not empty, and where it stands.
  void pairs(const char* name, Named<std::string>& items, Place& place, std::size_t longest, const char* sentence) {
    visit_pairs({name, sentence}, items, place, longest);
  }

  /// Where the present group stands.
  virtual void here(Place&) {}
  /// A condition between parameters of the present group, checked once they are all good.
  virtual void check(bool, const char* /*key*/, const std::string& /*message*/) {}
  /// A key of the present group that files no longer have. A file that gives it is refused; `remedy` says what replaces
  /// it: "give effects.<joint>....".
  virtual void moved(const char* /*key*/, const char* /*remedy*/) {}

 protected:
  /// A fallback that is no number: the value may be absent, and is no number then.
  virtual void visit_number(const Entry&, double&, Range, std::optional<double> fallback) = 0;
  virtual void visit_integer(const Entry&, int&, Range, std::optional<int> fallback) = 0;
  virtual void visit_flag(const Entry&, bool&, std::optional<bool> fallback) = 0;
  /// A null `fallback`: required.
  virtual void visit_name(const Entry&, std::string&, std::size_t longest, const char* fallback) = 0;
  virtual void visit_numbers(const Entry&, std::vector<double>&, Range) = 0;
  virtual void visit_text(const Entry&, std::string&, const TextRule&) = 0;
  virtual void visit_names(const Entry&, std::vector<std::string>&, bool required) = 0;
  virtual void visit_pairs(const Entry&, Named<std::string>&, Place&, std::size_t longest) = 0;
  virtual void visit_choice(const Entry&, int& index, std::span<const char* const> names,
                            std::optional<int> fallback) = 0;
  /// True when the group is to be visited; leave() follows.
  virtual bool enter_group(const Entry&, bool required, bool present) = 0;
  virtual bool enter_map(const Entry&, std::vector<std::string>& names, std::size_t longest, bool required) = 0;
  virtual bool enter_item(const std::string& name) = 0;
  virtual void leave() = 0;

 private:
  template <class T>
  void visit_groups(const Entry& entry, Named<T>& items, std::size_t longest, bool required) {
    std::vector<std::string> names;
    for (const auto& item : items) {
      names.push_back(item.first);
    }
    if (!enter_map(entry, names, longest, required)) {
      return;
    }
    Named<T> visited;
    for (const std::string& item_name : names) {
      const T* present = find(items, item_name);
      visited.emplace_back(item_name, present != nullptr ? *present : T{});
      if (enter_item(item_name)) {
        declare(*this, visited.back().second);
        leave();
      }
    }
    items = std::move(visited);
    leave();
  }

  template <class E>
  void choose(const Entry& entry, E& value, std::span<const Option<E>> options, std::optional<E> fallback) {
    std::vector<const char*> names;
    int index = 0;
    std::optional<int> fallback_index;
    for (std::size_t i = 0; i < options.size(); ++i) {
      names.push_back(options[i].name);
      if (options[i].value == value) {
        index = static_cast<int>(i);
      }
      if (fallback == options[i].value) {
        fallback_index = static_cast<int>(i);
      }
    }
    visit_choice(entry, index, names, fallback_index);
    value = options[static_cast<std::size_t>(index)].value;
  }
};

/// Shortest text that reads back as the same number.
std::string number_text(double value);

}  // namespace farrier::config
