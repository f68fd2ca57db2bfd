#include "harness/store/contact_content.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace mb {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;
using Matrices = std::map<std::string, Hdf5Matrix>;

constexpr Index n_t = 7;
constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

BodyTrajectory example() {
  BodyTrajectory body;
  body.contact = {Matrix3Xd::Random(3, n_t),
                  Matrix3Xd::Random(3, n_t),
                  VectorXd::Random(n_t),
                  VectorXd::Random(n_t),
                  {{0.1, 0.2, 30, 0.15, {1, 2, 3}}, {0.4, infinity, 50, 0.45, {-1, 0, 7}}}};
  body.energy = VectorXd::Random(n_t);
  body.momentum = MatrixXd::Random(6, n_t);
  return body;
}
BodyTrajectory read(const Matrices& content, const std::string& key = "body0") {
  BodyTrajectory body;
  read_contact(content, key, n_t, body);
  return body;
}
void expect_same(const BodyTrajectory& a, const BodyTrajectory& b) {
  EXPECT_EQ(a.contact.force, b.contact.force);
  EXPECT_EQ(a.contact.impulse, b.contact.impulse);
  EXPECT_EQ(a.contact.stored, b.contact.stored);
  EXPECT_EQ(a.contact.dissipated, b.contact.dissipated);
  EXPECT_EQ(a.energy, b.energy);
  EXPECT_EQ(a.momentum, b.momentum);
  ASSERT_EQ(a.contact.touches.size(), b.contact.touches.size());
  for (size_t i = 0; i < a.contact.touches.size(); ++i) {
    const Touch &x = a.contact.touches[i], &y = b.contact.touches[i];
    EXPECT_EQ(x.start, y.start);
    EXPECT_EQ(x.end, y.end);
    EXPECT_EQ(x.peak_force, y.peak_force);
    EXPECT_EQ(x.peak_time, y.peak_time);
    EXPECT_EQ(x.impulse, y.impulse);
  }
}

TEST(ContactContent, ComesBackAsItWas) {
  const BodyTrajectory before = example();
  const Matrices content = contact_content("body3", before, n_t);
  expect_same(read(content, "body3"), before);
  EXPECT_TRUE(read(content).contact.touches.empty());  // of another body nothing
  EXPECT_EQ(content.at("body3_contact_force").unit, "N");
  EXPECT_EQ(content.at("body3_contact_impulse").unit, "N s");
  EXPECT_EQ(content.at("body3_contact_energy").unit, "J");
  EXPECT_EQ(content.at("body3_touch_times").unit, "s");
  // Through the file format, too: infinity, a touch that lasts, is a number there.
  Hdf5Content file;
  file.matrices = content;
  expect_same(read(from_hdf5(to_hdf5(file)).matrices, "body3"), before);
}

TEST(ContactContent, WhatIsNotThereIsNotWritten) {
  BodyTrajectory body = example();
  body.contact.touches.clear();
  body.energy.resize(0);
  body.momentum.resize(0, 0);
  const Matrices content = contact_content("body0", body, n_t);
  EXPECT_EQ(content.size(), 3u);
  expect_same(read(content), body);
  EXPECT_TRUE(contact_content("body0", {}, n_t).empty());
  expect_same(read({}), {});
}

TEST(ContactContent, SizesMustAgreeWithTheTimes) {
  for (const auto& change : std::vector<std::function<void(BodyTrajectory&)>>{
           [](BodyTrajectory& b) { b.contact.force.resize(3, n_t - 1); },
           [](BodyTrajectory& b) { b.momentum.resize(6, n_t - 1); },
           [](BodyTrajectory& b) { b.momentum.resize(3, n_t); },
           [](BodyTrajectory& b) { b.contact.impulse.resize(3, n_t + 1); },
           [](BodyTrajectory& b) { b.contact.stored.resize(0); },
           [](BodyTrajectory& b) { b.contact.dissipated.resize(n_t - 1); },
           [](BodyTrajectory& b) { b.energy.resize(n_t - 1); },
           [](BodyTrajectory& b) { b.contact.force.resize(3, 0); }}) {
    BodyTrajectory body = example();
    change(body);
    EXPECT_THROW(contact_content("body0", body, n_t), std::invalid_argument);
  }
  EXPECT_THROW(contact_content("body0", example(), n_t + 1), std::invalid_argument);
}

// Every matrix that belongs to a contact, missing, cut short or turned round.
TEST(ContactContent, DamagedContentIsRefused) {
  const Matrices whole = contact_content("body0", example(), n_t);
  for (const auto& [key, matrix] : whole) {
    const bool first = key == "body0_contact_force",
               choice = key == "body0_energy" || key == "body0_momentum" || key == "body0_touch_times";
    Matrices damaged = whole;
    if (!first && !choice) {  // those say that there is a contact, energies or touches
      damaged.erase(key);
      EXPECT_THAT([&] { read(damaged); }, ThrowsMessage<std::runtime_error>(HasSubstr(key))) << key;
    }
    damaged = whole;
    damaged[key].values.conservativeResize(Eigen::NoChange, matrix.values.cols() - 1);
    EXPECT_THROW(read(damaged), std::runtime_error) << key;
    damaged = whole;
    damaged[key].values.conservativeResize(matrix.values.rows() + 1, Eigen::NoChange);
    EXPECT_THROW(read(damaged), std::runtime_error) << key;
    damaged[key].values.resize(0, 0);
    EXPECT_THROW(read(damaged), std::runtime_error) << key;
  }
  EXPECT_THROW(
      {
        BodyTrajectory body;
        read_contact(whole, "body0", n_t + 1, body);
      },
      std::runtime_error);
}

// Files are untrusted: touches are times in order, forces are numbers.
TEST(ContactContent, TouchesMustBeInOrder) {
  const auto altered = [](const std::string& key, Index row, Index column, double to) {
    Matrices content = contact_content("body0", example(), n_t);
    content["body0_" + key].values(row, column) = to;
    return content;
  };
  EXPECT_NO_THROW(read(altered("touch_times", 0, 0, 0.12)));
  EXPECT_NO_THROW(read(altered("touch_times", 1, 1, 0.5)));
  EXPECT_THROW(read(altered("touch_times", 0, 1, 0.05)), std::runtime_error);      // begins before the one before it
  EXPECT_THROW(read(altered("touch_times", 1, 0, 0.05)), std::runtime_error);      // ends before it begins
  EXPECT_THROW(read(altered("touch_times", 1, 0, infinity)), std::runtime_error);  // only the last one may last
  for (const double wrong : {nan, -infinity})
    for (const Index row : {0, 1, 2}) EXPECT_THROW(read(altered("touch_times", row, 1, wrong)), std::runtime_error);
  for (const double wrong : {nan, infinity})
    for (const char* key :
         {"touch_impulses", "touch_peaks", "contact_force", "contact_impulse", "contact_energy", "energy", "momentum"})
      EXPECT_THAT([&] { read(altered(key, 0, 1, wrong)); }, ThrowsMessage<std::runtime_error>(HasSubstr(key))) << key;
}

TEST(ContactContent, WhatIsNotFiniteIsNotWritten) {
  for (const double wrong : {nan, infinity})
    for (const auto& change : std::vector<std::function<void(BodyTrajectory&)>>{
             [=](BodyTrajectory& b) { b.contact.force(2, 3) = wrong; },
             [=](BodyTrajectory& b) { b.contact.impulse(0, 0) = wrong; },
             [=](BodyTrajectory& b) { b.contact.stored[1] = wrong; },
             [=](BodyTrajectory& b) { b.contact.dissipated[6] = wrong; },
             [=](BodyTrajectory& b) { b.energy[2] = wrong; }, [=](BodyTrajectory& b) { b.momentum(5, 2) = wrong; },
             [=](BodyTrajectory& b) { b.contact.touches[0].end = wrong; },  // only the last one may last
             [=](BodyTrajectory& b) { b.contact.touches[1].start = wrong; },
             [=](BodyTrajectory& b) { b.contact.touches[0].peak_force = wrong; },
             [=](BodyTrajectory& b) { b.contact.touches[0].impulse.x() = wrong; }}) {
      BodyTrajectory body = example();
      change(body);
      EXPECT_THROW(contact_content("body0", body, n_t), std::invalid_argument);
    }
}

}  // namespace
}  // namespace mb
