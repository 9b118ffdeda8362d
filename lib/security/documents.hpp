#pragma once

// The two documents of DDS Security 1.1 (section 9.4.1) that the permissions CA signs: what is protected and how, and
// what a role may write.

#include <ctime>
#include <string>

#include "bus/roles.hpp"

namespace farrier::security {

/// What is protected and how, for all domains; alike for every process of a robot.
std::string governance_document();

/// What the certificate with this subject (RFC 2253) may do on `robot`: write the topics of its role, as the registry has
/// it, and read all, in the robot's partitions and no others. From `not_before` to `not_after`, a day more at either
/// end: Fast DDS takes these dates for local time. The certificate's own dates are the bound. Names of robots need no
/// escaping in XML: a robot file allows letters, digits, "_" and "-".
std::string permissions_document(const std::string& subject, bus::Role role, const std::string& robot,
                                 std::time_t not_before, std::time_t not_after);

}  // namespace farrier::security
