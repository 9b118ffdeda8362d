#include <gtest/gtest.h>

#include "peer.hpp"

int main(int argc, char** argv) {
  const int role = farrier::contract::run_role({argv + 1, argv + argc});
  if (role >= 0) {
    return role;
  }
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
