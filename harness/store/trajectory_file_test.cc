#include "harness/store/trajectory_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "harness/store/hdf5.h"
#include "harness/store/scratch_folder_test.h"

namespace mb {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr Index n_t = 25;

Trajectory example() {
  const VectorXd t = VectorXd::LinSpaced(n_t, 0, 0.3);
  const VectorXd shape = VectorXd::LinSpaced(60, -1e-3, 2e-3);
  const MatrixXd smooth = shape * (9 * t.array()).sin().matrix().transpose();
  return {.t = t,
          .bodies = {{.displacement = smooth, .strain = 10 * smooth},
                     {.displacement = MatrixXd::Random(9, n_t), .strain = MatrixXd(0, n_t)}},
          .work = {.steps = 1, .rejected = 2, .factorisations = 3, .solves = 4, .load_evaluations = 5},
          .status = Status::too_many_steps};
}

// The file with its content altered, checksum and all kept as they were.
template <typename Alter>
void alter(const std::filesystem::path& file, Alter&& alteration) {
  Hdf5Content content = from_hdf5(read_file(file, 1 << 20));
  alteration(content);
  write_file(file, to_hdf5(content));
}

TEST(TrajectoryFile, ComesBackWithinTheStatedTolerance) {
  const ScratchFolder folder;
  Trajectory before = example();
  before.case_name = "beam";
  write_trajectory(folder / "a.h5", before);
  const Trajectory after = read_trajectory(folder / "a.h5");
  EXPECT_EQ(after.t, before.t);
  EXPECT_EQ(after.case_name, "beam");
  EXPECT_EQ(after.status, Status::too_many_steps);
  EXPECT_EQ(after.work.steps, 1);
  EXPECT_EQ(after.work.load_evaluations, 5);
  ASSERT_EQ(after.bodies.size(), 2u);
  const MatrixXd error = after.bodies[0].displacement - before.bodies[0].displacement;
  EXPECT_LT(error.norm(), 2 * trajectory_tolerance * before.bodies[0].displacement.norm());
  EXPECT_LT((after.bodies[0].strain - before.bodies[0].strain).norm(),
            2 * trajectory_tolerance * before.bodies[0].strain.norm());
  EXPECT_EQ(after.bodies[1].displacement, before.bodies[1].displacement);  // plain: random values have no low rank
  EXPECT_EQ(after.bodies[1].strain.cols(), 0);
}

TEST(TrajectoryFile, SmoothMotionIsStoredAsFactors) {
  const ScratchFolder folder;
  write_trajectory(folder / "a.h5", example());
  const Hdf5Content content = from_hdf5(read_file(folder / "a.h5", 1 << 20));
  EXPECT_EQ(content.matrices.at("body0_displacement_shapes").values.cols(), 1);
  EXPECT_EQ(content.matrices.at("body0_displacement_shapes").unit, "m");
  EXPECT_EQ(content.matrices.at("body0_displacement_amplitudes").values.cols(), n_t);
  EXPECT_TRUE(content.matrices.contains("body1_displacement"));
  EXPECT_FALSE(content.matrices.contains("body1_strain"));
}

TEST(TrajectoryFile, WhatIsNotFiniteIsNotWritten) {
  const ScratchFolder folder;
  for (const double wrong : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    Trajectory blown = example();
    blown.status = Status::not_finite;
    blown.bodies[0].displacement(3, 4) = wrong;
    EXPECT_THAT([&] { write_trajectory(folder / "a.h5", blown); },
                ThrowsMessage<std::invalid_argument>(AllOf(HasSubstr("displacement of body 0"), HasSubstr("0.05"))));
    blown = example();
    blown.bodies[0].strain(0, 0) = wrong;
    EXPECT_THAT([&] { write_trajectory(folder / "a.h5", blown); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("strain of body 0 is not finite at t = 0.0")));
    blown = example();
    blown.t[3] = wrong;
    EXPECT_THROW(write_trajectory(folder / "a.h5", blown), std::invalid_argument);
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "a.h5"));
}

// Files come from anywhere: one that holds such a value, checksum and all, is refused.
TEST(TrajectoryFile, WhatIsNotFiniteIsNotRead) {
  const ScratchFolder folder;
  for (const char* key : {"t", "body1_displacement", "body0_strain_shapes"}) {
    write_trajectory(folder / "a.h5", example());
    alter(folder / "a.h5", [&](Hdf5Content& c) {
      c.matrices.at(key).values(0, 0) = std::numeric_limits<double>::quiet_NaN();
      c.texts["checksum"] = checksum_of(c);
    });
    EXPECT_THAT([&] { read_trajectory(folder / "a.h5"); }, ThrowsMessage<StoreError>(HasSubstr("is not finite")))
        << key;
  }
}

TEST(TrajectoryFile, EveryTruncationIsNamed) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder / "a.h5";
  write_trajectory(file, example());
  const std::string sound = read_file(file, 1 << 20);
  for (std::size_t size = 0; size < sound.size(); size += 331) {
    write_file(file, sound.substr(0, size));
    EXPECT_THAT([&] { read_trajectory(file); }, ThrowsMessage<StoreError>(HasSubstr(file.string()))) << size;
  }
}

TEST(TrajectoryFile, EveryAlteredByteIsRefusedOrChangesNothing) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder / "a.h5";
  write_trajectory(file, example());
  const std::string sound = read_file(file, 1 << 20);
  const Trajectory whole = read_trajectory(file);
  int n_refused = 0, n_equal = 0;
  for (std::size_t i = 0; i < sound.size(); i += 29) {
    std::string bytes = sound;
    bytes[i] = static_cast<char>(bytes[i] ^ 0x41);
    // Not through write_file, whose fsync would dominate the test.
    std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
    try {
      const Trajectory read = read_trajectory(file);
      ASSERT_EQ(read.t, whole.t) << i;
      ASSERT_EQ(read.bodies[0].displacement, whole.bodies[0].displacement) << i;
      ASSERT_EQ(read.bodies[0].strain, whole.bodies[0].strain) << i;
      ASSERT_EQ(read.bodies[1].displacement, whole.bodies[1].displacement) << i;
      ++n_equal;  // unused bytes
    } catch (const StoreError&) {
      ++n_refused;
    }
  }
  EXPECT_GT(n_refused, n_equal);
}

TEST(TrajectoryFile, FaultsAreTold) {
  const ScratchFolder folder;
  const std::filesystem::path file = folder / "a.h5";
  const auto expect_fault = [&](auto&& alteration, const std::string& fault) {
    write_trajectory(file, example());
    alter(file, alteration);
    EXPECT_THAT([&] { read_trajectory(file); },
                ThrowsMessage<StoreError>(AllOf(HasSubstr(file.string()), HasSubstr(fault))));
  };
  expect_fault([](Hdf5Content& c) { c.matrices["t"].values(3, 0) += 1e-17; }, "checksum does not match");
  expect_fault([](Hdf5Content& c) { c.matrices["t"].unit = "h"; }, "checksum does not match");
  expect_fault([](Hdf5Content& c) { c.texts["status"] = "ok"; }, "checksum does not match");
  expect_fault([](Hdf5Content& c) { c.counts["steps"] = 7; }, "checksum does not match");
  expect_fault([](Hdf5Content& c) { c.matrices.erase("body1_displacement"); }, "checksum does not match");
  expect_fault([](Hdf5Content& c) { c.counts["schema"] = 2; }, "another schema");
  expect_fault([](Hdf5Content& c) { c.counts.erase("schema"); }, "'schema' is missing");
  expect_fault([](Hdf5Content& c) { c.texts["format"] = "recipe"; }, "is not a trajectory");
  // A forger knows the checksum: it says that the file is whole, not that it is honest.
  for (const std::string& name : {std::string("\x1b]0;t\x07"), std::string("../a"), std::string(65, 'a')})
    expect_fault(
        [&](Hdf5Content& c) {
          c.texts["case"] = name;
          c.texts["checksum"] = checksum_of(c);
        },
        "'case' is not a name");
  EXPECT_THROW(read_trajectory(folder / "missing.h5"), StoreError);
  EXPECT_THROW(read_trajectory("/dev/zero"), StoreError);
}

TEST(TrajectoryFile, SizesThatDisagreeAreNotWritten) {
  const ScratchFolder folder;
  for (const Index rows : {9, 10}) {
    Trajectory trajectory = example();
    trajectory.bodies[1].displacement = MatrixXd::Zero(rows, rows == 9 ? n_t + 1 : n_t);
    EXPECT_THROW(write_trajectory(folder / "a.h5", trajectory), std::invalid_argument);
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "a.h5"));
}

}  // namespace
}  // namespace mb
