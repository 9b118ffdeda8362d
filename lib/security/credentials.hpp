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

/// Where the files of a role lie in `folder`, made absolute. Looks at nothing.
bus::SecurityFiles files_of(const std::string& folder, bus::Role role, bus::Vendor vendor);

/// The files of a role, checked at the time `now`: they are there and readable, the key is its owner's alone and that of
/// the certificate, the certificate is valid and of the identity CA, its subject suits the vendor, and both documents
/// are the permissions CA's, the permissions for that subject. Refuses with the file and the remedy.
Result<bus::SecurityFiles> credentials(const std::string& folder, bus::Role role, bus::Vendor vendor, std::time_t now);

/// "2027-01-31 12:00 UTC"
std::string date_text(std::time_t time);

}  // namespace farrier::security
