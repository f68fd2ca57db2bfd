#include "harness/store/hdf5_limits.h"

#include <stdexcept>

#include "harness/store/hdf5_structures.h"

namespace mb {

namespace {

void require_name(const std::string& name) {
  if (name.empty() || name.size() > hdf5_max_name || name == "." ||
      name.find_first_of(std::string("/\0", 2)) != name.npos)
    throw std::invalid_argument("an object or attribute has a name of 1 to 64 bytes that is no path, not " +
                                quoted(name));
}

void require_text(const std::string& name, const std::string& text) {
  if (text.empty() || text.size() > hdf5_max_text || text.find('\0') != text.npos)
    throw std::invalid_argument("text " + quoted(name) + " is not of 1 to 4096 bytes other than 0");
}

void require_few_objects(std::size_t n, const char* what) {
  if (n > static_cast<std::size_t>(hdf5_max_objects))
    throw std::invalid_argument(std::to_string(n) + " " + what + ", more than " + std::to_string(hdf5_max_objects) +
                                " that are read again");
}

}  // namespace

void require_few_values(Index n_values) {
  if (n_values > hdf5_max_elements)
    throw std::invalid_argument(std::to_string(n_values) + " values, more than " + std::to_string(hdf5_max_elements) +
                                " (512 MiB) that are read again");
}

void require_writable(const Hdf5Content& content) {
  require_few_objects(content.counts.size() + content.texts.size(), "counts and texts");
  require_few_objects(content.matrices.size(), "matrices");
  for (const auto& [name, count] : content.counts) require_name(name);
  for (const auto& [name, text] : content.texts) {
    require_name(name);
    require_text(name, text);
  }
  Index n_values = 0;
  for (const auto& [name, matrix] : content.matrices) {
    require_name(name);
    require_text(name, matrix.unit);
    n_values += matrix.values.size();
  }
  require_few_values(n_values);
}

}  // namespace mb
