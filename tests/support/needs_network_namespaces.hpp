#pragma once

#include <gtest/gtest.h>

#include "tests/support/network_namespaces.hpp"

namespace farrier::test {

/// Skips, with what is missing, where this computer gives no network namespaces. `Test`: testing::Test or one of its kind.
template <class Test>
class NeedsNetworkNamespaces : public Test {
 protected:
  void SetUp() override {
    if (const std::string refusal = NetworkNamespaces::refusal(); !refusal.empty()) {
      GTEST_SKIP() << refusal;
    }
  }
};

}  // namespace farrier::test
