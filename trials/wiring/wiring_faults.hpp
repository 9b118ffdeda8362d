#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnosis/wiring/wiring.hpp"

namespace farrier::wiring {

/// One kind of fault, put into good recordings.
struct FaultKind {
  std::string name;
  /// Puts the fault into a recording of `joint` with that number of 5, which gives its size, and returns what it is.
  /// `other` is a recording of another joint of the same robot.
  std::function<diagnosis::WiringFault(diagnosis::Recording& recording, const robot::Joint& joint,
                                       const diagnosis::OtherJoint& other, int number)>
      put;
};

/// Recordings of each kind.
inline constexpr int kRecordings = 5;

/// All kinds: reversed, mirrored, dead, scaled, late, early and exchanged channels, and another joint's. An electric joint
/// has no pressures.
std::vector<FaultKind> fault_kinds(bool electric = false);

}  // namespace farrier::wiring
