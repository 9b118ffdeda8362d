#include "report/figures/sample_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <type_traits>

namespace farrier::report {
namespace {

class FieldsText {
 public:
  explicit FieldsText(const robot::Robot& robot) : robot_(robot) {}

  template <class Value>
  void operator()(std::string_view name, const Value& value) {
    text_ += text_.empty() ? "{" : ", ";
    text_ += name;
    text_ += ": ";
    text_ += value_text(name, value);
  }

  std::string text() && { return std::move(text_) + "}"; }

 private:
  static std::string value_text(std::string_view, double value) {
    if (!std::isfinite(value)) {
      return std::isnan(value) ? ".nan" : value > 0 ? ".inf" : "-.inf";
    }
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.9g", value);
    return digits;
  }

  template <class Integer>
  requires std::is_integral_v<Integer> std::string value_text(std::string_view name, Integer value)
  const {
    if (name == "joint") {
      const auto joint = std::ranges::find(robot_.joints, value, &robot::Joint::number);
      return joint == robot_.joints.end() ? std::to_string(value) : joint->name;
    }
    return std::to_string(value);
  }

  template <class Enum>
  requires std::is_enum_v<Enum>
  static std::string value_text(std::string_view, Enum value) {
    const std::string_view text = signals::to_string(value);
    return text.starts_with("unknown ") ? std::to_string(static_cast<int>(value)) : std::string(text);
  }

  template <std::size_t kSize>
  static std::string value_text(std::string_view, const std::array<char, kSize>& value) {
    std::string quoted = "\"";
    for (const char c : signals::text_of(value)) {
      quoted += c == '"' || c == '\\' ? "\\" : "";
      quoted += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return quoted + "\"";
  }

  template <class List>
  requires requires(const List& values) { values.begin(); }
  std::string value_text(std::string_view, const List& values) const {
    std::string list;
    for (const auto& value : values) {
      list += (list.empty() ? "[" : ", ") + value_text({}, value);
    }
    return list + "]";
  }

  const robot::Robot& robot_;
  std::string text_;
};

}  // namespace

#define FARRIER_SAMPLE_TEXT(Signal, file)                                             \
  std::string sample_text(const signals::Signal& signal, const robot::Robot& robot) { \
    FieldsText fields(robot);                                                         \
    signals::visit_fields(signal, fields);                                            \
    return std::move(fields).text();                                                  \
  }
FARRIER_SIGNALS(FARRIER_SAMPLE_TEXT)
#undef FARRIER_SAMPLE_TEXT

}  // namespace farrier::report
