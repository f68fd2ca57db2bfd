#include "modal/contact/body_pair.h"

#include <gtest/gtest.h>

#include "mechanics/geometry/signed_distance.h"
#include "modal/contact/contact_step.h"
#include "modal/contact/floating_bodies_test.h"
#include "modal/contact/meetings.h"
#include "modal/contact/surface_polynomials.h"
#include "modal/frame/turn.h"

namespace mb::testing {
namespace {

constexpr double R = 0.05;
const Shape ball = Sphere{R};
const Shape board = Box{{0.4, 0.1, 0.04}};

// A ball whose samples meet a board, random modes on both; static shapes that vary slowly from sample to sample.
struct Two {
  PolynomialBasis of_ball, of_board;
  FloatingBody a, b;

  Two(Index r, Index n_static, const PenaltyLaw& law, const Vector3d& gravity = Vector3d::Zero())
      : of_ball(random_modes(ball, 2, r, 0.3, 1)),
        of_board(random_modes(board, 3, r, 0.3, 2)),
        a(floating(ball, std::vector<Roots>(static_cast<size_t>(r), roots({4e6, 0})), gravity)),
        b(floating(board, std::vector<Roots>(static_cast<size_t>(r), roots({1e6, 0})), gravity)) {
    SurfaceSamples samples = samples_of(ball, of_ball, {1e-3, 1e-2, 0.3, 2}, {Vector3d(0, 0, -R)});
    const Index m = samples.w.size();
    MatrixXd Psi_b(3 * m, n_static);
    samples.Psi.resize(3 * m, n_static);
    Matrix3Xd feet(3, m);
    for (Index i = 0; i < m; ++i) {
      const Vector3d X = samples.X.col(i);
      feet.col(i) << X.head<2>(), 0.02;
      for (Index k = 0; k < n_static; ++k) {
        samples.Psi.block<3, 1>(3 * i, k) << 0.1 * X.x(), 0.02, 1 - static_cast<double>(k) * X.y();
        Psi_b.block<3, 1>(3 * i, k) << 0.03, 0.1 * X.y(), -0.5 - X.x();
      }
    }
    a.static_stiffness = b.static_stiffness = 2e3 * MatrixXd::Identity(n_static, n_static);
    a.contacts.push_back({std::move(samples), {}, law});
    a.contacts.back().partner =
        std::make_shared<const PartnerSurface>(partner_surface(1, board, of_board, feet, Psi_b));
  }
  // That deep in the board that lies below, but for static shapes.
  BodyState above(double depth) const {
    BodyState state = at_rest(a, {0.01, -0.02, 0.018 + R});  // deep enough to begin with
    state.q.setConstant(1e-4);
    const BodyState other = below();
    BodyPair pair(a, b, a.contacts.front());
    for (int k = 0; k < 3; ++k) {
      pair.look({&state, Vector3d::Zero(), &state.p}, {&other, Vector3d::Zero(), &other.p});
      state.c.z() -= pair.least_gap() + depth;
    }
    return state;
  }
  BodyState below() const {
    BodyState state = at_rest(b, {0, 0, 0});
    state.q.setConstant(-2e-4);
    state.Q = turned(state.Q, {0.01, 0.02, 0.3});
    return state;
  }
};

// Modes of the board known near its middle alone: who presses elsewhere gets no wrong answer, nor one far from it.
TEST(BodyPair, IsRefusedWhereModesAreNotKnown) {
  Two two(2, 0, {1e9, 0, {}});
  PartnerSurface local = *two.a.contacts.front().partner;
  const Monomials near_middle(0, Vector3d::Zero(), {0.01, 0.01, 0.02});
  local.geometry = PolynomialBasis(near_middle, MatrixXd::Zero(3, 2));
  two.a.contacts.front().partner = std::make_shared<const PartnerSurface>(local);
  BodyPair pair(two.a, two.b, two.a.contacts.front());
  const BodyState still = at_rest(two.b, {0, 0, 0});
  const auto look = [&](double x, double height) {
    const BodyState state = at_rest(two.a, {x, 0, 0.02 + R + height});
    pair.look({&state, Vector3d::Zero(), &state.p}, {&still, Vector3d::Zero(), &still.p});
    return pair.least_gap();
  };
  EXPECT_LT(look(0, -1e-5), 0);
  EXPECT_GT(look(0.03, 0.05), 0);  // high above
  EXPECT_THROW(look(0.03, -1e-5), std::runtime_error);
}

struct Loads {
  ContactLoad a, b;
};
Loads loads_of(const Two& two, BodyState a, BodyState b) {
  ContactLoads loads({&two.a, &two.b});
  Loads all;
  const std::vector<Looked> looked{{&a, angular_velocity(two.a, a), &a.p, &all.a},
                                   {&b, angular_velocity(two.b, b), &b.p, &all.b}};
  loads(looked);
  return all;
}

// The k-th of all coordinates of a state moved by e: place, rotation, modes.
BodyState moved(BodyState state, Index k, double e) {
  if (k < 3)
    state.c[k] += e;
  else if (k < 6)
    state.Q = turned(state.Q, e * Vector3d::Unit(k - 3));
  else
    state.q[k - 6] += e;
  return state;
}
VectorXd generalised(const ContactLoad& load) {
  VectorXd all(6 + load.modal.size());
  all << load.force, load.torque, load.modal;
  return all;
}

TEST(BodyPair, ForcesAreTheGradientOfWhatIsStored) {
  for (const Index n_static : {0, 2}) {
    const Two two(3, n_static, {1e9, 0, {}});
    const BodyState a = two.above(2e-4), b = two.below();
    const Loads at = loads_of(two, a, b);
    ASSERT_GT(at.a.stored, 0);
    constexpr double e = 1e-7;
    for (Index k = 0; k < 9; ++k) {
      const auto stored = [](const Loads& l) { return l.a.stored + l.b.stored; };
      const double by_a =
          (stored(loads_of(two, moved(a, k, e), b)) - stored(loads_of(two, moved(a, k, -e), b))) / (2 * e);
      const double by_b =
          (stored(loads_of(two, a, moved(b, k, e))) - stored(loads_of(two, a, moved(b, k, -e)))) / (2 * e);
      // Apart by the foot's own way, strain by depth, and by static shapes, which follow the samples, not the feet.
      const double scale =
          std::max(generalised(at.a).segment(k < 6 ? k / 3 * 3 : 6, 3).norm(), 0.1 * at.a.force.norm() * R);
      EXPECT_NEAR(-by_a, generalised(at.a)[k], 5e-3 * scale) << k << " " << n_static;
      EXPECT_NEAR(-by_b, generalised(at.b)[k], 5e-3 * scale) << k << " " << n_static;
    }
  }
}

TEST(BodyPair, MomentaAreHandedOver) {
  Two two(3, 2, {1e9, 0.1, Friction{0.3, 0.1}});
  BodyState a = two.above(3e-4), b = two.below();
  a.v << 0.3, 0.1, -1;
  a.p.setConstant(0.1), b.p.setConstant(-0.2);
  a.L << 1e-3, 2e-3, 0;
  const Loads at = loads_of(two, a, b);
  ASSERT_GT(at.a.force.norm(), 0.1);
  EXPECT_GT(at.a.dissipation, 0);
  EXPECT_LT((at.a.force + at.b.force).norm(), 1e-13 * at.a.force.norm());  // rounding
  const Vector3d about_b = at.a.torque + (a.c - b.c).cross(at.a.force) + at.b.torque;
  EXPECT_LT(about_b.norm(), 1e-13 * at.a.force.norm());
}

TEST(BodyPair, StiffnessIsTheDerivativeOfTheLoads) {
  const Two two(2, 2, {1e9, 0, {}});
  BodyState a = two.above(1e-4), b = two.below();
  ContactLoads loads({&two.a, &two.b});
  Loads all;
  const std::vector<Looked> looked{{&a, Vector3d::Zero(), &a.p, &all.a}, {&b, Vector3d::Zero(), &b.p, &all.b}};
  loads(looked);
  VectorXd s(4);
  s << a.s, b.s;
  const MatrixXd K = loads.stiffness(s, 0);
  ASSERT_EQ(K.rows(), 16);
  ASSERT_GT(all.a.force.norm(), 0);
  constexpr double e = 1e-8;
  for (Index k = 0; k < 16; ++k) {
    const auto at = [&](double by) {
      const Loads l = k < 8 ? loads_of(two, moved(a, k, by), b) : loads_of(two, a, moved(b, k - 8, by));
      VectorXd f(16);
      f << generalised(l.a), generalised(l.b);
      return f;
    };
    const VectorXd column = -(at(e) - at(-e)) / (2 * e);
    // What curvature and rotation add to the layer's stiffness is the force by a length, gap by length of it: 1e-4/R.
    const double size = K.col(2).norm() * (k % 8 >= 3 && k % 8 < 6 ? R : 1);
    EXPECT_LE((column - K.col(k)).norm(), 0.02 * size) << k;
  }
}

// Two rigid balls head on: each leaves as the closed form of an elastic blow has it.
TEST(BodyPair, RigidBallsExchangeVelocities) {
  for (const double ratio : {1.0, 8.0}) {
    const double R2 = R * std::cbrt(ratio);
    const Shape other = Sphere{R2};
    const PolynomialBasis none = no_modes(ball), none2 = no_modes(other);
    FloatingBody a = floating(ball, {}, Vector3d::Zero()), b = floating(other, {}, Vector3d::Zero());
    SurfaceSamples samples = samples_of(ball, none, {5e-4, 1e-2, 0.3, 2}, {Vector3d(R, 0, 0)});
    const Index m = samples.w.size();
    a.contacts.push_back({std::move(samples), {}, {1e10, 0, {}}});
    a.contacts.back().partner = std::make_shared<const PartnerSurface>(
        partner_surface(1, other, none2, Matrix3Xd::Constant(3, m, R2), MatrixXd(3 * m, 0)));
    const BodyState at_a = at_rest(a, {0, 0, 0}, {2, 0, 0}), at_b = at_rest(b, {R + R2 + 0.1, 0, 0}, {-1, 0, 0});
    std::vector<ImpactPlan> plans{plan_of(a, ball, none, at_a, ContactScheme::exact, 1e-6),
                                  plan_of(b, other, none2, at_b, ContactScheme::exact, 1e-6)};
    const VectorXd t{{0.05}};
    const auto motions = impact_motions(plans, t);
    ASSERT_EQ(motions[0].status, Status::ok);
    ASSERT_EQ(motions[0].contact.touches.size(), 1);
    EXPECT_NEAR(motions[0].contact.touches[0].start, 0.1 / 3, 2e-7);  // samples 0.2 mm off, by 2 R and the speed
    const double m_a = a.mass, m_b = b.mass, common = (2 * m_a - m_b) / (m_a + m_b);
    EXPECT_NEAR(motions[0].states[0].v.x(), 2 * common - 2, 1e-4);  // steps of order 2
    EXPECT_NEAR(motions[1].states[0].v.x(), 2 * common + 1, 1e-4);
    EXPECT_NEAR(m_a * motions[0].states[0].v.x() + m_b * motions[1].states[0].v.x(), 2 * m_a - m_b, 1e-12 * m_a);
  }
}

TEST(Meetings, FirstTouchOfTwoFlyingBodies) {
  const Two two(0, 0, {1e9, 0, {}}, {0, 0, -9.81});
  BodyState a = at_rest(two.a, {0.02, 0, 0.5}, {0, 0, 0}), b = at_rest(two.b, {0, 0, 0}, {0, 0, 3});
  b.L = two.b.inertia * Vector3d(0, 0, 2);  // about the way of approach: the touch stays where it is
  std::vector<ImpactPlan> plans{plan_of(two.a, ball, two.of_ball, a, ContactScheme::exact, 1e-4),
                                plan_of(two.b, board, two.of_board, b, ContactScheme::exact, 1e-4)};
  std::vector<BodyFlight> flights;
  for (const ImpactPlan& plan : plans) flights.emplace_back(plan.body, plan.start, 0);
  const auto touch = Meetings(plans).next(flights, 1, false);
  ASSERT_TRUE(touch);
  EXPECT_NEAR(touch->t, (0.5 - 0.02 - R) / 3, 3e-7);  // the nearest sample is 0.3 mm off the lowest point
  EXPECT_FALSE(Meetings(plans).next(flights, 0.1, false));
}

}  // namespace
}  // namespace mb::testing
