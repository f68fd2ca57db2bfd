// Trajectory files: whatever the bytes, they are refused in a sentence of our own, or hold what is written and read
// back the same, as an HDF5 file and as a trajectory. A forger knows both checksums: HDF5's are set right by the
// mutator, ours is before the trajectory is made of what was read.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "cases/scene/name.h"
#include "harness/store/hdf5.h"
#include "harness/store/hdf5_checksums_fuzz.h"
#include "harness/store/trajectory_content.h"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace {

using namespace mb;

void require(bool holds, const char* property) {
  if (!holds) throw std::logic_error(property);
}

void require_sentence(const std::runtime_error& refusal) {
  const std::string text = refusal.what();
  require(!text.empty() && std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; }),
          "refused with text of the input");
}

bool same(const MatrixXd& a, const MatrixXd& b) {  // bit for bit: some values are no numbers
  return a.rows() == b.rows() && a.cols() == b.cols() &&
         (a.size() == 0 || std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)) == 0);
}

void require_same(const Hdf5Content& a, const Hdf5Content& b) {
  require(a.counts == b.counts && a.texts == b.texts, "written and read, other counts or texts");
  require(a.matrices.size() == b.matrices.size(), "written and read, another number of matrices");
  for (const auto& [name, matrix] : a.matrices) {
    const auto found = b.matrices.find(name);
    require(found != b.matrices.end() && found->second.unit == matrix.unit && same(found->second.values, matrix.values),
            "written and read, another matrix");
  }
}

// As bytes again; nothing where its names or texts are none that are written.
std::string written(const Hdf5Content& content) try { return to_hdf5(content); } catch (const std::invalid_argument&) {
  return {};
} catch (const std::runtime_error& refusal) {
  require_sentence(refusal);
  return {};
}

void require_same_trajectory(const Trajectory& before) {
  const Trajectory after = trajectory_of(content_of(before));
  require(same(after.t, before.t) && after.status == before.status && after.bodies.size() == before.bodies.size(),
          "written and read, another trajectory");
  for (std::size_t k = 0; k < before.bodies.size(); ++k) {
    const BodyTrajectory &a = before.bodies[k], &b = after.bodies[k];
    require(a.displacement.rows() == b.displacement.rows() && a.displacement.cols() == b.displacement.cols(),
            "written and read, displacements of another size");
    require(a.contact.touches.size() == b.contact.touches.size(), "written and read, other touches");
    require(b.displacement.cols() == after.t.size(), "displacements at other times");
    // What has no low rank stands as it was; factors give it to the stated tolerance of the largest.
    require(a.displacement.allFinite(), "read what is not finite");
    const double largest = a.displacement.stableNorm();
    if (std::isfinite(largest) && largest > 1e-290)
      require((a.displacement - b.displacement).stableNorm() <= 1e-10 * largest,
              "written and read, it moves otherwise");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Hdf5Content content;
  try {
    content = from_hdf5({reinterpret_cast<const char*>(data), size});
  } catch (const std::runtime_error& refusal) {
    require_sentence(refusal);
    return 0;
  }
  if (const std::string bytes = written(content); !bytes.empty()) require_same(content, from_hdf5(bytes));
  content.texts["checksum"] = checksum_of(content);
  Trajectory trajectory;
  try {
    trajectory = trajectory_of(content);
  } catch (const std::runtime_error& refusal) {
    require_sentence(refusal);
    return 0;
  }
  require(trajectory.case_name.empty() || is_name(trajectory.case_name), "a case's name is none");
  require_same_trajectory(trajectory);
  return 0;
}

namespace {

template <class Map>
auto any_of(Map& map, std::mt19937& random) {
  return std::next(map.begin(), static_cast<std::ptrdiff_t>(random() % map.size()));
}

// A sound file of other content: another size, value, count, status or name.
void alter(Hdf5Content& content, std::mt19937& random) {
  static const double values[] = {0, -0.0, 1, -1, 1e-320, 1e308, std::numeric_limits<double>::infinity(), std::nan("")};
  static constexpr long counts[] = {0, 1, 2, -1, 64, 65, 1L << 40};
  static const char* const suffixes[] = {"displacement",
                                         "displacement_shapes",
                                         "displacement_amplitudes",
                                         "strain",
                                         "contact_force",
                                         "contact_impulse",
                                         "contact_energy",
                                         "energy",
                                         "momentum",
                                         "touch_times",
                                         "touch_peaks",
                                         "touch_impulses"};
  if (content.matrices.empty() || content.counts.empty()) return;
  const auto matrix = any_of(content.matrices, random);
  MatrixXd& A = matrix->second.values;
  switch (random() % 5) {
    case 0:
      if (A.size() > 0) A(static_cast<Index>(random() % static_cast<unsigned>(A.size()))) = values[random() % 8];
      break;
    case 1: {
      const MatrixXd old = A;
      A.setZero(static_cast<Index>(random() % 8), static_cast<Index>(random() % 8));
      const Index m = std::min(A.rows(), old.rows()), n = std::min(A.cols(), old.cols());
      A.topLeftCorner(m, n) = old.topLeftCorner(m, n);
      break;
    }
    case 2:
      any_of(content.counts, random)->second = counts[random() % 7];
      break;
    case 3:
      content.matrices.erase(matrix);
      break;
    default:
      content.matrices["body" + std::to_string(random() % 3) + "_" + suffixes[random() % 12]] = matrix->second;
  }
}

// A message of an object's header moved to a continuation, with another one, which may stand there for a second time:
// no change of bytes alone comes to that.
std::string with_another_message(std::string file, std::mt19937& random) {
  const std::vector<Hdf5Message> all = Hdf5Checksums(file).messages();
  if (all.empty()) return file;
  const auto text_of = [&](const Hdf5Message& m) { return file.substr(m.at, m.prefix + m.size); };
  const Hdf5Message &moved = all[random() % all.size()], &other = all[random() % all.size()];
  std::string another = text_of(random() % 2 == 0 ? moved : other);
  char& letter = another[random() % another.size()];
  if (random() % 4 != 0) letter = static_cast<char>(letter ^ (1 << random() % 8));
  return continued(file, moved, random() % 2 == 0 ? text_of(moved) + another : another + text_of(moved));
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
  std::mt19937 random(seed);
  std::string file(reinterpret_cast<const char*>(data), size);
  if (random() % 2 == 0) try {
      Hdf5Content content = from_hdf5(file);
      for (unsigned i = 0; i <= random() % 4; ++i) alter(content, random);
      const std::string altered = written(content);
      if (!altered.empty() && altered.size() <= max_size) {
        std::memcpy(data, altered.data(), altered.size());
        return altered.size();
      }
    } catch (const std::runtime_error&) {  // no file: its bytes alone
    }
  if (random() % 4 == 0) {
    const std::string more = with_another_message(file, random);
    if (more.size() > file.size() && more.size() <= max_size) {
      std::memcpy(data, more.data(), more.size());
      return more.size();
    }
  }
  file.assign(reinterpret_cast<const char*>(data), LLVMFuzzerMutate(data, size, max_size));
  Hdf5Checksums(file).set_right();
  std::memcpy(data, file.data(), file.size());
  return file.size();
}
