#include "tests/ros/fast_sender.hpp"

namespace farrier::test {

bool has_fast_sender() { return false; }

std::unique_ptr<Sender> make_fast_sender(int, const std::string&, const std::string&, bool) { return nullptr; }

}  // namespace farrier::test
