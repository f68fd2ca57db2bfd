// Arrays in NumPy's format, version 1.0: a magic string, a header that is a Python literal, the numbers as they lie.
#pragma once

#include <filesystem>
#include <string>

#include "mechanics/types.h"

namespace mb {

// name-data.npy, name-indices.npy, name-indptr.npy: a matrix by compressed columns as SciPy's csc_matrix takes it.
// Throws std::runtime_error where a file cannot be written.
void write_npy(const std::filesystem::path& folder, const std::string& name, const SparseMatrix& A);

}  // namespace mb
