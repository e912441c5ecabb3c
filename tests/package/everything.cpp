// One header for all: a world is read, solved and drawn, and a bad one is refused by the library's own exception.
#include <string>

#include <taut/taut.h>

bool everything_is_at_hand();

namespace {

bool refuses(const std::string& text) {
  try {
    taut::ReadOptions options;
    options.source = "broken.txt";
    taut::read_world(text, options);
  } catch (const taut::InputError& error) {
    return std::string(error.what()).starts_with("broken.txt:1:");
  }
  return false;
}

}  // namespace

bool everything_is_at_hand() {
  const taut::World world = taut::read_world("boundary 0 0 4 4\nstart 1 2\ngoal 3 2\n2 0 2 3\n");
  const taut::FreeSpace space(world);
  const auto path = taut::shortest_path(space, *world.start(), world.goal());
  return path && path->points.size() == 3 && refuses("one two three\n");
}
