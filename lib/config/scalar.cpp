#include "config/scalar.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace farrier::config {
namespace {

bool is_plain(const Value& value) { return value.kind == Value::Kind::kScalar && !value.quoted; }

bool in(Range range, double value) { return value >= range.min && value <= range.max; }

enum class Parsed { kNumber, kTooLarge, kNothing };

// The whole text as a number, with an optional plus.
template <class Number>
Parsed parse(const std::string& text, Number& number) {
  const char* begin = text.data();
  const char* const end = begin + text.size();
  begin += text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0;
  const auto result = std::from_chars(begin, end, number);
  if (result.ptr != end || result.ec == std::errc::invalid_argument) {
    return Parsed::kNothing;
  }
  return result.ec == std::errc::result_out_of_range ? Parsed::kTooLarge : Parsed::kNumber;
}

// YAML's own words for what is no finite number; from_chars knows others ("inf", "nan").
bool is_special(const std::string& text) {
  constexpr std::array kWords = {".inf", "-.inf", "+.inf", ".Inf", "-.Inf", ".INF", "-.INF", ".nan", ".NaN", ".NAN"};
  return std::find(kWords.begin(), kWords.end(), text) != kWords.end();
}

std::string name_remedy(std::size_t longest) {
  return "give 1 to " + std::to_string(longest) + " letters, digits, \"_\" or \"-\"";
}

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

}  // namespace

std::string number_text(double value) {
  std::array<char, 32> text;
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
  return std::string(text.data(), result.ptr);
}

std::string range_remedy(Range range) {
  return std::isinf(range.max) ? "give a number" : "give " + number_text(range.min) + " to " + number_text(range.max);
}

std::string choice_remedy(std::span<const char* const> names) {
  std::string text = "give";
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? " " : i + 1 == names.size() ? " or " : ", ") + std::string(names[i]);
  }
  return text;
}

std::string shown(const Value& value) {
  constexpr std::size_t kLongest = 40;
  switch (value.kind) {
    case Value::Kind::kNothing: return "nothing";
    case Value::Kind::kList: return "a list";
    case Value::Kind::kMap: return "a map";
    case Value::Kind::kScalar: break;
  }
  std::string text = value.scalar.size() <= kLongest ? value.scalar : value.scalar.substr(0, kLongest) + "...";
  std::replace_if(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  return value.quoted || text.empty() ? "\"" + text + "\"" : text;
}

std::string read_number(const Value& value, Range range, double& out) {
  const bool special = is_plain(value) && is_special(value.scalar);
  double number = 0.0;
  const Parsed parsed = is_plain(value) ? parse(value.scalar, number) : Parsed::kNothing;
  if (special || parsed == Parsed::kTooLarge || (parsed == Parsed::kNumber && !std::isfinite(number))) {
    return shown(value) + " is not a finite number: " + range_remedy(range);
  }
  if (parsed == Parsed::kNothing) {
    return shown(value) + " is not a number: " + range_remedy(range);
  }
  if (!in(range, number)) {
    return shown(value) + " is out of range: " + range_remedy(range);
  }
  out = number;
  return "";
}

std::string read_integer(const Value& value, Range range, int& out) {
  long long number = 0;
  const Parsed parsed = is_plain(value) ? parse(value.scalar, number) : Parsed::kNothing;
  if (parsed == Parsed::kNothing) {
    return shown(value) + " is not a whole number: " + range_remedy(range);
  }
  if (parsed == Parsed::kTooLarge || !in(range, static_cast<double>(number))) {
    return shown(value) + " is out of range: " + range_remedy(range);
  }
  out = static_cast<int>(number);
  return "";
}

std::string read_flag(const Value& value, bool& out) {
  if (!is_plain(value) || (value.scalar != "true" && value.scalar != "false")) {
    return shown(value) + " is neither true nor false: give one of them";
  }
  out = value.scalar == "true";
  return "";
}

std::string read_name(const Value& value, std::size_t longest, std::string& out) {
  const std::string& text = value.scalar;
  if (value.kind != Value::Kind::kScalar || text.empty() || text.size() > longest ||
      !std::all_of(text.begin(), text.end(), is_name_character)) {
    return shown(value) + " is not a name: " + name_remedy(longest);
  }
  out = text;
  return "";
}

std::string read_text_of(const Value& value, const TextRule& rule, std::string& out) {
  if (value.kind != Value::Kind::kScalar || !rule.holds(value.scalar)) {
    return shown(value) + " is no " + rule.what + ": " + rule.remedy;
  }
  out = value.scalar;
  return "";
}

std::string read_choice(const Value& value, std::span<const char* const> names, int& out) {
  const auto match = std::find(names.begin(), names.end(), value.scalar);
  if (value.kind != Value::Kind::kScalar || match == names.end()) {
    return shown(value) + " is not known: " + choice_remedy(names);
  }
  out = static_cast<int>(match - names.begin());
  return "";
}

}  // namespace farrier::config
