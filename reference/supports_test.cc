#include <gtest/gtest.h>

#include "reference/static_answer.h"

namespace mb {
namespace {

using testing::face;
using testing::load;
using testing::static_answer;
using testing::support;
using K = Support::Kind;

const Material rubber{2e4, 0.45, 1100};
const Shape box = Box{{0.3, 0.2, 0.5}}, cylinder = Cylinder{0.05, 0.2};

// Linear displacements u = G (x - x0) that a support admits are found exactly under their tractions, with curved cells
// to degree 2 (beyond, the quadrature of curved cells is not exact). Rounding: condition of K times 1e-16, and
// conjugate gradients to 1e-12 of the load.
void expect_linear(const Scene& scene, const Eigen::Matrix3d& G, const Vector3d& x0) {
  const auto answer = static_answer(scene);
  const Matrix3Xd expected = G * (answer.points.colwise() - x0);
  EXPECT_LT((answer.displacement - expected).cwiseAbs().maxCoeff(), 1e-9 * expected.cwiseAbs().maxCoeff())
      << to_string(scene.bodies[0].resolution);
}

TEST(SupportPatchTest, SlidingFacesCarryUniaxialTension) {
  // nu_yz, nu_xz, nu_xy
  const Material wood{1.2e10, 0, 450, Orthotropy{{1.2e10, 9e8, 5e8}, {0.43, 0.45, 0.37}, {4e7, 7.2e8, 8.5e8}}};
  for (int degree = 1; degree <= 4; ++degree) {
    Scene scene = one_body(box, wood, {degree, {2, 1, 3}});
    for (const char* name : {"x-min", "y-min", "z-min"})
      scene.bodies[0].supports.push_back(support(K::sliding, face(name)));
    const double sigma = 3e5, strain = sigma / 1.2e10;
    load(scene, "x-max", {sigma, 0, 0});
    expect_linear(scene, Vector3d(strain, -0.37 * strain, -0.45 * strain).asDiagonal(), {-0.15, -0.1, -0.25});
  }
}

TEST(SupportPatchTest, DiaphragmsAndAMeanCarryConfinedCompression) {
  const double strain = -0.01, D = 2e4 * (1 - 0.45) / ((1 + 0.45) * (1 - 2 * 0.45)), lambda = D * 0.45 / (1 - 0.45);
  const auto confined = [&](const Shape& shape, const Resolution& resolution, const std::vector<std::string>& sides) {
    Scene scene = one_body(shape, rubber, resolution);
    scene.bodies[0].supports = {support(K::diaphragm, face("z-min")), support(K::diaphragm, face("z-max")),
                                support(K::mean, face("z-min"))};
    for (const auto& side : sides) load(scene, side, {0, 0, 0}, -lambda * strain);
    load(scene, "z-max", {0, 0, D * strain});
    const Vector3d base(0, 0, plane_normal(shape, "z-min")[2] * face_distance(shape, "z-min", {0, 0, 0}));
    expect_linear(scene, Vector3d(0, 0, strain).asDiagonal(), -base);
  };
  for (int degree = 1; degree <= 4; ++degree) confined(box, {degree, {2, 1, 2}}, {"x-min", "x-max", "y-min", "y-max"});
  for (const Resolution& resolution :
       {Resolution{1, {0, 1}}, Resolution{2, {0, 2}}, Resolution{1, {2, 2}}, Resolution{2, {1, 2}}})
    confined(cylinder, resolution, {"side"});
}

TEST(SupportPatchTest, AFixedBaseCarriesSimpleShear) {
  const double gamma = 0.02, tau = gamma * 2e4 / (2 * 1.45);
  Eigen::Matrix3d G = Eigen::Matrix3d::Zero();
  G(0, 2) = gamma;
  for (int degree = 1; degree <= 4; ++degree) {
    Scene scene = one_body(box, rubber, {degree, {1, 2, 2}});
    scene.bodies[0].supports = {support(K::fixed, face("z-min"))};
    load(scene, "z-max", {tau, 0, 0});
    load(scene, "x-max", {0, 0, tau});
    load(scene, "x-min", {0, 0, -tau});
    expect_linear(scene, G, {0, 0, -0.25});
  }
}

TEST(Supports, LeaveTheRigidMotionsTheyDoNotHold) {
  const auto free_motions = [](const Shape& shape, const Resolution& resolution, const std::vector<Support>& supports) {
    Scene scene = one_body(shape, rubber, resolution);
    scene.bodies[0].supports = supports;
    const auto model = full_model(scene, scene.bodies[0], resolution);
    const System& s = model->system();
    EXPECT_LE((s.K * s.R).norm(), 1e-10 * s.K.norm() * s.R.norm());
    return s.R.cols();
  };
  const Patch bottom = face("z-min"), top = face("z-max");
  const Resolution disc{2, {1, 2}};
  EXPECT_EQ(free_motions(cylinder, disc, {support(K::fixed, bottom)}), 0);
  EXPECT_EQ(free_motions(cylinder, disc, {support(K::sliding, bottom)}), 3);  // two shifts, one turn
  EXPECT_EQ(free_motions(cylinder, disc, {support(K::mean, bottom)}), 5);     // no axial shift
  EXPECT_EQ(free_motions(cylinder, disc, {support(K::mean, bottom), support(K::mean, top)}), 5);  // the same shift
  EXPECT_EQ(free_motions(cylinder, disc, {support(K::diaphragm, bottom)}), 3);  // the axial shift, two tilts
  EXPECT_EQ(free_motions(cylinder, disc, {support(K::diaphragm, bottom), support(K::mean, top)}), 2);
  EXPECT_EQ(free_motions(cylinder, disc, {support(K::diaphragm, bottom), support(K::diaphragm, top)}), 1);
  const Patch corner{"z-min", Disc{{0.02, 0.01, -0.1}, 0.02}}, other{"z-min", Disc{{-0.02, 0, -0.1}, 0.02}};
  EXPECT_EQ(free_motions(cylinder, disc, {support(K::mean, corner), support(K::mean, other)}), 4);  // and one tilt
  EXPECT_EQ(free_motions(box, {1, {2, 2, 2}}, {support(K::sliding, bottom), support(K::sliding, face("x-min"))}), 1);
}

TEST(Supports, RefuseCurvedFacesAndNothingFree) {
  const auto model = [](const Shape& shape, const Resolution& resolution, const std::vector<Support>& supports) {
    Scene scene = one_body(shape, rubber, resolution);
    scene.bodies[0].supports = supports;
    return full_model(scene, scene.bodies[0], resolution);
  };
  EXPECT_THROW(model(cylinder, {1, {1, 1}}, {support(K::sliding, face("side"))}), std::invalid_argument);
  EXPECT_THROW(model(cylinder, {1, {1, 1}}, {support(K::diaphragm, face("side"))}), std::invalid_argument);
  EXPECT_THROW(model(cylinder, {1, {0, 1}}, {support(K::fixed, face("z-min")), support(K::fixed, face("z-max"))}),
               std::invalid_argument);
}

}  // namespace
}  // namespace mb
