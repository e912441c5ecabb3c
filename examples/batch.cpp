// batch MAZE: lengths of the shortest paths between `sx sy gx gy` lines of standard input, on a world that is prepared once.
#include <iostream>

#include <taut/io/worlds/read_world.h>
#include <taut/search/polyanya.h>

int main(int argc, char** argv) {
  if (argc != 2) return std::cerr << "usage: batch MAZE < QUERIES\n", 2;
  const taut::FreeSpace space(taut::read_world_file(argv[1]));
  taut::PolyanyaSearch search{taut::Polyanya(space)};  // its memory is used again for each query
  for (taut::Point s, g; std::cin >> s.x >> s.y >> g.x >> g.y;) {
    try {
      if (search.find(s, g) == taut::SearchStatus::found)
        std::cout << search.result().path.length.decimals(6) << '\n';
      else
        std::cout << "none\n";
    } catch (const taut::InputError& error) {  // an end in a wall
      std::cout << "refused: " << error.what() << '\n';
    }
  }
}
