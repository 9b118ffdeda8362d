#pragma once

// The keys and documents of DDS Security for one robot, made with the openssl command line: what `--security` reads.

#include <string>

#include "core/result.hpp"

namespace farrier::pki {

struct Plan {
  std::string robot;  ///< name in its robot file, the DDS partition
  std::string out;    ///< folder to make, laid out as security/credentials.hpp says
  std::string ca;     ///< folder of the two CAs with their keys; made when it is not there
  int days = 365;     ///< for which the identities are valid
};

/// Makes an identity and permissions for each role on each vendor, issued by the CAs of `ca`. Each key is newly drawn.
/// Refuses an `out` that is there, a `ca` that is there and is not such a folder, or one inside the other; leaves no
/// half-made folder behind.
Result<Done> make(const Plan& plan);

}  // namespace farrier::pki
