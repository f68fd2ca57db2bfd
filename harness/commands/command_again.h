// How to go on with a run that was interrupted.
#pragma once

#include <string>

#include "harness/commands/commands.h"

namespace mb {

// Lines for who interrupted it: that what is finished is kept, and the command that goes on, as a shell takes it back.
std::string words_of_interruption(const RunCommandOptions& options);

}  // namespace mb
