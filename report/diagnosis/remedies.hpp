#pragma once

#include "plant/terms/terms.hpp"

namespace farrier::report {

/// Advice on an effect, for the person at the machine.
struct Remedy {
  const char* effect;  ///< name of the effect
  const char* part;    ///< of the machine: "valve", "load cell"
  const char* check;   ///< what to look at or to repair, a sentence or two
};

/// Advice on any effect that a diagnosis may name.
const Remedy& remedy_of(plant::EffectId id) noexcept;

}  // namespace farrier::report
