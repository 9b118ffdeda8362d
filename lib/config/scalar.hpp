#pragma once

#include <span>
#include <string>

#include "config/document.hpp"
#include "config/visitor.hpp"

namespace farrier::config {

// Each function reads one value and returns the problem and the remedy, or an empty text. `out` changes only without a
// problem. A quoted scalar is text, never a number or a flag.

std::string read_number(const Value& value, Range range, double& out);
std::string read_integer(const Value& value, Range range, int& out);
std::string read_flag(const Value& value, bool& out);
/// 1 to `longest` letters, digits, "_" and "-".
std::string read_name(const Value& value, std::size_t longest, std::string& out);
/// A scalar, quoted or not, that the rule takes.
std::string read_text_of(const Value& value, const TextRule& rule, std::string& out);
/// One of `names`; `out` is its place.
std::string read_choice(const Value& value, std::span<const char* const> names, int& out);

/// "give 0.01 to 1000"
std::string range_remedy(Range range);
/// "give trot or stand"
std::string choice_remedy(std::span<const char* const> names);
/// Returns the text of the value in the file, short enough to be repeated in a message.
std::string shown(const Value& value);

}  // namespace farrier::config
