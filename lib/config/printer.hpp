#pragma once

#include <functional>
#include <string>

#include "config/visitor.hpp"

namespace farrier::config {

/// The parameters with their present values as YAML: what a run records. Reads back as the same values, bit for bit.
std::string print_declared(const std::function<void(Visitor&)>& declare_all);

template <class T>
std::string print_yaml(T value) {
  return print_declared([&value](Visitor& v) { declare(v, value); });
}

}  // namespace farrier::config
