// What a result rests on, check by check, after Code_Aster's manual of validation: the case and where it comes from,
// the reference and its kind, how uncertain that is, the tolerance with its reason, and what came out.
#pragma once

#include <string>

#include "reports/views.h"

namespace mb {

// "static-correction r = 32: peak-force", "table locking-growth, column growth of static error, row Q1"
std::string checked(const Check& check);

Sheet verification_table(const Evaluation& evaluation);

// The same as a document of its own, with how it was made: what docs/verification.md is.
std::string verification_document(const Evaluation& evaluation);

}  // namespace mb
