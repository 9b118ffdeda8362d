#pragma once

#include <span>

#include "core/result.hpp"

namespace farrier::body {

/// A function that a shared library imports by `name`, and the one that it shall call in its place.
struct BoundCall {
  const char* name;
  void* function;
  bool required;  ///< false: the library need not import it
};

/// Directs these imports of the shared library that defines `inside` to other functions, for the whole process and for
/// no other library. It writes the library's table of imports, as the dynamic linker does (System V ABI, "Procedure
/// Linkage Table"). Refuses a library that does not import a required name, or no longer through that table.
Result<Done> bind_calls(const void* inside, std::span<const BoundCall> calls);

/// Directs the mathematics of the engine's library to own_math.hpp and core/portable_math.hpp.
Result<Done> bind_own_math(const void* inside);

}  // namespace farrier::body
