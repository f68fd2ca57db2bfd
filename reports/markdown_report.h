// report.md: the whole report as one text, verdict first.
#pragma once

#include <string>

#include "reports/views.h"

namespace mb {

std::string markdown_report(const Evaluation& evaluation);

}  // namespace mb
