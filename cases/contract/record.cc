#include "cases/contract/record.h"

namespace mb {

const char* to_string(TruthKind kind) { return kind == TruthKind::finer ? "finer" : "same_mesh"; }

}  // namespace mb
