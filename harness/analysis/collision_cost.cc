#include "harness/analysis/collision_cost.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/analysis/analyses.h"
#include "harness/analysis/modal_body.h"

namespace mb {

namespace {

constexpr double undisturbed = 0.95;  // [-] of the processor, as of measure.h
constexpr double tick = 1e-9;         // [s] of a clock, below which a time is none

Finding costs_table() {
  return table(
      "collision-cost", "collision-cost", "Cost of collision detection",
      "Signed distances of m points all over the first body's surface from a partner of its size that it overlaps by 4 "
      "% of its half extent, as n polygons or as an analytic shape. Brute force, tree and analytic distance give those "
      "of all points; within reach (10 % of the half extent) and depth inside what contact asks for; the function "
      "alone its sign and a depth of first order. Time of one query, median. Tests: boxes and triangles, or values of "
      "a function or distance. Building of the tree is apart, as is that of the mesh; points are in the partner's "
      "frame and both rigid. Depth error: largest deviation from the exact distance, of points within reach.",
      {{"partner", ""},
       {"sweep", ""},
       {"contender", ""},
       {"polygons n", ""},
       {"points m", ""},
       {"time", "s"},
       {"spread", "s"},
       {"busy", "-"},
       {"time a point", "s"},
       {"tests", ""},
       {"tests a point", ""},
       {"building", "s"},
       {"memory", "B"},
       {"depth error", "m"}});
}

Finding exponents_table() {
  return table("collision-cost", "collision-cost-exponents", "How the cost of collision detection grows",
               "Exponent p of cost ~ m^p by least squares in logarithms, of measured time and of tests. Busy: the "
               "least share of "
               "the processor while it was timed; below 0.95 other work perturbed the time. Theory: of "
               "tests; a tree's have a logarithm, and from afar the root of n.",
               {{"partner", ""},
                {"sweep", ""},
                {"contender", ""},
                {"sizes fitted", ""},
                {"exponent of time", "-"},
                {"standard error of time", "-"},
                {"busy", "-"},
                {"exponent of tests", "-"},
                {"standard error of tests", "-"},
                {"theory", "-"}});
}

Finding crossovers_table() {
  return table("collision-cost", "collision-cost-crossover",
               "From which size on analytic collision detection is cheaper",
               "The size m from which on the analytic contender takes less time than the rival on the same points, for "
               "good; the smallest size tried where it always does, n/a where it does not at the largest. Time ratio: "
               "rival by analytic at the largest size that both ran at; neither is given where other work perturbed a "
               "time. With building: a tree built anew for each "
               "query, as a body that deforms calls for.",
               {{"partner", ""},
                {"sweep", ""},
                {"contender", ""},
                {"rival", ""},
                {"building counts", ""},
                {"crossover", ""},
                {"largest size", ""},
                {"time ratio", "-"}});
}

Finding claim_table() {
  return table("collision-cost", "collision-cost-claim", "Claim C11: does collision cost O(m) against O(n m)?",
               "By tests where n = m: analytic ~ m, its rival ~ m^2; and by times from which size on the analytic one "
               "is cheaper. Both sides answer alike: all distances against brute force and tree, depths inside against "
               "a tree within reach. Bars of exponents are standard errors.",
               {{"claim", ""},
                {"against", ""},
                {"exponent analytic", "-"},
                {"exponent rival", "-"},
                {"crossover", ""},
                {"verdict", ""}});
}

struct Sweep {
  std::string partner, name;
  const std::vector<CollisionRun>& runs;
};

std::vector<FindingCell> cost_row(const Sweep& sweep, const CollisionRun& run) {
  return {sweep.partner,
          sweep.name,
          run.contender,
          run.n,
          run.m,
          run.time.median,
          run.time.spread,
          run.time.busy,
          run.time.median / run.m,
          run.tests,
          run.tests / run.m,
          run.building,
          run.bytes,
          run.depth_error};
}

struct Costs {
  VectorXd m, time, tests;
  double busy = 1;  // the least of them
};
Costs costs(const Sweep& sweep, const std::string& contender, bool with_building = false) {
  std::vector<double> m, time, tests;
  double busy = 1;
  for (const CollisionRun& run : sweep.runs) {
    if (run.contender != contender) continue;
    m.push_back(run.m);
    time.push_back(std::max(run.time.median, tick) + (with_building ? run.building : 0));
    tests.push_back(run.tests);
    busy = std::min(busy, run.time.busy);
  }
  const auto vector = [](const std::vector<double>& v) {
    return VectorXd(Eigen::Map<const VectorXd>(v.data(), static_cast<Index>(v.size())));
  };
  return {vector(m), vector(time), vector(tests), busy};
}

std::vector<FindingCell> exponent_row(const Sweep& sweep, const std::string& contender) {
  const Costs all = costs(sweep, contender);
  const PowerLaw time = power_law(all.m, all.time), tests = power_law(all.m, all.tests);
  double theory = 1;
  if (sweep.name == "n = m" && contender == brute_force) theory = 2;
  if (sweep.name == "n = m" && contender.starts_with(tree)) theory = std::numeric_limits<double>::quiet_NaN();
  return {sweep.partner,       sweep.name, contender,      count(time.n_points), time.exponent,
          time.standard_error, all.busy,   tests.exponent, tests.standard_error, theory};
}

struct Duel {
  const char *analytic, *rival;
  bool with_building;
};
constexpr Duel duels[] = {{analytic_distance, brute_force, false},
                          {analytic_distance, tree, false},
                          {analytic_distance, tree, true},
                          {depth_inside, tree_within_reach, false},
                          {depth_inside, tree_within_reach, true}};

struct Outcome {
  double crossover, largest, ratio;  // the first and the last NaN where times were perturbed
  bool perturbed = false;
};
Outcome outcome(const Sweep& sweep, const Duel& duel) {
  const Costs rival = costs(sweep, duel.rival, duel.with_building), own = costs(sweep, duel.analytic);
  const Index n = rival.m.size();  // rivals give up at large sizes
  if (n == 0) return {std::nan(""), std::nan(""), std::nan("")};
  if (std::min(own.busy, rival.busy) < undisturbed) return {std::nan(""), rival.m[n - 1], std::nan(""), true};
  return {crossover(rival.m, own.time.head(n), rival.time), rival.m[n - 1], rival.time[n - 1] / own.time[n - 1]};
}

void add_claim(Finding& claim, const Sweep& sweep, const Duel& duel) {
  const Costs own = costs(sweep, duel.analytic), rival = costs(sweep, duel.rival);
  const PowerLaw p = power_law(own.m, own.tests), q = power_law(rival.m, rival.tests);
  const Outcome found = outcome(sweep, duel);
  claim.rows.push_back({"C11", fmt::format("{}; {}", duel.rival, sweep.partner), p.exponent, q.exponent,
                        found.crossover,
                        collision_verdict(p.exponent, q.exponent, found.crossover, own.m[0], found.perturbed)});
  bar_last_row(claim, {{"exponent analytic", p.standard_error}, {"exponent rival", q.standard_error}});
}

}  // namespace

std::string collision_verdict(double analytic, double rival, double crossover, double smallest, bool perturbed) {
  constexpr double width = 0.15;
  if (!std::isfinite(analytic) || !std::isfinite(rival)) return "not decided: too few sizes";
  std::string where = fmt::format("cheaper from m = {:.0f} on", crossover);
  if (crossover <= smallest) where = "cheaper at all sizes";
  if (std::isnan(crossover)) where = "not cheaper at the largest size";
  if (perturbed) where = "times perturbed by other work";
  if (std::abs(analytic - 1) > width) return fmt::format("does not hold: analytic ~ m^{:.2f}; {}", analytic, where);
  if (std::abs(rival - 2) > width) return fmt::format("does not hold: the rival ~ m^{:.2f}; {}", rival, where);
  if (perturbed) return "not decided: " + where;
  return crossover <= smallest ? "holds" : fmt::format("holds within limits: {}", where);
}

std::vector<Finding> collision_cost(const Shape& body, const CollisionSizes& sizes) {
  Finding cost = costs_table(), exponents = exponents_table(), crossovers = crossovers_table(), claim = claim_table();
  for (const auto& [name, partner] :
       {std::pair<std::string, Shape>("sphere", sphere_of_size(body)), {"superquadric", superquadric_of_size(body)}}) {
    const CollisionContest contest = collision_contest(body, partner, sizes);
    const std::string fixed = fmt::format("n = {}", 48 * sizes.fixed * sizes.fixed);
    for (const Sweep& sweep : {Sweep{name, "n = m", contest.together}, Sweep{name, fixed, contest.fixed_polygons}}) {
      for (const CollisionRun& run : sweep.runs) cost.rows.push_back(cost_row(sweep, run));
      for (const char* contender :
           {brute_force, tree, tree_within_reach, analytic_distance, analytic_function, depth_inside})
        exponents.rows.push_back(exponent_row(sweep, contender));
      for (const Duel& duel : duels) {
        const Outcome found = outcome(sweep, duel);
        crossovers.rows.push_back({name, sweep.name, duel.analytic, duel.rival, duel.with_building ? "yes" : "no",
                                   found.crossover, found.largest, found.ratio});
        if (sweep.name == "n = m" && !duel.with_building) add_claim(claim, sweep, duel);
      }
    }
  }
  return {cost, exponents, crossovers, claim};
}

std::vector<Finding> collision_cost(const AnalysisContext& context) {
  return collision_cost(context.scene->bodies.front().shape, usual_sizes());
}

}  // namespace mb
