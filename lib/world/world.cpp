#include "world/world.hpp"

namespace farrier::world {

World::~World() = default;

}  // namespace farrier::world
