// What is written can be read: content is held to the limits of the reader (hdf5.h) before it becomes a file.
#pragma once

#include "harness/store/hdf5.h"

namespace mb {

// Throws std::invalid_argument with both numbers where there are more than hdf5_max_elements values in all.
void require_few_values(Index n_values);

// Throws std::invalid_argument, naming what it is, where content is beyond a limit or has names that no reader takes.
void require_writable(const Hdf5Content& content);

}  // namespace mb
