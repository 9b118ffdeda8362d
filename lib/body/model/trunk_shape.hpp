#pragma once

#include "body/model/body_model.hpp"

namespace farrier::body {

/// The trunk as pictures show it: the box spanned by the first hinges. Along an axis on which they do not differ it has
/// the side of the box of uniform density with the trunk's mass and inertia.
TrunkBox shown_trunk(const BodyModel& model);

}  // namespace farrier::body
