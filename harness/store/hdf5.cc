#include "harness/store/hdf5.h"

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <utility>
#include <variant>
#include <vector>

#include "harness/store/hdf5_dataset.h"
#include "harness/store/hdf5_limits.h"
#include "harness/store/hdf5_structures.h"
#include "harness/store/hdf5_walk.h"

namespace mb {
namespace {

static_assert(std::endian::native == std::endian::little && sizeof(long) == sizeof(std::int64_t));
constexpr hsize_t chunk_elements = hdf5_max_chunk / sizeof(double);  // half of the library's chunk cache
constexpr unsigned deflate = 1, max_stride = 64;                     // strides of the second shuffle, see the header
const char* const failed = "HDF5 failed";
using Size = std::array<hsize_t, 2>;

[[noreturn]] void fail(const std::string& fault) { throw std::runtime_error(fault); }
void check(herr_t result, const std::string& fault) {
  if (result < 0) fail(fault);
}

// What HDF5 opened, closed again.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t), const std::string& fault) : id_(id), close_(close) {
    if (id < 0) fail(fault);
  }
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

// No messages on stderr, no code from plugin folders. Both are per-process states of the library: set at every entry.
void quiet_and_closed() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  check(H5PLset_loading_state(0), "HDF5 plugins cannot be switched off");
}

// The memory of a file, taken over when the library closes it: H5Fget_file_image leaves a wrong checksum (HDF5 1.10.8).
struct Image {
  std::size_t size = 0;
  std::unique_ptr<char, decltype(&std::free)> bytes{nullptr, &std::free};
};
using Operation = H5FD_file_image_op_t;

void* resize(void* bytes, std::size_t size, Operation, void* image) {
  std::size_t& old_size = static_cast<Image*>(image)->size;
  char* const resized = static_cast<char*>(std::realloc(bytes, size));
  if (resized == nullptr) return nullptr;
  if (size > old_size) std::memset(resized + old_size, 0, size - old_size);  // no stray secrets
  old_size = size;
  return resized;
}
void* allocate(std::size_t size, Operation operation, void* image) { return resize(nullptr, size, operation, image); }
void* copy(void* to, const void* from, std::size_t size, Operation, void*) { return std::memcpy(to, from, size); }
herr_t release(void* bytes, Operation operation, void* image) {
  if (operation == H5FD_FILE_IMAGE_OP_FILE_CLOSE) {
    static_cast<Image*>(image)->bytes.reset(static_cast<char*>(bytes));
  } else {
    std::free(bytes);
  }
  return 0;
}

// Files live in memory and close with all that was opened in them: damaged ones leave things open.
Handle access_in_memory() {
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, failed);
  check(H5Pset_fapl_core(access, 4096, false), failed);
  check(H5Pset_fclose_degree(access, H5F_CLOSE_STRONG), failed);
  return access;
}

// Unique: two files in memory with the same name are one to the library. The owner lives as long as the file.
std::string file_name(const void* owner) { return "memory-" + std::to_string(reinterpret_cast<std::uintptr_t>(owner)); }

Handle text_type(std::size_t size) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose, failed);
  check(H5Tset_size(type, size), failed);
  return type;
}

void write_attribute(hid_t of, const std::string& name, hid_t type, const void* value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose, failed);
  const Handle attribute(H5Acreate2(of, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         "attribute " + quoted(name) + " cannot be made");
  check(H5Awrite(attribute, type, value), "attribute " + quoted(name) + " cannot be written");
}

void write_text(hid_t of, const std::string& name, const std::string& text) {
  write_attribute(of, name, text_type(text.size()), text.data());
}

void write_matrix(hid_t file, const std::string& name, const Hdf5Matrix& matrix, unsigned stride) {
  const Size size{static_cast<hsize_t>(matrix.values.cols()), static_cast<hsize_t>(matrix.values.rows())};
  const Handle space(H5Screate_simple(2, size.data(), nullptr), H5Sclose, failed);
  const Handle create(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, failed);
  check(H5Pset_obj_track_times(create, false), failed);  // the same content gives the same bytes
  if (matrix.values.size() > 0) {
    const hsize_t rows = std::min(size[1], chunk_elements);
    const Size chunk{std::min(size[0], std::max<hsize_t>(1, chunk_elements / rows)), rows};
    check(H5Pset_chunk(create, 2, chunk.data()), failed);
    check(H5Pset_shuffle(create), failed);
    // The library sets the first shuffle's stride to the size of a double and leaves those of others alone.
    if (stride > 1) check(H5Pset_filter(create, H5Z_FILTER_SHUFFLE, H5Z_FLAG_MANDATORY, 1, &stride), failed);
    check(H5Pset_deflate(create, deflate), "HDF5 was built without deflate");
  }
  const Handle dataset(H5Dcreate2(file, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, create, H5P_DEFAULT),
                       H5Dclose, "dataset " + quoted(name) + " cannot be made");
  check(H5Dwrite(dataset, H5T_IEEE_F64LE, H5S_ALL, H5S_ALL, H5P_DEFAULT, matrix.values.data()),
        "dataset " + quoted(name) + " cannot be written");
  write_text(dataset, "unit", matrix.unit);
}

std::string read_text(hid_t attribute, hid_t type, const std::string& what) {
  const std::size_t size = H5Tget_size(type);
  if (H5Tis_variable_str(type) != 0 || size == 0 || size > hdf5_max_text) fail(what + " is no text of 1 to 4096 bytes");
  std::string text(size, '\0');
  check(H5Aread(attribute, text_type(size), text.data()), what + " cannot be read");
  return text.substr(0, text.find('\0'));
}

struct Attribute {
  std::string name;
  std::variant<long, std::string> value;
};

Attribute read_attribute(hid_t of, hsize_t index) {
  const Handle attribute(H5Aopen_by_idx(of, ".", H5_INDEX_NAME, H5_ITER_INC, index, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                         "an attribute is damaged");
  std::array<char, hdf5_max_name + 1> name{};
  const ssize_t size = H5Aget_name(attribute, name.size(), name.data());
  if (size <= 0 || size > static_cast<ssize_t>(hdf5_max_name)) fail("an attribute has a name of a wrong length");
  const std::string what = "attribute " + quoted(name.data());
  const Handle space(H5Aget_space(attribute), H5Sclose, what + " is damaged");
  if (H5Sget_simple_extent_type(space) != H5S_SCALAR) fail(what + " is not a single value");
  const Handle type(H5Aget_type(attribute), H5Tclose, what + " is damaged");
  if (H5Tget_class(type) == H5T_STRING) return {name.data(), read_text(attribute, type, what)};
  if (H5Tequal(type, H5T_STD_I64LE) <= 0) fail(what + " is neither a text nor a 64-bit integer");
  long value = 0;
  check(H5Aread(attribute, H5T_NATIVE_LONG, &value), what + " cannot be read");
  return {name.data(), value};
}

std::vector<Attribute> read_attributes(hid_t of) {
  H5O_info_t object{};
  check(H5Oget_info2(of, &object, H5O_INFO_NUM_ATTRS), "an object is damaged");
  if (object.num_attrs > static_cast<hsize_t>(hdf5_max_objects)) fail("an object has more than 1024 attributes");
  std::vector<Attribute> attributes;
  for (hsize_t i = 0; i < object.num_attrs; ++i) attributes.push_back(read_attribute(of, i));
  return attributes;
}

// The names of the root's objects, each a dataset; links of other kinds than hard ones are refused before.
std::vector<std::string> dataset_names(hid_t file) {
  H5G_info_t group{};
  check(H5Gget_info(file, &group), "the root group is damaged");
  if (group.nlinks > static_cast<hsize_t>(hdf5_max_objects)) fail("more than 1024 objects");
  std::vector<std::string> names;
  std::array<char, hdf5_max_name + 1> name{};
  for (hsize_t i = 0; i < group.nlinks; ++i) {
    const ssize_t size =
        H5Lget_name_by_idx(file, ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(), name.size(), H5P_DEFAULT);
    if (size <= 0 || size > static_cast<ssize_t>(hdf5_max_name)) fail("an object has a name of a wrong length");
    const std::string what = "object " + quoted(name.data());
    H5O_info_t object{};
    check(H5Oget_info_by_name2(file, name.data(), &object, H5O_INFO_BASIC, H5P_DEFAULT), what + " is damaged");
    if (object.type != H5O_TYPE_DATASET) fail(what + " is not a dataset");
    names.emplace_back(name.data());
  }
  return names;
}

// At most `room` elements.
Hdf5Matrix read_matrix(hid_t file, const std::string& name, Index room) {
  const std::string what = "dataset " + quoted(name);
  const Handle dataset(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose, what + " is damaged");
  const Handle type(H5Dget_type(dataset), H5Tclose, what + " is damaged");
  if (H5Tequal(type, H5T_IEEE_F64LE) <= 0) fail(what + " does not hold little-endian doubles");
  const Handle space(H5Dget_space(dataset), H5Sclose, what + " is damaged");
  Size size{};
  if (H5Sget_simple_extent_ndims(space) != 2 || H5Sget_simple_extent_dims(space, size.data(), nullptr) != 2) {
    fail(what + " is not a matrix");
  }
  const auto limit = static_cast<hsize_t>(room);
  if (size[0] > limit || size[1] > limit || (size[1] > 0 && size[0] > limit / size[1])) {
    fail(what + " is too large: 512 MiB are the limit for all together");
  }
  const std::vector<Attribute> attributes = read_attributes(dataset);
  if (attributes.size() != 1 || attributes[0].name != "unit" || attributes[0].value.index() != 1) {
    fail(what + " has no unit, or more than that");
  }
  MatrixXd values(static_cast<Index>(size[1]), static_cast<Index>(size[0]));
  check(H5Dread(dataset, H5T_IEEE_F64LE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), what + " cannot be read");
  return {std::move(values), std::get<std::string>(attributes[0].value)};
}

void write_content(hid_t access, const std::string& name, const Hdf5Content& content, unsigned stride) {
  const Handle create(H5Pcreate(H5P_FILE_CREATE), H5Pclose, failed);
  check(H5Pset_obj_track_times(create, false), failed);
  check(H5Pset_attr_phase_change(create, hdf5_max_objects, 0), failed);  // never dense, which would take a heap
  check(H5Pset_link_phase_change(create, hdf5_max_objects, 0), failed);
  const Handle file(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, create, access), H5Fclose, failed);
  for (const auto& [key, count] : content.counts) write_attribute(file, key, H5T_STD_I64LE, &count);
  for (const auto& [key, text] : content.texts) write_text(file, key, text);
  for (const auto& [key, matrix] : content.matrices) write_matrix(file, key, matrix, stride);
  check(H5Fflush(file, H5F_SCOPE_GLOBAL), "the file cannot be written to memory");
}

std::string image_of(const Hdf5Content& content, unsigned stride) {
  Image image;
  const Handle access = access_in_memory();
  H5FD_file_image_callbacks_t callbacks{
      &allocate, &copy, &resize, &release, [](void* udata) { return udata; }, [](void*) { return 0; }, &image};
  check(H5Pset_file_image_callbacks(access, &callbacks), failed);
  check(H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110), failed);  // checksums on its own structures too
  write_content(access, file_name(&image), content, stride);
  if (image.bytes == nullptr) fail(failed);
  return whole_file({image.bytes.get(), image.size});
}

}  // namespace

std::string to_hdf5(const Hdf5Content& content) {
  require_writable(content);
  quiet_and_closed();
  for (unsigned stride = 1; stride <= max_stride; ++stride) {
    const std::string bytes = image_of(content, stride);
    if (refused_structure(bytes).empty()) return bytes;
  }
  fail("values cannot be told from structures of HDF5 that are refused");
}

Hdf5Content from_hdf5(std::string_view bytes) {
  quiet_and_closed();
  if (const std::string structure = refused_structure(bytes); !structure.empty()) fail("holds " + structure);
  const Handle access = access_in_memory();
  std::string image = whole_file(bytes);
  if (image.size() != bytes.size()) fail("something follows its end");
  require_plain_structures(image);
  check(H5Pset_file_image(access, image.data(), image.size()), "not an HDF5 file");
  const Handle file(H5Fopen(file_name(&image).c_str(), H5F_ACC_RDONLY, access), H5Fclose, "not a whole HDF5 file");
  Hdf5Content content;
  for (Attribute& attribute : read_attributes(file)) {
    if (const long* const count = std::get_if<long>(&attribute.value)) {
      content.counts[attribute.name] = *count;
    } else {
      content.texts[attribute.name] = std::get<std::string>(attribute.value);
    }
  }
  Index room = hdf5_max_elements;
  for (const std::string& name : dataset_names(file)) {
    Hdf5Matrix matrix = read_matrix(file, name, room);
    room -= matrix.values.size();
    content.matrices[name] = std::move(matrix);
  }
  return content;
}

bool hdf5_plugins_are_off() {
  unsigned mask = ~0u;
  return H5PLget_loading_state(&mask) >= 0 && mask == 0;
}

Index open_hdf5_objects() {
  const ssize_t n = H5Fget_obj_count(H5F_OBJ_ALL, H5F_OBJ_ALL);
  if (n < 0) fail(failed);
  return n;
}

}  // namespace mb
