#include "mechanics/history/history.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "mechanics/history/resample.h"
#include "mechanics/types.h"

namespace mb {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::vector<History> exact_histories() {
  return {Step{2, 0.3},
          Step{-1, 0},
          Pulse{0.25, 3, 0.1},
          Pulse{2, 1, -0.5},  // begun before 0, not over at 1
          Ramp{0.4, -2, 0.2},
          Ramp{4, 2, 0},
          Harmonic{12, 0.7, 1.5, 0.15},
          Harmonic{3, -2},
          Table{{0.1, 0.2, 0.25, 0.7}, {1, -1, 3, 2}},
          Table{{-1, 0.5, 3}, {0, 4, -4}}};
}

std::vector<History> resampled_histories() {
  return {Chirp{5, 60, 0.6, 2, 0.1},
          Chirp{40, 0, 3},
          Expression{"sin(2*pi*3*t)*exp(-t)"},
          Expression{"t<0.3 ? 1 : -t^2"},
          Expression{"exp(-((t-0.4)/0.003)^2)"},
          Expression{"0"},
          Expression{"sqrt(t)"}};
}

TEST(HistoryTest, ValuesByHand) {
  EXPECT_EQ(value(Step{2, 0.5}, std::nextafter(0.5, 0)), 0);
  EXPECT_EQ(value(Step{2, 0.5}, 0.5), 2);  // right-continuous
  EXPECT_DOUBLE_EQ(value(Pulse{0.4, 3, 1}, 1.2), 3);
  EXPECT_NEAR(value(Pulse{0.4, 3, 1}, 1.1), 1.5, 1e-14);  // 1.1 - 1 has lost 3 bits
  EXPECT_EQ(value(Pulse{0.4, 3, 1}, 1.4), 0);
  EXPECT_DOUBLE_EQ(value(Ramp{0.5, 4, 1}, 1.125), 1);
  EXPECT_EQ(value(Ramp{0.5, 4, 1}, 1.5), 4);
  EXPECT_DOUBLE_EQ(value(Harmonic{pi, pi / 2, 2, 1}, 2), -2);
  EXPECT_EQ(value(Harmonic{pi, pi / 2, 2, 1}, 0.999), 0);
  EXPECT_DOUBLE_EQ(value(Chirp{0, 2 * pi, 1, 3}, std::sqrt(0.5)), 3);  // phase pi t^2
  EXPECT_EQ(value(Chirp{1, 2, 1, 3, 0.1}, 1.1), 0);
  const Table table{{1, 2, 4}, {5, 7, 3}};
  EXPECT_EQ(value(table, 0.999), 0);
  EXPECT_EQ(value(table, 1), 5);
  EXPECT_EQ(value(table, 2), 7);
  EXPECT_DOUBLE_EQ(value(table, 3), 5);
  EXPECT_EQ(value(table, 4), 0);
  EXPECT_DOUBLE_EQ(value(Expression{"2*t^2 + pi"}, 3), 18 + pi);
}

TEST(HistoryTest, EvaluatorIsTheValue) {
  auto all = exact_histories();
  for (const auto& history : resampled_histories()) all.push_back(history);
  for (const auto& history : all) {
    const auto s = evaluator(history);
    const auto copy = s;
    for (int i = 0; i <= 40; ++i) {
      EXPECT_EQ(s(i / 40.0), value(history, i / 40.0));
      EXPECT_EQ(copy(i / 40.0), value(history, i / 40.0));
    }
  }
}

void expect_tiling(const std::vector<Segment>& pieces, double duration) {
  ASSERT_FALSE(pieces.empty());
  EXPECT_EQ(pieces.front().start, 0);
  EXPECT_EQ(pieces.back().end, duration);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    ASSERT_LT(pieces[i].start, pieces[i].end);
    ASSERT_EQ(pieces[i].start, i > 0 ? pieces[i - 1].end : 0);
  }
}

TEST(HistoryTest, SegmentsAreTheHistory) {
  for (const auto& history : exact_histories())
    for (const double duration : {0.05, 1.0, 7.0}) {
      const auto chain = segments(history, duration);
      expect_tiling(chain.pieces, duration);
      EXPECT_EQ(chain.load_error, 0);
      for (const auto& piece : chain.pieces)
        for (const double share : {0.0, 0.1, 0.5, 0.999}) {
          const double t = piece.start + share * (piece.end - piece.start);
          EXPECT_NEAR(value(piece, t), value(history, t), 2e-14 * 4)
              << history.index() << " " << t;  // |s| <= 4, phase <= 84
        }
    }
}

TEST(HistoryTest, JumpsLieAtBreakpointsOnly) {
  for (const auto& history : exact_histories()) {
    const auto stops = breakpoints(history, 1);
    const auto chain = segments(history, 1).pieces;
    EXPECT_EQ(stops.size() + 1, chain.size());
    for (std::size_t i = 0; i < stops.size() && i + 1 < chain.size(); ++i) EXPECT_EQ(stops[i], chain[i].end);
  }
  EXPECT_EQ(breakpoints(Pulse{0.25, 3, 0.1}, 1), (std::vector<double>{0.1, 0.35}));
  EXPECT_EQ(breakpoints(Pulse{0.25, 3, 0.1}, 0.2), (std::vector<double>{0.1}));
  EXPECT_TRUE(breakpoints(Step{}, 1).empty());
  EXPECT_TRUE(breakpoints(Expression{"t"}, 1).empty());
}

TEST(HistoryTest, EndsWhereItIsZeroFromThenOn) {
  constexpr double never = std::numeric_limits<double>::infinity();
  EXPECT_EQ(end(Pulse{0.25, 3, 0.1}, 1), 0.35);
  EXPECT_EQ(end(Pulse{0.25, 3, 0.1}, 0.3), never) << "not within the duration";
  EXPECT_EQ(end(Pulse{0.25, 3, 2}, 1), 0) << "begins after it";
  EXPECT_EQ(end(Chirp{10, 20, 0.5}, 1), 0.5);
  EXPECT_EQ(end(Table{{0, 0.2, 0.4}, {0, 1, 0.5}}, 1), 0.4);
  for (const History& on : {History(Step{}), History(Ramp{0.5}), History(Harmonic{10}), History(Expression{"1 - t"})})
    EXPECT_EQ(end(on, 1), never) << on.index();
}

TEST(HistoryTest, RebasedIsTheSameFunction) {
  const Segment segment{0.5, 9, 1, -2, 0.3, 0.7, 11};
  const Segment later = rebased(segment, 2.25, 3);
  for (double t : {2.25, 2.5, 2.99}) EXPECT_NEAR(value(later, t), value(segment, t), 1e-14 * 20);  // |s| <= 20
}

TEST(HistoryTest, ResamplingErrorIsHonest) {
  for (const auto& history : resampled_histories())
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
      const auto chain = segments(history, 1, tolerance);
      expect_tiling(chain.pieces, 1);
      EXPECT_LE(chain.load_error, tolerance);
      const auto s = evaluator(history);
      const double least = std::holds_alternative<Chirp>(history) ? peak(history, 1) : mean_size(s, chain.pieces);
      double error = 0;  // at points which the resampling has not seen
      for (const auto& piece : chain.pieces) {
        if (piece.end - piece.start < 1e-14) continue;  // encloses a jump
        for (int i = 0; i < 50; ++i) {
          const double t = piece.start + (i + 0.31) / 50 * (piece.end - piece.start);
          const double scale =
              std::max(least, std::min(std::abs(value(piece, piece.start)), std::abs(value(piece, piece.end))));
          error = std::max(error, (std::abs(value(piece, t) - s(t)) - 1e-15) / std::max(scale, 1e-300));
        }
      }
      EXPECT_LE(error, 1.05 * chain.load_error) << history.index() << " " << tolerance;
      EXPECT_TRUE(chain.load_error > 0.01 * tolerance || !std::holds_alternative<Chirp>(history));
    }
}

TEST(HistoryTest, LinesCostTheirCurvature) {  // h^2 s''/8 <= tolerance: a hundredth of it takes ten times the pieces
  const Expression wave{"sin(2*pi*t)"};
  const auto coarse = segments(wave, 1, 1e-3).pieces.size(), fine = segments(wave, 1, 1e-5).pieces.size();
  EXPECT_GT(fine, 5 * coarse);
  EXPECT_LT(fine, 20 * coarse);
  EXPECT_EQ(segments(Expression{"3*t - 1"}, 1).pieces.size(), 1u);
}

TEST(HistoryTest, PeakIsTheSupremum) {
  auto all = exact_histories();
  for (const auto& history : resampled_histories()) all.push_back(history);
  for (const auto& history : all)
    for (const double duration : {0.05, 0.22, 1.0, 7.0}) {
      double sampled = 0;
      const auto s = evaluator(history);
      for (int i = 0; i < 20000; ++i) sampled = std::max(sampled, std::abs(s(i * duration / 20000)));
      const double found = peak(history, duration);
      EXPECT_GE(found, sampled * (1 - 1e-12)) << history.index() << " " << duration;
      // no sample is further than duration/20000 from the supremum, and |s'| <= 150
      EXPECT_LE(found, sampled + 150 * duration / 20000) << history.index() << " " << duration;
    }
  EXPECT_EQ(peak(Step{2, 3}, 1), 0);
  EXPECT_EQ(peak(Pulse{1, -2, 0}, 0.5), 2);
  EXPECT_EQ(peak(Pulse{1, 1, 5}, 1), 0);
}

TEST(HistoryTest, Equality) {
  for (const auto& a : exact_histories()) EXPECT_EQ(a, History(a));
  EXPECT_FALSE(History(Step{1, 0}) == History(Step{1, 1}));
  EXPECT_FALSE(History(Pulse{1}) == History(Ramp{1}));
  EXPECT_FALSE(History(Expression{"t"}) == History(Expression{"2*t"}));
}

TEST(HistoryTest, BadInput) {
  const std::vector<History> wrong = {Step{nan},
                                      Pulse{0},
                                      Pulse{-1},
                                      Ramp{nan},
                                      Harmonic{0},
                                      Harmonic{1, nan},
                                      Chirp{-1, 1, 1},
                                      Chirp{1, 1, 0},
                                      Table{{0}, {1}},
                                      Table{{0, 1}, {1}},
                                      Table{{1, 0}, {1, 1}},
                                      Table{{0, 0}, {1, 2}},
                                      Table{{0, nan}, {1, 1}}};
  for (const auto& history : wrong) {
    EXPECT_THROW(segments(history, 1), std::invalid_argument) << history.index();
    EXPECT_THROW(breakpoints(history, 1), std::invalid_argument) << history.index();
    EXPECT_THROW(peak(history, 1), std::invalid_argument) << history.index();
  }
  for (const double duration : {0.0, -1.0, nan}) EXPECT_THROW(segments(Step{}, duration), std::invalid_argument);
  for (const double tolerance : {0.0, -1.0, nan}) EXPECT_THROW(segments(Step{}, 1, tolerance), std::invalid_argument);
  EXPECT_THROW(segments(Chirp{1e7, 1e7, 1}, 1), std::domain_error);  // more pieces than allowed
  EXPECT_THROW(segments(Expression{"1/(t-0.3)"}, 1), std::domain_error);
  EXPECT_THROW(segments(Expression{"ln(t)"}, 1), std::domain_error);
  EXPECT_THROW(value(Expression{"sqrt(-t)"}, 1), std::domain_error);
}

TEST(Jumps, AreThoseOfTheValueAndNotOfItsRate) {
  EXPECT_TRUE(jumps(Step{}, 1));
  EXPECT_TRUE(jumps(Step{.amplitude = -2, .start = 0.5}, 1));
  EXPECT_FALSE(jumps(Step{.amplitude = 1, .start = 2}, 1));  // not yet
  EXPECT_FALSE(jumps(Pulse{0.5}, 1));
  EXPECT_FALSE(jumps(Ramp{0.5}, 1));
  EXPECT_FALSE(jumps(Harmonic{20}, 1));
  EXPECT_TRUE(jumps(Harmonic{.omega = 20, .phase = 1}, 1));
  EXPECT_FALSE(jumps(Table{{0, 0.5, 1}, {0, 1, 0}}, 1));
  EXPECT_TRUE(jumps(Table{{0, 0.5, 0.7}, {0, 1, 1}}, 1));  // zero after the last
  EXPECT_FALSE(jumps(Expression{"sin(20*t)"}, 1));
  EXPECT_TRUE(jumps(Expression{"cos(20*t)"}, 1));
}

}  // namespace
}  // namespace mb
