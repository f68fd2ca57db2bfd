// What UMFPACK says, in words. For the files of this folder alone.
#pragma once

#include <string>

namespace mb::umfpack {

std::string describe(int status);

}  // namespace mb::umfpack
