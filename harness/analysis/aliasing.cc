#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "harness/analysis/analyses.h"
#include "harness/analysis/recorded_motions.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::array frame_rates{24.0, 30.0, 60.0, 120.0};  // [Hz]
constexpr int most_sub_samples = 64;
constexpr double negligible = 1e-12;  // [-] of kinetic energy

Finding marks_table(const std::string& samples) {
  return table(
      "aliasing", "aliasing", "Temporal aliasing in frames",
      "Motion x at the volume points in the M norm, rigid motion projected out, taken apart at half the frame "
      "rate F by a filter of zero phase: raised cosine from 0.8 to 1.2 of F/2, on a record padded to four "
      "times its length (at rest before its start, point reflection fading out after its end). Seen through a "
      "shutter of 1/F: a point, a box of N sub-samples, or the exact mean. With |.| over frames and points, x "
      "the truth on the same mesh and y the contender: aliasing |B y_high|, droop |B y_low - y_low|, low-band "
      "error |y_low - x_low|, frame error |B y - x_low|, all over |x_low|. Exact means of modes are closed "
      "forms. Bars: twice the distance to the same on the finer mesh of the case. Frames whose shutter leaves the "
      "record are left out. " +
          samples,
      {{"frame rate", "Hz"},
       {"frames", ""},
       {"contender", ""},
       {"modes r", ""},
       {"shutter", ""},
       {"sub-samples", ""},
       {"aliasing", "-"},
       {"droop", "-"},
       {"low-band error", "-"},
       {"frame error", "-"}});
}

Finding claim_table() {
  return table(
      "aliasing", "aliasing-claim", "Claim C2: does dropping high modes remove temporal aliasing?",
      "Full order against the modal answer without the modes above F/2, both seen at points in time. Energy: share of "
      "the truth's kinetic energy in x_high. Sub-samples needed: the smallest box with which full order aliases as "
      "little as the cut modal answer; none where even the exact mean, infinitely many, aliases more; \"> N\" where "
      "the "
      "samples allow no more than N and it stays open. It holds where aliasing falls to a "
      "tenth, or below 1 % and by half, and frames are closer to the truth's slow motion than full order's; within "
      "limits where only the first is so. It is not decided where full order shows less than 1 %, nor where a mode "
      "kept "
      "lies above 0.8 F/2: the filter counts part of it as fast.",
      {{"claim", ""},
       {"frame rate", "Hz"},
       {"energy above F/2", "-"},
       {"aliasing full order", "-"},
       {"aliasing cut modal", "-"},
       {"low-band error cut modal", "-"},
       {"frame error full order", "-"},
       {"frame error cut modal", "-"},
       {"sub-samples needed", ""},
       {"verdict", ""}});
}

Finding modes_table() {
  return table("aliasing", "aliasing-modes", "Modes that frames show at a wrong frequency",
               "The five modes above F/2 with most kinetic energy there, as a share of the modal answer's, and the "
               "frequency |f - F round(f/F)| at which frames show them.",
               {{"frame rate", "Hz"},
                {"mode", ""},
                {"frequency", "Hz"},
                {"apparent frequency", "Hz"},
                {"energy above F/2", "-"}});
}

// One frame rate.
class FrameRate {
 public:
  FrameRate(const RecordedMotions& motions, double F)
      : m_(motions),
        F_(F),
        t_(whole_frames(F, motions.t(motions.t.size() - 1))),
        n_cut_((motions.body.modes.omega.array() < pi * F).count()),
        x_low_(truth({1 / F, 1}).low) {}

  // Full order at a point, boxes and the exact mean; samples allow boxes of no more than their number a frame.
  void mark_truth(double rate, Finding& marks) {
    for (int n = 1; n <= most_sub_samples && n <= rate / F_ * (1 + 1e-9); n *= 2) {
      const Shutter box{1 / F_, n};
      boxes_.emplace_back(n, add(marks, "full order", nan, box, truth(box)));
    }
    mean_ = add(marks, "full order", nan, {1 / F_, 0}, truth({1 / F_, 0}));
  }

  void mark_modes(const std::vector<int>& counts, Finding& marks) {
    for (const int n : {1, 0}) {
      const Shutter shutter{1 / F_, n};
      const FrameView signals = modal(shutter);
      Index last = -1;
      for (const int r : counts) {
        const Index used = leading(m_.body.modes, r).size();
        if (used != last) add(marks, "modal", elastic(used), shutter, values_of(m_.modal.shapes, signals, used));
        last = used;
      }
      const auto cut = values_of(m_.modal.shapes, signals, n_cut_);
      const FrameMarks marked = add(marks, "modal, cut at F/2", elastic(n_cut_), shutter, cut);
      if (n == 1) cut_ = marked;
    }
  }

  // With the static response of what is cut: it follows the load, fast parts included.
  void mark_corrected(const AnalysisContext& context, Finding& marks) const {
    const CorrectedMotion motion(context, m_, n_cut_);
    const Recording& y = motion.samples();
    for (const int n : {1, 0}) {
      const Shutter shutter{1 / F_, n};
      FrameView view = values_of(y.shapes, frame_view(y.signals, t_, F_, shutter), y.shapes.cols());
      view.high_shown = motion.shown(t_, n == 1 ? 0 : shutter.width) - view.low_shown;
      add(marks, "static-correction, cut at F/2", elastic(n_cut_), shutter, view);
    }
  }

  std::vector<FindingCell> claim_row() const {
    const BandEnergy energy = band_energy(m_.truth.signals, F_ / 2);
    const FrameMarks& full = boxes_.front().second;
    std::vector<std::pair<int, double>> boxes;
    for (const auto& [n, marks] : boxes_) boxes.emplace_back(n, marks.aliasing);
    return {"C2",
            F_,
            energy.high.sum() / energy.whole.sum(),
            full.aliasing,
            cut_.aliasing,
            cut_.low_band_error,
            full.frame_error,
            cut_.frame_error,
            sub_samples_needed(boxes, mean_.aliasing, cut_.aliasing),
            aliasing_verdict(full, cut_, lies_in_transition())};
  }

  void add_modes(Finding& table) const {
    const Index n_rigid = m_.body.modes.n_rigid, n = m_.body.modes.size() - n_rigid;
    const BandEnergy energy = band_energy(m_.modal.signals, F_ / 2);
    VectorXd high = energy.high.tail(n);
    high.head(n_cut_ - n_rigid).setZero();
    const double whole = energy.whole.tail(n).sum();
    for (int k = 0; k < 5; ++k) {
      Index i = 0;
      if (n == 0 || !(high.maxCoeff(&i) > negligible * whole)) return;
      const double damped = std::sqrt(std::max(0.0, 1 - m_.zeta(i) * m_.zeta(i)));
      const double f = m_.body.modes.omega(n_rigid + i) * damped / (2 * pi);
      table.rows.push_back({F_, count(i + 1), f, apparent_frequency(f, F_), high(i) / whole});
      high(i) = 0;
    }
  }

 private:
  FrameMarks add(Finding& table, const char* contender, double r, const Shutter& shutter, const FrameView& y) const {
    const FrameMarks m = frame_marks(y, x_low_);
    table.rows.push_back({F_, count(t_.size()), contender, r, to_string(shutter),
                          static_cast<double>(shutter.n_samples), m.aliasing, m.droop, m.low_band_error,
                          m.frame_error});
    return m;
  }
  // Whether the filter passes a mode that is kept in part only, and the mode moves.
  bool lies_in_transition() const {
    const Index n_rigid = m_.body.modes.n_rigid;
    const VectorXd energy = band_energy(m_.modal.signals, F_ / 2).whole;
    const double whole = energy.tail(energy.size() - n_rigid).sum();
    for (Index i = n_rigid; i < n_cut_; ++i)
      if (low_pass(m_.body.modes.omega(i) / (2 * pi), F_ / 2) < 1 && energy(i) > 0.01 * whole) return true;
    return false;
  }
  double elastic(Index n) const { return static_cast<double>(n - m_.body.modes.n_rigid); }
  FrameView truth(const Shutter& shutter) const {
    return values_of(m_.truth.shapes, frame_view(m_.truth.signals, t_, F_, shutter), m_.truth.shapes.cols());
  }
  FrameView modal(const Shutter& shutter) const {  // closed forms: a point and the exact mean
    const bool point = shutter.n_samples == 1;
    const States shown = point ? m_.stepper->run(t_) : m_.stepper->averages(t_, shutter.width);
    return frame_view(m_.modal.signals, t_, F_, shutter, shown.u);
  }

  const RecordedMotions& m_;
  double F_;
  VectorXd t_;
  Index n_cut_;  // modes below F/2, rigid ones included
  MatrixXd x_low_;
  std::vector<std::pair<int, FrameMarks>> boxes_;  // of full order
  FrameMarks mean_{};                              // of full order through the exact mean, which boxes tend to
  FrameMarks cut_{};
};

}  // namespace

std::vector<Finding> temporal_aliasing(const AnalysisContext& context) {
  const Scene& scene = *context.scene;
  const std::vector<int> counts = mode_counts(context);
  const RecordedMotions motions = recorded_motions(context, counts.back(), frame_rates.back() / 2);
  const double rate = scene.samples_per_second, end = motions.t(motions.t.size() - 1);
  Finding marks = marks_table(fmt::format(
      "The record has {:g} samples a second: boxes of at most {:g}/F are possible, and what is faster than {:g} Hz is "
      "folded into it.",
      rate, rate, rate / 2));
  Finding claim = claim_table(), modes = modes_table();
  for (const double F : frame_rates) {
    if (whole_frames(F, end).size() < 3 || rate < 2 * F) {
      marks.note += fmt::format(" {:g} Hz is left out: the record is too short or too coarse for it.", F);
      continue;
    }
    FrameRate at(motions, F);
    at.mark_truth(rate, marks);
    at.mark_modes(counts, marks);
    at.mark_corrected(context, marks);
    claim.rows.push_back(at.claim_row());
    at.add_modes(modes);
  }
  return {marks, claim, modes};
}

}  // namespace mb
