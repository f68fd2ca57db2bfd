#include "cases/contract/record.h"

namespace mb {

const char* to_string(TruthKind kind) {
  switch (kind) {
    case TruthKind::same_mesh:
      return "same_mesh";
    case TruthKind::finer:
      return "finer";
    case TruthKind::exact:
      return "exact";
    case TruthKind::same_modes:
      return "same_modes";
  }
  return "";
}

}  // namespace mb
