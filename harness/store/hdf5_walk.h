// What HDF5's own structures may say, checked before the library reads any of them: version 1.10 of it follows an
// address beyond the end of a file, and decodes some messages beyond their own end.
//
//   superblock 2 or 3 -> root's object header, version 2 -> messages -> links -> datasets' headers -> chunks
//
// Every address lies within the file, every message within its chunk; what files of ours do not need is refused: dense
// attributes and links (heaps, B-trees), shared messages, messages that an object has one of and states twice, fill
// values, other indices of chunks than one chunk and the fixed array, types other than plain integers, floats and
// texts, filters other than shuffle and deflate, objects of two names.
//
// What reading would take is counted by headers alone, before any chunk is unpacked: messages, chunks, values and what
// chunks unpack to, of all datasets together.
//
// HDF5 File Format Specification Version 3.0, sections II.A, IV.A and VII.C.
#pragma once

#include <string_view>

namespace mb {

// Throws std::runtime_error with one sentence that names the fault.
void require_plain_structures(std::string_view hdf5_file);

}  // namespace mb
