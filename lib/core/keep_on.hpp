#pragma once

#include <functional>

namespace farrier {

/// Asked again and again by long work, with the share of it that is done, 0 to 1; it stops where the answer is false. An
/// empty one need not be asked.
using KeepOn = std::function<bool(double share)>;

}  // namespace farrier
