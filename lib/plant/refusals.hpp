#pragma once

#include <cmath>
#include <sstream>
#include <string>

#include "core/result.hpp"

namespace farrier::plant {

/// A number as refusals have it.
inline std::string number_text(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

/// Collects every refused value of one subject, so that a person corrects them in one round.
class Refusals {
 public:
  explicit Refusals(const char* subject) : subject_(subject) {}

  void require(bool holds, const char* name, double value, const std::string& rule) {
    if (!holds || !std::isfinite(value)) {
      text_ << (text_.tellp() > 0 ? "; " : "") << name << " = " << value << " must be " << rule;
    }
  }
  void positive(const char* name, double value) { require(value > 0.0, name, value, "finite and > 0"); }
  void not_negative(const char* name, double value) { require(value >= 0.0, name, value, "finite and >= 0"); }

  Result<Done> verdict() const {
    const std::string text = text_.str();
    if (text.empty()) {
      return Done{};
    }
    return Error{std::string(subject_) + ": " + text};
  }

 private:
  const char* subject_;
  std::ostringstream text_;
};

}  // namespace farrier::plant
