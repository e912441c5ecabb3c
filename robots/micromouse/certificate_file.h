// Certificates as files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <taut/robots/micromouse/certificate.h>

namespace taut::micromouse {

/// A certificate and the actions of the run 1 that it was won in.
struct CertificateFile {
  Certificate certificate;
  std::vector<Action> run1;
};

/// The certificate and run 1 of a record. Precondition: it is the record's own.
CertificateFile file_of(const Certificate& certificate, const Record& record);

/// JSON, one line a witness: `certificate` (the format's number), `width`, `height`, `start`, `goal`, `max_steps`,
/// `steps`, `route`; `openings` and `walls` as `{"cell": [x, y], "side": "north", "step": 12}`, step counting the steps
/// of run 1 from 0; `run1`, each step `[rotation, movement]` or `"reset"`. Same input, same bytes.
std::string certificate_text(const CertificateFile& file);

/// Reads it back. Says nothing about whether it proves anything. Throws InputError, which names `source`, the line
/// where it can, and what is missing or of the wrong kind.
CertificateFile read_certificate(std::string_view text, const std::string& source = {});

/// check_certificate() of it against the maze, with the run 1 it tells: that is done again by the rules, and checked as
/// check_record() does.
Finding check_certificate(const CertificateFile& file, const GridMaze& maze);

}  // namespace taut::micromouse
