#include "reference/theory/theory_model.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>

namespace mb {

namespace {

// A product of half waves, amplitude sin(k_x x') sin(k_y y') with x', y' from an edge; of a beam k_y = 0, and the
// second factor is 1.
struct HalfWaves {
  int n, m;        // m = 0 of a beam
  double k_x, k_y; /* [1/m] */
  double omega;    // [rad/s]
};

// sin(n pi/2), the middle: exact zeros, which keep the even ones out of contact.
double at_middle(int n) { return n % 2 == 0 ? 0 : n % 4 == 1 ? 1 : -1; }

// Value, slope and bend of one factor at x'.
struct Factor {
  double f, f_x, f_xx;
};
Factor factor(double k, double x) {
  if (k == 0) return {1, 0, 0};
  const double s = std::sin(k * x), c = std::cos(k * x);
  return {s, k * c, -k * k * s};
}

using Triplets = std::vector<Eigen::Triplet<double>>;

SparseMatrix diagonal(const VectorXd& d) {
  SparseMatrix A(d.size(), d.size());
  A.reserve(Eigen::VectorXi::Ones(d.size()));
  for (Index i = 0; i < d.size(); ++i) A.insert(i, i) = d[i];
  A.makeCompressed();
  return A;
}

Vector3d box_of(const Body& body) {
  const Box* box = std::get_if<Box>(&body.shape);
  if (!box || !is_uniform(body.material))
    throw std::invalid_argument(
        fmt::format("theory '{}' is of isotropic boxes: body '{}' is none", to_string(body.theory), body.name));
  return box->size;
}

std::vector<HalfWaves> half_waves(const Body& body, const Resolution& resolution) {
  const Vector3d size = box_of(body);
  const bool beam = body.theory == Theory::euler_bernoulli;
  const std::vector<int>& cells = resolution.cells;
  bool possible = body.theory != Theory::solid && resolution.degree == 1 && resolution.graded == 0 &&
                  resolution.bias.empty() && resolution.distorted == 0 && cells.size() == (beam ? 1 : 2);
  for (const int n : cells) possible = possible && n >= 1 && n <= 1024;
  if (!possible)
    throw std::invalid_argument(fmt::format("body '{}' of theory '{}' has no half waves {}", body.name,
                                            to_string(body.theory), to_string(resolution)));
  const double E = body.material.youngs_modulus, nu = body.material.poissons_ratio, rho = body.material.density;
  // sqrt(E I/(rho A)) and sqrt(D/(rho h)) [m^2/s]
  const double c = size.z() * std::sqrt((beam ? E : E / (1 - nu * nu)) / (12 * rho));
  std::vector<HalfWaves> waves;
  for (int m = beam ? 0 : 1; m <= (beam ? 0 : cells[1]); ++m)
    for (int n = 1; n <= cells[0]; ++n) {
      const double k_x = n * pi / size.x(), k_y = m * pi / size.y();
      waves.push_back({n, m, k_x, k_y, c * (k_x * k_x + k_y * k_y)});
    }
  return waves;
}

class TheoryModel final : public FullModel {
 public:
  TheoryModel(const Body& body, const Striker& striker, const Resolution& resolution)
      : name_(body.name),
        beam_(body.theory == Theory::euler_bernoulli),
        size_(box_of(body)),
        nu_(body.material.poissons_ratio),
        waves_(half_waves(body, resolution)),
        amplitude_(std::sqrt((beam_ ? 2 : 4) / (body.material.density * size_.prod()))) {
    const Index n = n_waves() + 1;
    VectorXd M = VectorXd::Ones(n), K = VectorXd::Zero(n);
    M[n - 1] = striker.mass;
    for (Index i = 0; i < n - 1; ++i) K[i] = wave(i).omega * wave(i).omega;
    system_.M = diagonal(M);
    system_.K = diagonal(K);
    system_.damping = body.damping;
    system_.modal_damping.W = MatrixXd(n, 0);
    system_.R = VectorXd::Unit(n, n - 1) / std::sqrt(striker.mass);
    system_.F = MatrixXd(n, 0);
    system_.u0 = VectorXd::Zero(n);
    system_.v0 = -striker.speed * VectorXd::Unit(n, n - 1);
  }

  const System& system() const override { return system_; }

  SparseMatrix displacement_at(const Matrix3Xd& points) const override {
    return observed<3>(points, [](double z, const Factor& X, const Factor& Y) {
      return std::array{-z * X.f_x * Y.f, -z * X.f * Y.f_x, X.f * Y.f};
    });
  }

  SparseMatrix strain_at(const Matrix3Xd& points) const override {
    return observed<6>(points, [this](double z, const Factor& X, const Factor& Y) {
      const double xx = -z * X.f_xx * Y.f, yy = beam_ ? -nu_ * xx : -z * X.f * Y.f_xx;
      const double zz = beam_ ? -nu_ * xx : -nu_ / (1 - nu_) * (xx + yy);
      return std::array{xx, yy, zz, 0.0, 0.0, -2 * z * X.f_x * Y.f_x};
    });
  }

  MatrixXd polynomials(int) const override {
    throw std::invalid_argument(fmt::format("body '{}' moves in sine modes: it has no polynomials", name_));
  }

  // The one point there is, whatever the obstacle looks like: its distance is among the unknowns.
  ContactPoints contact_points(const RigidSurface&, double) const override {
    ContactPoints points{size_.z() / 2 * Vector3d::UnitZ(), VectorXd::Ones(1), SparseMatrix(3, n_waves() + 1)};
    Triplets entries;
    for (Index i = 0; i < n_waves(); ++i) {
      const double w = amplitude_ * at_middle(wave(i).n) * (beam_ ? 1 : at_middle(wave(i).m));
      if (w != 0) entries.emplace_back(2, i, w);
    }
    entries.emplace_back(2, n_waves(), -1);
    points.U.setFromTriplets(entries.begin(), entries.end());
    return points;
  }

  VectorXd translation(const Vector3d&) const override {
    throw std::invalid_argument(fmt::format("body '{}' is held by its theory: no translation moves it", name_));
  }
  Index n_cells() const override { return n_waves(); }
  double mesh_volume() const override { return size_.prod(); }

 private:
  Index n_waves() const { return static_cast<Index>(waves_.size()); }
  const HalfWaves& wave(Index i) const { return waves_[static_cast<size_t>(i)]; }

  // rows x n: what `values` makes of the height and the factors of each mode at each point. The ball moves no point of
  // the body.
  template <std::size_t rows, class Values>
  SparseMatrix observed(const Matrix3Xd& points, const Values& values) const {
    SparseMatrix U(static_cast<Index>(rows) * points.cols(), n_waves() + 1);
    Triplets entries;
    for (Index i = 0; i < n_waves(); ++i)
      for (Index p = 0; p < points.cols(); ++p) {
        const Factor X = factor(wave(i).k_x, points(0, p) + size_.x() / 2),
                     Y = factor(wave(i).k_y, points(1, p) + size_.y() / 2);
        const std::array<double, rows> of_point = values(points(2, p), X, Y);
        for (std::size_t k = 0; k < rows; ++k)
          if (of_point[k] != 0)
            entries.emplace_back(static_cast<Index>(rows) * p + static_cast<Index>(k), i, amplitude_ * of_point[k]);
      }
    U.setFromTriplets(entries.begin(), entries.end());
    return U;
  }

  std::string name_;
  bool beam_;
  Vector3d size_;
  double nu_;
  std::vector<HalfWaves> waves_;
  double amplitude_;  // [kg^-1/2] of modes of unit mass
  System system_;
};

}  // namespace

std::shared_ptr<const FullModel> theory_model(const Scene& scene, const Body& body, const Resolution& resolution) {
  const Obstacle* obstacle = striker_of(scene, body);
  if (!obstacle)
    throw std::invalid_argument(
        fmt::format("body '{}' of theory '{}': nothing strikes it", body.name, to_string(body.theory)));
  return std::make_shared<TheoryModel>(body, *obstacle->striker, resolution);
}

}  // namespace mb
