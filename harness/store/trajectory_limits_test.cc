// What is written is read: the same limits hold on both sides, in values, bodies and the order of times.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "harness/store/trajectory_content.h"

namespace mb {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// A body with everything that one may have: 2 x 3 + 2 x 6 values, 15 of contact and one touch of 7 for each time.
BodyTrajectory touching(Index n_t) {
  BodyTrajectory body{MatrixXd::Random(6, n_t), MatrixXd::Random(12, n_t)};
  body.contact = {Matrix3Xd::Ones(3, n_t), Matrix3Xd::Ones(3, n_t), VectorXd::Ones(n_t), VectorXd::Ones(n_t), {}};
  for (Index k = 0; k < n_t; ++k) {
    const auto start = static_cast<double>(k);
    body.contact.touches.push_back({start, start + 0.5, 1, start + 0.25, Vector3d::Ones()});
  }
  body.energy = VectorXd::Ones(n_t), body.momentum = MatrixXd::Ones(6, n_t);
  return body;
}

Trajectory touching_bodies(std::size_t n_bodies, Index n_t) {
  Trajectory trajectory{VectorXd::LinSpaced(n_t, 0, 1), {}, {}, Status::ok};
  trajectory.bodies.assign(n_bodies, touching(n_t));
  return trajectory;
}

TEST(TrajectoryLimits, EveryValueIsCounted) {
  EXPECT_EQ(n_values(touching_bodies(2, 5)), 5 * (1 + 2 * (18 + 15 + 7)));
  EXPECT_EQ(n_values({VectorXd::LinSpaced(4, 0, 1), {{MatrixXd(3, 4), MatrixXd(6, 0)}}, {}, Status::ok}), 16);
}

// What stands in a file is never more than what is counted, so that a file of few enough values is read, too.
TEST(TrajectoryLimits, NoMoreIsStoredThanIsCounted) {
  Trajectory smooth{VectorXd::LinSpaced(9, 0, 1), {}, {}, Status::ok};
  const MatrixXd motion = VectorXd::LinSpaced(30, 1, 2) * smooth.t.transpose();
  smooth.bodies = {{motion, motion}, {motion.topRows(3), MatrixXd(0, 9)}};
  for (const Trajectory& trajectory : {smooth, touching_bodies(3, 7)}) {
    Index n_stored = 0;
    for (const auto& [name, matrix] : content_of(trajectory).matrices) n_stored += matrix.values.size();
    EXPECT_LE(n_stored, n_values(trajectory));
  }
}

TEST(TrajectoryLimits, AsManyBodiesInContactAsACaseMayHaveAreRead) {
  const Trajectory after = trajectory_of(from_hdf5(to_hdf5(content_of(touching_bodies(64, 3)))));
  ASSERT_EQ(after.bodies.size(), 64u);
  EXPECT_EQ(after.bodies[63].momentum, MatrixXd::Ones(6, 3));
  EXPECT_EQ(after.bodies[63].contact.touches.size(), 3u);
  EXPECT_THAT([] { content_of(touching_bodies(65, 3)); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("more than 64 bodies")));
}

TEST(TrajectoryLimits, MoreValuesThanAreReadAreNotWritten) {
  constexpr Index n_t = 1 << 13, rows = 3 * 2731;  // 2^26 and some; never touched
  Trajectory trajectory{VectorXd::LinSpaced(n_t, 0, 1), {}, {}, Status::ok};
  trajectory.bodies.push_back({MatrixXd(rows, n_t), MatrixXd(0, n_t)});
  EXPECT_THAT([&] { content_of(trajectory); },
              ThrowsMessage<std::invalid_argument>(
                  AllOf(HasSubstr("trajectory: 67125248 values"), HasSubstr("more than 67108864 (512 MiB)"))));
}

Hdf5Content of_factors(Index rows, Index n_t, long n_bodies) {
  Hdf5Content content = content_of({VectorXd::LinSpaced(n_t, 0, 1), {}, {}, Status::ok});
  content.counts["bodies"] = n_bodies;
  for (long k = 0; k < n_bodies; ++k) {
    const std::string key = "body" + std::to_string(k) + "_displacement";
    content.matrices[key + "_shapes"] = {MatrixXd::Ones(k + 1 < n_bodies ? 3 : rows, 1), "m"};
    content.matrices[key + "_amplitudes"] = {MatrixXd::Ones(1, n_t), "-"};
  }
  content.texts["checksum"] = checksum_of(content);
  return content;
}

// Two short factors make a large matrix, which is refused before it is made.
TEST(TrajectoryLimits, FactorsOfMoreValuesAreRefused) {
  EXPECT_EQ(trajectory_of(of_factors(30, 50, 3)).bodies[2].displacement, MatrixXd::Ones(30, 50));
  for (const long n_bodies : {1, 3})
    EXPECT_THAT([=] { trajectory_of(of_factors(3 * 100000, 1000, n_bodies)); },
                ThrowsMessage<std::runtime_error>(HasSubstr("holds more than 512 MiB of values")));
}

TEST(TrajectoryLimits, TimesAscend) {
  for (const double second : {0.0, -1.0}) {
    Trajectory trajectory = touching_bodies(1, 3);
    trajectory.t[1] = second;
    EXPECT_THAT([&] { content_of(trajectory); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("its times do not ascend")));
    Hdf5Content content = content_of(touching_bodies(1, 3));
    content.matrices["t"].values(1, 0) = second;
    content.texts["checksum"] = checksum_of(content);
    EXPECT_THAT([&] { trajectory_of(content); }, ThrowsMessage<std::runtime_error>(HasSubstr("'t' does not ascend")));
  }
  for (const Index n_t : {0, 1}) EXPECT_EQ(trajectory_of(content_of(touching_bodies(1, n_t))).t.size(), n_t);
}

}  // namespace
}  // namespace mb
