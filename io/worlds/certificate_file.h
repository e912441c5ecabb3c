// Certificates of a micromouse as files.
#pragma once

#include <string>
#include <string_view>

#include <taut/robots/micromouse/certified_run.h>

namespace taut {

/// JSON, one line a witness: `certificate` (the format's number), `width`, `height`, `start`, `goal`, `max_steps`,
/// `steps`, `route`; `openings` and `walls` as `{"cell": [x, y], "side": "north", "step": 12}`, step counting the steps
/// of run 1 from 0; `run1`, each step `[rotation, movement]` or `"reset"`. Same input, same bytes.
std::string certificate_text(const micromouse::CertifiedRun& certified);

/// Reads it back. Says nothing about whether it proves anything. Throws InputError, which names `source`, the line, and
/// what is missing or of the wrong kind.
micromouse::CertifiedRun read_certificate(std::string_view text, const std::string& source = {});

}  // namespace taut
