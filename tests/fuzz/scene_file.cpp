// Scene files as people write them.

#include "tests/fuzz/harness.hpp"
#include "world/scene_file.hpp"

namespace farrier::fuzz {

void scene_file(Bytes bytes) {
  constexpr std::size_t kMostBoxes = 2000;
  const auto loaded = world::load_scene_text(std::string(text_of(bytes)), "fuzz.yaml");
  if (!loaded) {
    require(!loaded.error().empty(), "a refusal says why");
    return;
  }
  const body::Scene& scene = loaded.value();
  require(body::validate(scene).ok(), "a scene that loads is valid");
  require(scene.boxes.size() <= kMostBoxes, "a scene that loads can be simulated");
  require(body::push_force_N(scene, 0.0, 1.0).allFinite(), "pushes are finite");
}

}  // namespace farrier::fuzz
