#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "signals/fields.hpp"

namespace farrier::playback {

template <class Field>
inline constexpr bool kIsText = false;
template <std::size_t kSize>
inline constexpr bool kIsText<std::array<char, kSize>> = true;

/// Calls column(name, number, text or byte sequence) for each column of a field.
template <class Field, class Column>
void visit_columns(const std::string& name, Field& field, Column&& column) {
  if constexpr (std::is_arithmetic_v<std::remove_const_t<Field>> || std::is_enum_v<std::remove_const_t<Field>> ||
                kIsText<std::remove_const_t<Field>> || signals::kIsOctets<Field>) {
    column(name, field);
  } else {
    for (std::size_t i = 0; i < field.size(); ++i) {
      column(name + '[' + std::to_string(i) + ']', field[i]);
    }
  }
}

/// Calls column(name, number, text or byte sequence) for each column of a signal.
template <class Signal, class Column>
void visit_all_columns(Signal& signal, Column&& column) {
  signals::visit_fields(signal, [&](const char* name, auto& field) { visit_columns(name, field, column); });
}

template <class Number>
requires std::is_arithmetic_v<Number>
void append_cell(std::string& row, Number number) {
  char text[40];
  if constexpr (std::is_integral_v<Number> && sizeof(Number) == 1) {
    row.append(text, std::to_chars(text, text + sizeof text, static_cast<int>(number)).ptr);
  } else {
    row.append(text, std::to_chars(text, text + sizeof text, number).ptr);
  }
}

template <class Enum>
requires std::is_enum_v<Enum>
void append_cell(std::string& row, Enum value) { append_cell(row, static_cast<std::uint8_t>(value)); }

template <std::size_t kSize>
void append_cell(std::string& row, const std::array<char, kSize>& text) {
  row += '"';
  for (const char letter : signals::text_of(text)) {
    row += letter;
    if (letter == '"') {
      row += '"';
    }
  }
  row += '"';
}

/// Appends two digits per byte.
template <std::size_t kMost>
void append_cell(std::string& row, const signals::Octets<kMost>& octets) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  for (const std::uint8_t octet : octets) {
    row += kDigits[octet >> 4];
    row += kDigits[octet & 15];
  }
}

/// False for a cell that is not such a number, or not one in its range.
template <class Number>
requires std::is_arithmetic_v<Number>
bool parse_cell(const std::string& cell, Number& number) {
  std::conditional_t<std::is_integral_v<Number> && sizeof(Number) == 1, int, Number> read{};
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), read);
  number = static_cast<Number>(read);
  return error == std::errc{} && end == cell.data() + cell.size() && number == read;
}
inline bool parse_cell(const std::string& cell, double& number) {
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  return error == std::errc{} && end == cell.data() + cell.size();
}

template <class Enum>
requires std::is_enum_v<Enum>
bool parse_cell(const std::string& cell, Enum& value) {
  std::uint8_t number = 0;
  const bool parsed = parse_cell(cell, number);
  value = static_cast<Enum>(number);
  return parsed;
}

template <std::size_t kSize>
bool parse_cell(const std::string& cell, std::array<char, kSize>& text) {
  signals::assign(text, cell);
  return cell.size() < kSize;
}

template <std::size_t kMost>
bool parse_cell(const std::string& cell, signals::Octets<kMost>& octets) {
  octets.resize(cell.size() / 2);
  const char* digits = cell.data();
  for (std::uint8_t& octet : octets) {
    const auto [end, error] = std::from_chars(digits, digits + 2, octet, 16);
    if (error != std::errc{} || end != digits + 2) {
      return false;
    }
    digits = end;
  }
  return digits == cell.data() + cell.size();
}

}  // namespace farrier::playback
