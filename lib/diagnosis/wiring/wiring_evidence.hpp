#pragma once

#include <optional>
#include <span>
#include <vector>

#include "diagnosis/wiring/wiring.hpp"

namespace farrier::diagnosis {

/// Both sides of a law over time: a channel, and what the other channels say that it should be. Low-passed alike.
struct LawOverTime {
  std::vector<double> time_s;  ///< since the recording's first sample
  std::vector<double> left, right;
};

/// The law of a joint that shows a fault of wiring best. Units of its left side: m/s, N, A, or rad/s, Nm, A.
struct WiringEvidence {
  WiringLaw law;
  LawOverTime recorded;  ///< as recorded, with the numbers of the law that fit best once the fault is undone
  LawOverTime mended;    ///< with the fault undone; empty of a dead channel, and where no column undoes it
};

/// Evidence for a fault that find_wiring() named. None for a fault of the supply pressure, which is compared with the
/// robot file by its level alone. `others` as in find_wiring().
std::optional<WiringEvidence> wiring_evidence(const Recording& recording, const robot::Joint& joint,
                                              const WiringFault& fault, std::span<const OtherJoint> others = {});

}  // namespace farrier::diagnosis
