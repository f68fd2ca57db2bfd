// Cells of the maps of steps in contact (contact_stability_map.cc): the scene's first impact with another layer, in
// modes with or without static shapes, by one scheme at one step, held against kicks at a quarter of the least step.
#pragma once

#include <limits>

#include "harness/analysis/encounter.h"
#include "harness/analysis/first_impact.h"
#include "harness/analysis/stability_grid.h"

namespace mb {

// The scene thrown into a layer `factor` times as stiff, in a basis.
struct VariedLayer {
  Encounter encounter;
  double factor;
  ImpactOnLayer impact;
  PressedModes pressed;
  Scene scene;
  std::shared_ptr<const FloatingBases> bases, nudged;  // nudged: moving otherwise by 1e-12 of the speed
  FirstImpact reference;
  // [-] How far that may be off in peak and impulse: by halving the least step once more, of order one or more.
  double bar_of_peak = 0, bar_of_impulse = 0;

  double opening_limit() const;  // [s] where opening gains a tenth
};

constexpr int contact_steps_tried = 12;                   // from two durations of the contact down, by halves
double contact_step(const ImpactOnLayer& impact, int i);  // [s] 0 <= i < contact_steps_tried

// For each factor. method: "eigenmodes" or "static-correction", of the r lowest modes.
std::vector<VariedLayer> varied_layers(const AnalysisContext& context, const ContactVariants& variants,
                                       const std::string& method, int r, const std::vector<double>& factors);

// [-]; energy 1 and what is gained over the kinetic energy of the approach, infinite where the run failed.
struct ContactCell {
  double dt, radius;
  double energy = std::numeric_limits<double>::infinity();
  double of_peak = std::numeric_limits<double>::quiet_NaN(), of_impulse = of_peak;
  // [-] How far the reference may be off, and twice what a nudge of 1e-12 of the speed moves: where many samples touch
  // in turn rounding decides which.
  double bar_of_energy = 0, bar_of_peak = 0, bar_of_impulse = 0;
  StepClass found = StepClass::unstable;
  std::string verdict = {};

  double error() const;  // the larger of both; infinity: there is none
  double bar() const;    // likewise
};
ContactCell contact_cell(const VariedLayer& layer, const Integrator& scheme, double dt);

}  // namespace mb
