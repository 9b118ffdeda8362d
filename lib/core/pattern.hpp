#pragma once

#include <regex.h>

#include <array>
#include <optional>
#include <stdexcept>
#include <string>

namespace farrier {

/// A POSIX extended regular expression with at most 7 groups. <regex> of C++ takes seconds to compile.
class Pattern {
 public:
  /// The match and its groups; a group that took no part is empty.
  using Groups = std::array<std::string, 8>;

  /// Throws std::invalid_argument for text that is no expression.
  explicit Pattern(const char* expression) {
    if (::regcomp(&compiled_, expression, REG_EXTENDED) != 0) {
      throw std::invalid_argument(std::string("not a POSIX extended regular expression: ") + expression);
    }
  }
  ~Pattern() { ::regfree(&compiled_); }
  Pattern(const Pattern&) = delete;
  Pattern& operator=(const Pattern&) = delete;

  /// The first match in `text`. Null without one.
  std::optional<Groups> find(const std::string& text) const {
    std::array<regmatch_t, std::tuple_size_v<Groups>> places{};
    if (::regexec(&compiled_, text.c_str(), places.size(), places.data(), 0) != 0) {
      return std::nullopt;
    }
    Groups groups;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (places[i].rm_so >= 0) {
        groups[i] = text.substr(static_cast<std::size_t>(places[i].rm_so),
                                static_cast<std::size_t>(places[i].rm_eo - places[i].rm_so));
      }
    }
    return groups;
  }

 private:
  regex_t compiled_{};
};

}  // namespace farrier
