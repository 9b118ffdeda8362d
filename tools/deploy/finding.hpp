#pragma once

#include <string>
#include <vector>

namespace farrier::deploy {

/// Something that keeps a robot from running on a computer as it should.
struct Finding {
  std::string what;   ///< with what was measured
  std::string fix;    ///< what a person does about it
  bool fault = true;  ///< false: good to know, and nothing of Farrier's suffers from it
};

using Findings = std::vector<Finding>;

inline void append(Findings& findings, const Findings& more) {
  findings.insert(findings.end(), more.begin(), more.end());
}

}  // namespace farrier::deploy
