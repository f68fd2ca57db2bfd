#include "harness/store/trajectory_content.h"

#include <limits>
#include <stdexcept>

#include "cases/scene/name.h"
#include "harness/store/contact_content.h"
#include "harness/store/hash.h"
#include "harness/store/hdf5_limits.h"
#include "harness/store/low_rank.h"

namespace mb {

namespace {

constexpr long max_bodies = 64;
constexpr const char* format = "modalbench trajectory";
constexpr const char* layout =
    "bodyK_displacement[time, 3 point + axis] and bodyK_strain[time, 6 point + component (xx yy zz yz xz xy, "
    "engineering)],"
    " or the product of bodyK_..._amplitudes[time, rank] and bodyK_..._shapes[rank, value]";

std::string body_key(long body, const std::string& quantity) { return "body" + std::to_string(body) + "_" + quantity; }

using Matrices = std::map<std::string, Hdf5Matrix>;

Matrices as_stored(const std::string& key, const MatrixXd& values, const std::string& unit) {
  if (auto factors = low_rank(values, trajectory_tolerance)) {
    return {{key + "_shapes", {std::move(factors->left), unit}},
            {key + "_amplitudes", {std::move(factors->right), "-"}}};
  }
  return {{key, {values, unit}}};
}

template <typename Value>
const Value& find(const std::map<std::string, Value>& values, const std::string& key) {
  const auto found = values.find(key);
  if (found == values.end()) throw std::runtime_error("'" + key + "' is missing");
  return found->second;
}

Status status_from(const std::string& text) {
  for (const Status status : {Status::ok, Status::not_finite, Status::no_convergence, Status::too_many_steps,
                              Status::unstable, Status::inverted}) {
    if (text == to_string(status)) return status;
  }
  throw std::runtime_error("its status is unknown");
}

// Throws std::invalid_argument with the first time at which something is no number.
void require_finite(const MatrixXd& values, const VectorXd& t, long body, const char* what) {
  for (Index k = 0; k < values.cols(); ++k)
    if (!values.col(k).allFinite())
      throw std::invalid_argument("trajectory: the " + std::string(what) + " of body " + std::to_string(body) +
                                  " is not finite at t = " + std::to_string(t[k]) + " s");
}

bool ascends(const VectorXd& t) {
  return t.size() < 2 || (t.tail(t.size() - 1).array() > t.head(t.size() - 1).array()).all();
}

Index n_contact_values(const BodyTrajectory& body) {
  const auto& [force, impulse, stored, dissipated, touches] = body.contact;
  constexpr Index per_touch = 7;  // start, end, peak and its time, impulse
  return force.size() + impulse.size() + stored.size() + dissipated.size() + body.energy.size() + body.momentum.size() +
         per_touch * static_cast<Index>(touches.size());
}

// How many more values may be read.
class Room {
 public:
  void take(Index n) {
    if (n > left_) throw std::runtime_error("holds more than 512 MiB of values");
    left_ -= n;
  }
  void take(Index rows, Index cols) {  // whose product may be too large for a number
    if (cols > 0 && rows > left_ / cols) take(left_ + 1);
    take(rows * cols);
  }

 private:
  Index left_ = hdf5_max_elements;
};

// values x n_t, finite; 0 x 0 where nothing is stored under the key.
MatrixXd values_of(const Matrices& matrices, const std::string& key, Index n_t, Index per_point, Room& room) {
  const auto plain = matrices.find(key);
  const bool factors = plain == matrices.end();
  if (factors && !matrices.contains(key + "_shapes")) return {};
  const MatrixXd& left = factors ? find(matrices, key + "_shapes").values : plain->second.values;
  const MatrixXd& right = factors ? find(matrices, key + "_amplitudes").values : left;
  if (factors && left.cols() != right.rows()) throw std::runtime_error("'" + key + "' has factors of different rank");
  if (right.cols() != n_t || left.rows() % per_point != 0) throw std::runtime_error("'" + key + "' has a wrong size");
  room.take(left.rows(), right.cols());
  MatrixXd values = factors ? MatrixXd(left * right) : left;
  if (!values.allFinite()) throw std::runtime_error("'" + key + "' is not finite");
  return values;
}

// Throws std::invalid_argument where it is none that is read again.
void require_readable(const Trajectory& trajectory) {
  if (trajectory.bodies.size() > static_cast<std::size_t>(max_bodies))
    throw std::invalid_argument("trajectory: more than " + std::to_string(max_bodies) + " bodies");
  try {
    require_few_values(n_values(trajectory));
  } catch (const std::invalid_argument& many) {
    throw std::invalid_argument("trajectory: " + std::string(many.what()));
  }
  if (!trajectory.t.allFinite()) throw std::invalid_argument("trajectory: its times are not finite");
  if (!ascends(trajectory.t)) throw std::invalid_argument("trajectory: its times do not ascend");
}

}  // namespace

std::string checksum_of(const Hdf5Content& content) {
  std::string all;
  for (const auto& [name, count] : content.counts) all += name + "=" + std::to_string(count) + ";";
  for (const auto& [name, text] : content.texts) {
    if (name != "checksum") all += name + "=" + content_hash(text) + ";";
  }
  for (const auto& [name, matrix] : content.matrices) {
    const std::string_view bytes(reinterpret_cast<const char*>(matrix.values.data()),
                                 static_cast<std::size_t>(matrix.values.size()) * sizeof(double));
    all += name + "[" + matrix.unit + "]" + std::to_string(matrix.values.rows()) + "x" +
           std::to_string(matrix.values.cols()) + "=" + content_hash(bytes) + ";";
  }
  return content_hash(all);
}

Index n_values(const Trajectory& trajectory) {
  Index n = trajectory.t.size();
  for (const BodyTrajectory& body : trajectory.bodies)
    n += body.displacement.size() + body.strain.size() + n_contact_values(body);
  return n;
}

Hdf5Content content_of(const Trajectory& trajectory) {
  require_readable(trajectory);
  const Index n_t = trajectory.t.size();
  const Work& work = trajectory.work;
  Hdf5Content content;
  content.counts = {{"schema", trajectory_schema},
                    {"bodies", static_cast<long>(trajectory.bodies.size())},
                    {"steps", work.steps},
                    {"rejected", work.rejected},
                    {"factorisations", work.factorisations},
                    {"solves", work.solves},
                    {"load_evaluations", work.load_evaluations}};
  content.texts = {{"format", format}, {"layout", layout}, {"status", to_string(trajectory.status)}};
  if (!trajectory.case_name.empty()) content.texts["case"] = trajectory.case_name;
  content.matrices["t"] = {trajectory.t, "s"};
  for (std::size_t k = 0; k < trajectory.bodies.size(); ++k) {
    const MatrixXd &displacement = trajectory.bodies[k].displacement, &strain = trajectory.bodies[k].strain;
    if (displacement.cols() != n_t || displacement.rows() % 3 != 0 || strain.rows() % 6 != 0 ||
        (strain.cols() != n_t && strain.cols() != 0)) {
      throw std::invalid_argument("trajectory: sizes of displacement and strain do not agree with its times");
    }
    require_finite(displacement, trajectory.t, static_cast<long>(k), "displacement");
    require_finite(strain, trajectory.t, static_cast<long>(k), "strain");
    content.matrices.merge(as_stored(body_key(static_cast<long>(k), "displacement"), displacement, "m"));
    if (strain.size() > 0) content.matrices.merge(as_stored(body_key(static_cast<long>(k), "strain"), strain, "-"));
    content.matrices.merge(contact_content("body" + std::to_string(k), trajectory.bodies[k], n_t));
  }
  content.texts["checksum"] = checksum_of(content);
  return content;
}

Trajectory trajectory_of(const Hdf5Content& content) {
  const auto count = [&](const char* key, long highest) {
    const long value = find(content.counts, key);
    if (value < 0 || value > highest) throw std::runtime_error("'" + std::string(key) + "' is out of range");
    return value;
  };
  constexpr long any = std::numeric_limits<long>::max();
  if (find(content.texts, "format") != format) throw std::runtime_error("is not a trajectory");
  if (count("schema", any) != trajectory_schema) throw std::runtime_error("has another schema than 1");
  if (find(content.texts, "checksum") != checksum_of(content)) throw std::runtime_error("checksum does not match");

  Trajectory trajectory;
  const MatrixXd& t = find(content.matrices, "t").values;
  if (t.cols() != 1) throw std::runtime_error("'t' has a wrong size");
  if (!t.allFinite()) throw std::runtime_error("'t' is not finite");
  trajectory.t = t.col(0);
  if (!ascends(trajectory.t)) throw std::runtime_error("'t' does not ascend");
  trajectory.status = status_from(find(content.texts, "status"));
  if (const auto named = content.texts.find("case"); named != content.texts.end()) {
    if (!is_name(named->second)) throw std::runtime_error("'case' is not a name");
    trajectory.case_name = named->second;
  }
  trajectory.work = {.steps = count("steps", any),
                     .rejected = count("rejected", any),
                     .factorisations = count("factorisations", any),
                     .solves = count("solves", any),
                     .load_evaluations = count("load_evaluations", any)};
  Room room;
  room.take(t.size());
  for (long k = 0, n = count("bodies", max_bodies); k < n; ++k) {
    find(content.matrices, content.matrices.contains(body_key(k, "displacement")) ? body_key(k, "displacement")
                                                                                  : body_key(k, "displacement_shapes"));
    trajectory.bodies.push_back({values_of(content.matrices, body_key(k, "displacement"), t.rows(), 3, room),
                                 values_of(content.matrices, body_key(k, "strain"), t.rows(), 6, room)});
    read_contact(content.matrices, "body" + std::to_string(k), t.rows(), trajectory.bodies.back());
    room.take(n_contact_values(trajectory.bodies.back()));
  }
  return trajectory;
}

}  // namespace mb
