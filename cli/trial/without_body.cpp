#include "cli/base/command.hpp"
#include "cli/trial/body_trial.hpp"

namespace farrier::cli {

int run_body_trials(const BodyTrialOptions&) {
  return refuse("trial",
                "trial body needs MuJoCo 2.2.2, and this build has none: install libmujoco-dev and build again, as "
                "./farrier trial body does");
}

}  // namespace farrier::cli
