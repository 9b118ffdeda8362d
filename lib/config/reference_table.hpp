#pragma once

#include <functional>
#include <string>

#include "config/visitor.hpp"

namespace farrier::config {

/// Markdown table of every declared parameter: path, unit, range or choices, default, sentence.
std::string table_of_declared(const std::function<void(Visitor&)>& declare_all);

template <class T>
std::string reference_table() {
  T value{};
  return table_of_declared([&value](Visitor& v) { declare(v, value); });
}

}  // namespace farrier::config
