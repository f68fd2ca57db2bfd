// A formula of the grammar of expression.h over a whole interval of times: bounds that hold each of its values, found
// by the same operations on intervals (natural extension; Moore, Interval Analysis, 1966). What samples may miss, a
// window shorter than their distance or a pole between two of them, these bounds show; they are wide where terms
// nearly cancel and close in, in proportion, as the interval gets shorter.
#pragma once

#include <functional>
#include <string>

#include "mechanics/history/interval.h"

namespace mb {

using Enclosure = std::function<Interval(const Interval& t)>;  // t [s]

// Throws std::domain_error where the text does not belong to the grammar.
Enclosure enclosure(const std::string& formula);

}  // namespace mb
