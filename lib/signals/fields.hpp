#pragma once

// The field list of every signal. Codecs, tables and round-trip tests are expanded from it.

#include "signals/field_lists.hpp"
#include "signals/signals.hpp"

namespace farrier::signals {

/// Calls visitor(name, field) for every field of a signal, in wire order.
#define FARRIER_VISIT_FIELD(field) visitor(#field, signal.field);
#define FARRIER_VISIT(Signal, file)                                      \
  template <class Visitor>                                               \
  constexpr void visit_fields(Signal& signal, Visitor&& visitor) {       \
    FARRIER_FIELDS_##Signal(FARRIER_VISIT_FIELD)                         \
  }                                                                      \
  template <class Visitor>                                               \
  constexpr void visit_fields(const Signal& signal, Visitor&& visitor) { \
    FARRIER_FIELDS_##Signal(FARRIER_VISIT_FIELD)                         \
  }
FARRIER_SIGNALS(FARRIER_VISIT)
#undef FARRIER_VISIT
#undef FARRIER_VISIT_FIELD

}  // namespace farrier::signals
