#include <taut/cli/solve/batch_proofs.h>

#include <taut/geometry/errors.h>
#include <taut/geometry/plain_world.h>
#include <taut/io/results/path_certificate_text.h>
#include <taut/io/worlds/write_world.h>
#include <taut/search/path_certificate.h>

namespace taut::cli {

BatchProofs::BatchProofs(const FreeSpace& space)
    : plain_(is_plain(space.world(), space.footprint()) ? space : FreeSpace(plain_world(space))),
      graph_(plain_),
      world_(write_plain_integers(plain_.world())) {}

void BatchProofs::add(int line, const std::optional<Path>& path, Point from, Point to) {
  std::optional<PathCertificate> proof;
  try {
    const Goal goal{to, {}};
    proof = path ? shortest_certificate(graph_, *path, goal) : none_certificate(graph_, from, goal);
  } catch (const InputError&) {  // ends too fine for the world's lattice
  }
  missing_ += !proof;
  if (!proof) return;
  const std::string text = certificate_text(*proof, world_);
  proofs_ += proofs_.empty() ? "" : ",\n";
  proofs_ += "{\n\"line\": " + std::to_string(line) + "," + text.substr(1, text.size() - 2);
}

std::string BatchProofs::text() const { return "[\n" + proofs_ + "\n]\n"; }

}  // namespace taut::cli
