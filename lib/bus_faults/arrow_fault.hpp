#pragma once

// Faults that can be injected into the samples of one arrow on their way into one process.

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "bus/topics.hpp"
#include "core/result.hpp"

namespace farrier::bus_faults {

enum class Kind : std::uint8_t {
  kLoss,       ///< `probability` of a sample to be lost
  kBurst,      ///< `probability` that `length` samples are lost in a row
  kDuplicate,  ///< `probability` of a sample to come twice
  kReorder,    ///< `probability` of a sample to come after the next one of its key
  kDelay,      ///< every sample is late, by a uniform distribution from `least` to `most`
  kCut,        ///< every sample is lost
  kFrozen,     ///< numbers stay what they were when the fault began; ticks and times go on
  kNoise,      ///< `field` gets white noise of standard deviation `amount`
  kOffset,     ///< `field` gets `amount` more
  kNotANumber  ///< `field` is no number
};

struct ArrowFault {
  bus::TopicId topic;
  Kind kind;
  double probability = 1.0;
  int length = 1;
  Nanoseconds least{0}, most{0};
  std::string field;   ///< a floating-point field of the signal
  double amount = 0.0; ///< SI, of the field
  Tick from = 0;       ///< by the ticks of the samples
  Tick until = std::numeric_limits<Tick>::max();
  std::optional<std::uint32_t> key;  ///< bus::key_of; none: every key

  friend bool operator==(const ArrowFault&, const ArrowFault&) = default;
};

/// Reads "TOPIC:KIND[=VALUE][@FROM..UNTIL][#KEY]", e.g. "joint/sensors:loss=0.05@2000..3000#4". VALUE depends on KIND.
///
///   loss, duplicate, reorder   probability in [0, 1]
///   burst                      PROBABILITYxLENGTH
///   delay                      milliseconds, or LEAST..MOST
///   cut, frozen                none
///   noise, offset              FIELD+AMOUNT or FIELD-AMOUNT, SI
///   nan                        FIELD
///
/// FROM and UNTIL are ticks, UNTIL excluded. Refuses anything else with the part that is wrong and what may stand there.
Result<ArrowFault> parse_arrow_fault(const std::string& text);

/// The inverse of parse_arrow_fault.
std::string to_string(const ArrowFault& fault);

}  // namespace farrier::bus_faults
