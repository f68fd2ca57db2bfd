// Numbers in messages, as people write them in a case file: 1e13 and 1e-6, not 1e+13 and 1e-06.
#pragma once

#include <string>

namespace mb {

std::string number_text(double x);  // the shortest that reads back as x, of nine digits or more

// Three digits, or as many as tell x from the limit that it is beyond: 1000001, not 1e6, beside 1e6.
std::string number_beside(double x, double limit);

// A bound that is computed, as a message shows it: 1e-7 for 0.1/1e6, which is a little more and would refuse 1e-7.
double nine_digits(double x);

}  // namespace mb
