#pragma once

// The two documents of DDS Security 1.1 (section 9.4.1) that the permissions CA signs. Governance gives the kinds of
// protection, permissions give the topics that a role may write.

#include <ctime>
#include <string>

#include "bus/roles.hpp"

namespace farrier::security {

/// Kinds of protection for all domains; the same for every process of a robot.
std::string governance_document();

/// Rights on `robot` of the certificate with this subject (RFC 2253): to write the topics of its role, as the registry
/// has it, and to read all, in the robot's partitions and no others. They last from `not_before` to `not_after`, a day
/// more at either end: Fast DDS takes these dates for local time. The certificate's own dates are the bound. Names of
/// robots need no escaping in XML: a robot file allows letters, digits, "_" and "-".
std::string permissions_document(const std::string& subject, bus::Role role, const std::string& robot,
                                 std::time_t not_before, std::time_t not_after);

}  // namespace farrier::security
