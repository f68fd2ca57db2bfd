// A request that cannot be meant: exit code 2. what() says why and, where it can, what was meant.
#pragma once

#include <stdexcept>

namespace mb {

class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace mb
