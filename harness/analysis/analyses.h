// The analyses themselves, as analysis_catalogue() lists them. All look at the scene's first body, on the mesh of its
// modal contenders, with contact `budget` at every body; collision-cost and contact-forces at its shape alone, held
// rigid. Names of their tables and of the columns, which reports look up:
//
//   step-limits               system | modes r | scheme | integrator | omega max | zeta | formula | dt formula |
//                             dt measured | measured / formula | omega deciding
//   step-limit-runs           system | modes r | scheme | integrator | dt / limit | dt | steps | growth by theory |
//                             growth observed | difference of logarithms | verdict
//   step-limit-summary        system and scheme | runs | confirmed | not confirmed | too short to tell
//   step-limit-exponents      claim | scheme | limits fitted | exponent | standard error | claimed | verdict
//   stability-map             integrator | modes r | system | dt | dt / limit | spectral radius | energy | error |
//                             found | limit | verdict
//   stability-summary         integrator | cells | stable | inaccurate | unstable | not as predicted |
//                             too slow to be seen | at the limit | share as predicted | order | standard error |
//                             largest energy | energy over its bound
//   aliasing                  frame rate | frames | contender | modes r | shutter | sub-samples | aliasing | droop |
//                             low-band error | frame error
//   aliasing-claim            claim | frame rate | energy above F/2 | aliasing full order | aliasing cut modal |
//                             low-band error cut modal | frame error full order | frame error cut modal |
//                             sub-samples needed | verdict
//   aliasing-modes            frame rate | mode | frequency | apparent frequency | energy above F/2
//   budget                    body | method | modes r | integrator | setting | part | M norm | K norm
//   budget-cross-terms        body | method | modes r | integrator | setting | parts | M norm | K norm
//   frequency-response        load | contender | modes r | frequency | amplitude | phase
//   frequency-response-error  load | contender | modes r | error | largest deviation | at
//   frequency-response-peaks  contender | load | modes r | frequency | amplitude
//   damping                   mode | frequency | zeta asked | zeta full | zeta reduced | zeta by decay | coupling
//   damping-of-steps          mode | frequency | zeta asked | integrator | dt | omega dt | zeta of scheme |
//                             zeta of run | difference
//   damping-coupling          modes r | coupling | error of dropping | closed form against steps | condition
//   damping-coupling-modes    complex mode | frequency | ratio | undamped mode | share of its energy |
//                             undamped frequency | ratio by the diagonal
//   long-run                  integrator | modes r | dt | steps | status | swing | drift | exponent | standard error
//   multiplets                first mode | multiplicity | frequency | gap | difference of frequency |
//                             subspace distance | distance times gap
//   multiplets-kept           modes asked for | modes kept | gap at the cut
//   aspect                    aspect | unknowns | first frequency | largest residual | modes against steps |
//                             | energy, newmark | energy below the limit | energy past the limit
//   locking                   element | nu | cells | unknowns | static error | frequency error
//   locking-dynamics          nu | unknowns | first frequency | modes against steps | energy, newmark |
//                             energy below the limit | energy past the limit
//   locking-growth            element | static error at 0.3 | static error at 0.4999 | growth of static error |
//                             frequency error at 0.3 | frequency error at 0.4999 | growth of frequency error
//   linearity                 modes r | largest strain | largest rotation | second order | third order | estimate |
//                             error | estimate over error | verdict
//   frequencies               mode | reference | frequency | error | error Q2 4x4x4 | ... | order | GCI
//   probe-extremes            probe | truth | largest | at (largest) | smallest | at (smallest) | static |
//                             largest/static
//   mode-amplitudes           mode | frequency | omega | fixed energy | fixed force | fixed impulse
//   mode-amplitude-exponents  claim | held fixed | modes fitted | exponent | standard error | theory | claimed |
//                             verdict
//   collision-cost            partner | sweep | contender | polygons n | points m | time | spread | busy |
//                             time a point | tests | tests a point | building | memory | depth error
//   collision-cost-exponents  partner | sweep | contender | sizes fitted | exponent of time |
//                             standard error of time | busy | exponent of tests | standard error of tests | theory
//   collision-cost-crossover  partner | sweep | contender | rival | building counts | crossover | largest size |
//                             time ratio
//   collision-cost-claim      claim | against | exponent analytic | exponent rival | crossover | verdict
//   contact-forces            shape | depth | contender | samples | error of exact | force | force worst | ... (area,
//                             greatest depth, Hertz force, impulse, peak force, duration likewise)
//   contact-forces-orders     shape | depth | contender | quantity | sizes fitted | exponent | standard error
//   contact-forces-claim      claim | compared | gain | least gain | verdict
//   contact-stiffness         contact | contender | modes r | factor | stiffness | k a/E* | first touch | duration |
//                             peak force | impulse | change of duration | ... of peak force | ... of impulse
//   contacts-in-turn          contact | contender | modes r | touches | start | duration | peak force | impulse |
//                             error of start | ... of duration | ... of peak force | ... of impulse
//   contact-conditions        contact | contender | modes r | condition of start | ... of duration |
//                             ... of peak force | ... of impulse
//   contact-stability         integrator | stiffness factor | dt | dt / limit | spectral radius | energy |
//                             peak force error | impulse error | found | limit | opening limit | verdict
//   contact-stability-summary integrator | cells | stable | inaccurate | unstable |
//                             unstable within the limit | bounded beyond the limit | too short to be seen |
//                             touch missed | may gain | share as predicted | unstable from |
//                             error at the least step | order | standard error
//   corrected-stability, corrected-stability-summary: the same, with static correction
//   contact-meetings          obstacle | law | stiffness | stated | E* | a | k a/E* | first touch | speed | approach |
//                             duration | force
//   contact-geometry          method | modes r | degree | coefficients | kept | condition | residual | worst mode |
//                             largest | static shapes | samples
//   contact-samples           method | modes r | size / a | samples | duration | peak force | impulse |
//                             change of duration | ... of peak force | ... of impulse | peak force against truth |
//                             impulse against truth
//   contact-time              method | modes r | dt | part | calls | time | time a call | share
//   contact-time-runs         method | modes r | static shapes | dt | status | steps | samples | visited | time |
//                             spread | real-time factor | with displacements
//   force-history             contender | modes r | time | normal force
//   flight-cost               varied | method | modes r | flight time | contact time | dt | steps |
//                             contact evaluations | time | spread | time a step | real-time factor
//   flight-cost-exponents     cost | grows with | runs fitted | exponent | standard error | expected
//   instructions              claim | contender | modes r | dt | steps | share counted | instructions | a step |
//                             MIPS for real time | time | real-time factor | verdict
//   slenderness               claim | load | length/width | degree | functions | displacement error | static error |
//                             strain error | bar | frequency ratio | verdict
//   amplitude                 speed | speed/scene's | status | largest strain | largest deformation |
//                             error of linear | of steps | modal against linear | modal against finite | peak force |
//                             linear/finite peak force | ... (impulse, duration likewise)
//   amplitude-limits          error of linear | passed | speed | speed/scene's | largest strain | largest deformation
//   amplitude-exponents       grows with | speeds fitted | exponent | standard error | expected
#pragma once

#include "harness/analysis/analysis.h"

namespace mb {

std::vector<Finding> error_budget(const AnalysisContext& context);
std::vector<Finding> step_limits(const AnalysisContext& context);
std::vector<Finding> stability_map(const AnalysisContext& context);
std::vector<Finding> temporal_aliasing(const AnalysisContext& context);
std::vector<Finding> frequency_responses(const AnalysisContext& context);
std::vector<Finding> mode_amplitudes(const AnalysisContext& context);
std::vector<Finding> achieved_damping(const AnalysisContext& context);
std::vector<Finding> coupled_damping(const AnalysisContext& context);
std::vector<Finding> long_run(const AnalysisContext& context);
std::vector<Finding> multiplets(const AnalysisContext& context);
std::vector<Finding> aspect(const AnalysisContext& context);
std::vector<Finding> locking(const AnalysisContext& context);
std::vector<Finding> linearity(const AnalysisContext& context);
std::vector<Finding> contact_stability(const AnalysisContext& context);
std::vector<Finding> natural_frequencies(const AnalysisContext& context);
std::vector<Finding> probe_extremes(const AnalysisContext& context);
std::vector<Finding> collision_cost(const AnalysisContext& context);
std::vector<Finding> contact_forces(const AnalysisContext& context);
std::vector<Finding> contact_stiffness(const AnalysisContext& context);
std::vector<Finding> contact(const AnalysisContext& context);
std::vector<Finding> flight_cost(const AnalysisContext& context);
std::vector<Finding> instructions(const AnalysisContext& context);
std::vector<Finding> polynomials_over_slenderness(const AnalysisContext& context);
std::vector<Finding> amplitude(const AnalysisContext& context);

}  // namespace mb
