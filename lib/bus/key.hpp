#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "signals/fields.hpp"

namespace farrier::bus {

/// The DDS key of a signal as one number: samples with the same number share a history.
template <class Signal>
std::uint32_t key_of(const Signal& signal) noexcept {
  std::uint32_t key = 0;
  std::size_t index = 0;
  signals::visit_fields(signal, [&](const char*, const auto& field) {
    using Field = std::remove_cvref_t<decltype(field)>;
    if constexpr ((std::is_integral_v<Field> || std::is_enum_v<Field>)&&sizeof(Field) <= sizeof(std::uint16_t)) {
      if (index < signals::kTopicText<Signal>.key_fields) {
        key = (key << 16) | static_cast<std::uint16_t>(field);
      }
    }
    ++index;
  });
  return key;
}

}  // namespace farrier::bus
