#include "benchmarks/npy.h"

#include <fmt/format.h>

#include <bit>
#include <fstream>
#include <stdexcept>

namespace mb {
namespace {

static_assert(std::endian::native == std::endian::little, "the headers say little-endian");

void write(const std::filesystem::path& path, const char* type, const void* numbers, Index count, size_t size) {
  std::string header = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({},), }}", type, count);
  header.resize((header.size() + 11 + 63) / 64 * 64 - 11, ' ');  // with the magic and its own length a multiple of 64
  header += '\n';
  std::ofstream file(path, std::ios::binary);
  const auto length = static_cast<unsigned>(header.size());
  file << "\x93NUMPY" << '\x01' << '\0' << static_cast<char>(length & 0xff) << static_cast<char>(length >> 8) << header;
  file.write(static_cast<const char*>(numbers), static_cast<std::streamsize>(size * static_cast<size_t>(count)));
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace

void write_npy(const std::filesystem::path& folder, const std::string& name, const SparseMatrix& A) {
  write(folder / (name + "-data.npy"), "<f8", A.valuePtr(), A.nonZeros(), sizeof(double));
  write(folder / (name + "-indices.npy"), "<i4", A.innerIndexPtr(), A.nonZeros(), sizeof(int));
  write(folder / (name + "-indptr.npy"), "<i4", A.outerIndexPtr(), A.cols() + 1, sizeof(int));
}

}  // namespace mb
