#pragma once

#include <functional>

#include "core/keep_on.hpp"
#include "tools/playback/measurements.hpp"

namespace farrier::playback {

/// Feeds recorded measurements, joint by joint and tick by tick, to the estimators of this version, as
/// estimator_service does. `take` gets every estimate it would have published. Refuses estimator settings out of range,
/// and when `keep_on` does.
Result<Done> identify(const Measurements& measured, const robot::Robot& robot,
                      const std::function<void(const signals::JointModelEstimate&)>& take, const KeepOn& keep_on = {});

}  // namespace farrier::playback
