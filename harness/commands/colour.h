// Colour on a terminal, and nowhere else; never the only sign of anything.
#pragma once

#include <iosfwd>
#include <string>

namespace mb {

// Whether text written to the stream comes to a terminal that shows colour: std::cout or std::cerr of a terminal,
// unless NO_COLOR (no-color.org) is set to anything or TERM is "dumb".
bool shows_colour(const std::ostream& stream);

std::string yellow(const std::string& text, bool coloured);
std::string green(const std::string& text, bool coloured);

}  // namespace mb
