// A certificate with the run 1 that it was won in: what somebody else needs to check all of it.
#pragma once

#include <vector>

#include <taut/robots/micromouse/certificate.h>

namespace taut::micromouse {

struct CertifiedRun {
  Certificate certificate;
  std::vector<Action> run1;
};

/// Precondition: the certificate is the record's own.
CertifiedRun certified_run(const Certificate& certificate, const Record& record);

/// verify_certificate() against the maze, with the run 1 it tells: that is done again by the rules, and checked as
/// verify_record() does.
Finding verify_certificate(const CertifiedRun& certified, const GridMaze& maze);

}  // namespace taut::micromouse
