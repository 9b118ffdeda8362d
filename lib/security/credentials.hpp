#pragma once

// The folder that `--security` names, and what is checked of it before DDS starts:
//
//   identity_ca.pem  permissions_ca.pem  governance.p7s         alike on every computer of a robot
//   <role>.<vendor>/certificate.pem  key.pem  permissions.p7s   only where a process of that role runs

#include <ctime>
#include <string>

#include "bus/bus.hpp"
#include "bus/network.hpp"

namespace farrier::security {

/// Paths of a role's files in `folder`, made absolute. Does not read the disk.
bus::SecurityFiles files_of(const std::string& folder, bus::Role role, bus::Vendor vendor);

/// Returns the files of a role, checked at the time `now`. They are there and readable. Only its owner has access to
/// the key, which is that of the certificate. The certificate is valid and of the identity CA, and its subject suits
/// the vendor. Both documents are the permissions CA's, the permissions for that subject. Refuses with the file and the
/// remedy.
Result<bus::SecurityFiles> credentials(const std::string& folder, bus::Role role, bus::Vendor vendor, std::time_t now);

/// "2027-01-31 12:00 UTC"
std::string date_text(std::time_t time);

}  // namespace farrier::security
