#include <taut/robots/micromouse/certified_run.h>

namespace taut::micromouse {

CertifiedRun certified_run(const Certificate& certificate, const Record& record) {
  CertifiedRun certified{certificate, {}};
  for (const Step& step : record.steps)
    if (step.run == 1) certified.run1.push_back(step.action);
  return certified;
}

Finding verify_certificate(const CertifiedRun& certified, const GridMaze& maze) {
  const auto& [certificate, run1] = certified;
  if (Finding finding = verify_certificate(certificate, maze); !finding) return finding;
  Trial trial(maze, certificate.task.max_steps);
  for (const Action& action : run1) {
    if (trial.over() || trial.run() != 1) return {false, "run 1 ends before its last step"};
    trial.act(action);
  }
  if (Finding finding = verify_record(trial.record(), maze); !finding) return finding;
  return verify_certificate(certificate, maze, trial.record());
}

}  // namespace taut::micromouse
