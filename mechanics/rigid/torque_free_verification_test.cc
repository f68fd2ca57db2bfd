#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "mechanics/rigid/random_test_body.h"
#include "mechanics/rigid/taylor_test_rotation.h"
#include "mechanics/rigid/torque_free.h"
#include "mechanics/verified_test.h"

namespace mb {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;

struct Reference {
  Vector3d moments, omega0;  // [kg m^2], [rad/s]; the orientation at t = 0 is the identity
  double t;                  // [s]
  Vector3d omega;            // [rad/s] body axes
  Eigen::Vector4d q;         // w, x, y, z
};

// 50 digits (mpmath) by another route: theta and psi from elliptic functions, phi by quadrature of phi' = |L| (l1^2/I1
// + l2^2/I2) / (l1^2 + l2^2) over whole periods and the rest, in Euler's angles about axis 3.
const std::vector<Reference> references = {
    // general, m = 0.146471
    {{0.2465475375497368, 0.2316956119452933, 0.4528420477241286},
     {1.942615737064146, 0.7597035510160698, -0.9742811885827218},
     6.787295713467834,
     {1.75541799089697587, 1.12441812955900544, -0.987185867688897868},
     {0.975448175783884877, 0.102435086441184449, 0.0427939308932265893, -0.190201442960835723}},
    // general, long, m = 0.882737
    {{1.0330500721052167, 0.7985021332089125, 1.5652905623184168},
     {1.5509778113792616, 1.2646500407848185, -0.6868840328104868},
     2254074.8718285845,
     {2.04130796459673445, -0.132636035806381276, -0.340919174469193489},
     {0.0155234494130236032, 0.896465373288299319, 0.220623306032533685, -0.383971631567576149}},
    // near the separatrix, m = 0.996467
    {{0.9341843918440311, 0.6279197936399706, 0.8021938523878432},
     {-0.25915453769343405, -0.26151098398117395, 1.8997252784647571},
     1826.5500187967489,
     {-0.117759433923543553, 0.0913110406234505963, -1.9282176424895602},
     {0.0942962404280505347, 0.349673457728037224, 0.928497666716475393, 0.0820291100994935501}},
    // two moments equal to 1e-12, long, m = 2.14069e-9
    {{1.2189070683222776, 1.1760922474776008, 1.1760922474781785},
     {-0.20378990622555387, 1.4497219666894414, -2.1740146123375386},
     2001955.308687175,
     {-0.203789906357305554, 2.4951834814533392, 0.775946331383688878},
     {0.485165355291647943, -0.439120518483549781, 0.71273111574799823, -0.252590785493218228}},
    // flat, long, m = 0.117673
    {{0.4249622083393701, 0.373064856621737, 0.7975482553254012},
     {-1.8907677878557432, -1.044087550354685, 1.5329219236394211},
     3163568.3570099594,
     {-1.89713577494240258, -1.03247337826058956, 1.53240929660381067},
     {0.979301605743458233, 0.108699185550618867, 0.0525613019338736452, -0.162450489651255263}},
    // three moments equal to 1e-9, long, m = 0.110421
    {{0.9691719924534747, 0.9691719928551196, 0.9691719923115958},
     {0.42300311969656296, -0.2764386217524766, 1.7390814352086328},
     2859193.447173208,
     {0.422231792163509669, -0.27674626357775206, 1.73921994251414211},
     {0.428904482468958158, 0.21077342373402402, -0.137875594403274543, 0.867528575456403311}},
    // intermediate axis, long, 1 - m = 7.12e-8
    {{0.862788191135836, 0.5906448845258654, 0.39408902681915203},
     {1.1208356501840979e-13, -0.3036629358575676, 7.556816711826715e-05},
     6553800.620250106,
     {-0.00359310686095311996, 0.30358888034739152, 0.00625622811391134676},
     {0.0103221241231013303, 0.868913363273006028, 0.00414981543387498493, 0.494839165700376955}},
    // intermediate axis, 1 - m = 5.42e-10
    {{1.391812808854896, 0.9582183693765925, 1.4676480713696232},
     {0.9882144939132548, -2.2295787182842303e-09, -2.06606158333238e-05},
     127.83986644306931,
     {-0.988213523103058567, -0.000644108899345343048, -0.00124464838114504873},
     {-0.000673063613703281262, -0.000230156282235834207, 0.999960339994637016, 0.00887763770761112754}},
    // near a stable axis, long, m = 8.36397e-8
    {{0.9378146815465329, 1.1548280617294364, 1.785422482500628},
     {1.7939657888003024, -1.3172610221217036e-05, 0.00022052017644844332},
     2750122.2260933896,
     {1.79396572345694764, -0.000506048602911336239, -0.000079053383796723138},
     {0.887345900759829701, -0.461104365192732088, -0.0000588820627118352539, 0.000115489552387371323}},
    // needle, m = 0.000222242
    {{1.0, 1.0000625, 9.765625e-05},
     {0.25, -0.5, 30.0},
     700.25,
     {0.219726954397506041, -0.514021680557202092, 30.0001516856480227},
     {-0.578497500501795299, -0.342714659617683782, 0.739880484353973267, -0.0215446714628098252}},
    // needle across, long, m = 0.0296627
    {{1.0, 9.765625e-05, 1.0000625},
     {-0.25, 0.0625, 1.5},
     100000.0,
     {0.112068365935490123, 0.189392211489982446, 1.51655347385174215},
     {-0.0771197524493999137, -0.0455366600745017075, 0.00926400786297683327, 0.995938318637111814}},
};

TEST(TorqueFreeVerification, FiftyDigitsUpToAMillionRevolutions) {
  double worst = 0;
  for (const Reference& r : references) {
    const TorqueFree body(r.moments, Quaterniond::Identity(), r.omega0);
    const Rotation exact{Quaterniond(r.q[0], r.q[1], r.q[2], r.q[3]), r.omega}, found = body.at(r.t);
    const double phase = 1 + body.max_angular_speed() * r.t;
    EXPECT_TRUE(found.angular_velocity.allFinite());
    // A few roundings of the two phases.
    EXPECT_LE(difference(exact, found), 4 * eps * phase) << r.moments.transpose();
    worst = std::max(difference(exact, found) / phase, worst);
  }
  testing::expect_verified(
      {.quantity = "orientation [rad] or relative angular velocity of 11 free bodies, over 1 + largest speed x time",
       .reference = "table",
       .source = "Euler's angles in mpmath, 50 digits: two by elliptic functions, the third by quadrature",
       .uncertainty = "rounding of 18 digits to doubles",
       .tolerance = 4 * eps,
       .why = "A few roundings of the two phases, which grow with the angle turned through."},
      worst);
}

TEST(TorqueFreeVerification, TaylorSeriesOfEulersEquations) {
  std::mt19937 generator(20);
  double worst = 0;
  for (int i = 0; i < 400; ++i) {
    const auto [I, w, q, t] = random_body(generator, i % 8);
    const TorqueFree body(I, q, w);
    const Rotation found = body.at(t);
    const double error = difference(taylor::rotation(I, q, w, t), found), bar = rounding(body, I, q, w, t);
    EXPECT_TRUE(found.angular_velocity.allFinite()) << i;
    EXPECT_LE(error, bar) << i;
    worst = std::max(4 * eps * error / bar, worst);
  }
  testing::expect_verified(
      {.quantity =
           "orientation [rad] or relative angular velocity of 400 bodies, over 1 + largest speed x time + condition",
       .reference = "second route",
       .source = "Taylor series of Euler's equations of order 24 in long double (taylor_test_rotation.h)",
       .uncertainty = "rounding to doubles; that of long double, magnified alike, is 2000 times smaller",
       .tolerance = 4 * eps,
       .why = "A few roundings of the phases and of data, which motion near the intermediate axis magnifies."},
      worst);
}

// Oblate and prolate: the axis goes about L at |L|/I1, the body about its axis at w3 (1 - I3/I1) (Landau & Lifshitz,
// Mechanics, sect. 33).
TEST(TorqueFreeVerification, SymmetricTop) {
  std::mt19937 generator(3);
  std::normal_distribution<double> normal;
  double worst = 0;
  for (const double I3 : {1.9, 1.0 + 1e-12, 1.0 - 1e-12, 0.3, 1e-4})
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d I = Vector3d::Ones() + (I3 - 1) * Vector3d::Unit(axis);
      const Vector3d w(normal(generator), normal(generator), normal(generator)), L = I.cwiseProduct(w);
      const Quaterniond q0(AngleAxisd(1.2, Vector3d(1, 2, -2) / 3));
      const TorqueFree body(I, q0, w);
      for (const double t : {0.0, 0.7, 31.0, -1e4}) {
        const AngleAxisd precession(L.norm() * t, q0 * L.normalized());
        const AngleAxisd spin(w[axis] * (1 - I3) * t, Vector3d::Unit(axis));
        const Rotation exact{precession * q0 * spin, spin.inverse() * w}, found = body.at(t);
        const double phase = 1 + w.norm() * std::abs(t);
        EXPECT_TRUE(found.angular_velocity.allFinite());
        EXPECT_LE(difference(exact, found), 8 * eps * phase) << I3 << ' ' << axis;
        worst = std::max(difference(exact, found) / phase, worst);
      }
    }
  testing::expect_verified(
      {.quantity = "orientation [rad] or relative angular velocity of oblate and prolate tops, over 1 + speed x time",
       .reference = "exact solution",
       .source = "Landau and Lifshitz, Mechanics, sect. 33",
       .uncertainty = "rounding",
       .tolerance = 8 * eps,
       .why = "A few roundings of the phases, here and in the formula, which grow with the angle turned through."},
      worst);
}

// Turned on about the intermediate axis and pushed by epsilon, it flips after 2K / lambda; for I = 1, 2, 3 that is
// 2 sqrt(3 / (1 + epsilon^2)) K with m1 = epsilon^2 / (1 + epsilon^2), K = ln(4 / sqrt m1) + O(m1 ln m1).
TEST(TorqueFreeVerification, DzhanibekovFlip) {
  double worst = 0;
  for (const double epsilon : {1e-8, 1e-10, 1e-20, 1e-100, 1e-140}) {
    const TorqueFree body({1, 2, 3}, Quaterniond::Identity(), {epsilon, 1, 0});
    const double flip = 2 * std::sqrt(3.0) * std::log(4 / epsilon);
    for (int n = 0; n <= 4; ++n) {
      const Rotation r = body.at(n * flip);
      EXPECT_NEAR(r.angular_velocity[1], n % 2 == 0 ? 1 : -1, 1e-14);
      EXPECT_NEAR((r.orientation * Vector3d::UnitY())[1], n % 2 == 0 ? 1 : -1, 1e-14);  // L = 2 y stays
      // Between flips it hesitates; half-way through one the spin is about z and x alone: w2 = 0.
      const double half_way = body.at((n + 0.5) * flip).angular_velocity[1];
      EXPECT_NEAR(half_way, 0, 1e-15 * (n + 1) * flip);
      worst = std::max(std::abs(half_way) / ((n + 1) * flip), worst);
    }
  }
  testing::expect_verified(
      {.quantity =
           "spin about the intermediate axis half-way through flips n = 1 to 5 [rad/s], over n times 2K/lambda [s]",
       .reference = "exact solution",
       .source = "Time of a flip from Jacobi's solution, K as m tends to 1 (DLMF 19.12.1)",
       .uncertainty = "5e-15 s of 69 s, the next terms in epsilon^2",
       .tolerance = 1e-15,
       .why = "Times are rounded to some 1e-16 of themselves, and the spin passes 0 at 0.58 rad/s^2."},
      worst);
}

// |L|^2 = 2 T I2 exactly: w = |L| (A sech u, tanh u, C sech u) / I. Rounding leaves m1 of some 1e-17, which grows as
// e^2u.
TEST(TorqueFreeVerification, Separatrix) {
  const Vector3d I(1, 2, 2.25), w0(0.75, 0, 1);
  const double L = I.cwiseProduct(w0).norm(), lambda = std::sqrt(0.5 * 1.25) * 0.75 / 1.5;
  const TorqueFree body(I, Quaterniond::Identity(), w0);
  for (double u = -8; u <= 8; u += 0.5) {
    const Rotation r = body.at(u / lambda);
    const double bar = 1e-15 * (1 + std::exp(2 * std::abs(u)));
    EXPECT_NEAR(r.angular_velocity[0], 0.75 / std::cosh(u), bar);
    EXPECT_NEAR(std::abs(r.angular_velocity[1]), L / 2 * std::abs(std::tanh(u)), bar);
    EXPECT_NEAR(r.angular_velocity[2], 1 / std::cosh(u), bar);
  }
}

}  // namespace
}  // namespace mb
