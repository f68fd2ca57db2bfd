#include "reports/definitions.h"

namespace mb {
namespace {

constexpr std::pair<const char*, const char*> words[] = {
    {"truth finer",
     "A full-order answer of higher degree or on a finer mesh, integrated tightly: errors against it "
     "hold truncation, time stepping and discretisation."},
    {"truth same_mesh",
     "A full-order answer with the contender's own M and K, integrated tightly: errors against it "
     "hold truncation and time stepping alone."},
    {"truth exact",
     "The closed form of the continuum itself, where a case has one: errors against it hold truncation, time stepping "
     "and discretisation."},
    {"truth same_modes",
     "The closed form of the same modes, of runs whose modes are stepped by something else: errors against it hold "
     "time stepping alone. Its bar is the error of representing the load."},
    {"closed form",
     "Modes are integrated exactly, without time steps: the integrator of runs that name none, exact in case files and "
     "records. Of scenes without contact."},
    {"closed form, steps in contact",
     "What exact means in scenes with contact: the body flies in closed form while nothing touches it. In "
     "contact it takes time steps, whose size and number stand beside the run: half a step's kick of the "
     "contact force, every mode in closed form over the step, half a kick again. Of order 2 in the step, with damping "
     "or friction in contact 1. What is struck at the start steps all the way."},
    {"mesh",
     "Q4 1x4: hexahedra of degree 4, of a cylinder 1 split of each edge of the five-block disc (0: the disc is one "
     "block) by 4 layers; of a box Q2 4x2x1: cells along x, y and z; of a sphere Q3 2: cells along each edge of its "
     "seven blocks. Graded 3: cells near the first touch of a contact are halved up to 3 times. Beams and plates by "
     "theory have no mesh: 7x7 half waves, along x and y."},
    {"error bar",
     "How far the truth itself may be off, by the same metric. An error below it prints as <= error + bar, what it may "
     "be at most. Where runs are compared with each other it counts as the bar; where an error is compared with a "
     "bound "
     "or the 1 % target, error and bar together must be within it."},
    {"r",
     "Elastic modes asked for; rigid modes always stay. Modes of equal frequency are kept whole, so that the "
     "number used may be larger: both are recorded."},
    {"speed-up at 1 % error",
     "The headline, its table and figure, and claim C1. Online time of the cheapest full-order run over that of the "
     "cheapest reduced run, of those whose displacement error against exact, or finer where no closed form is known, "
     "error bar included, is at most 1 %: the "
     "same rule on both sides, so that their errors differ. Cases of beam or plate theory do not count: what is full "
     "order there are half waves, modes too, and no finite elements. Its near miss is the dearest of the full-order "
     "runs that "
     "are cheaper than the rival: each is outside the target, or its error bar leaves that open."},
    {"speed-up at equal error",
     "The table of that name and the column of the contenders. Online time of the rival over the online time of the "
     "reduced run. The rival is the cheapest full-order contender "
     "whose error is at most that of the reduced run; no interpolation between runs. None reached: no full-order "
     "contender of the sweep reaches that error. Single run: one of the times has no spread, so that the ratio has no "
     "range. Times are compared where one machine took them: same processor, BLAS and threads; of every case the "
     "machine with most times counts."},
    {"margin",
     "How much more exact the rival is: error of the reduced run over the rival's. Meshes and steps of the sweep "
     "are coarse, so that the rival is always more exact than it need be, and the speed-up too large for exactly "
     "equal error. Its range is that of both error bars."},
    {"near miss",
     "At equal error: the most exact of the full-order contenders that are cheaper than the rival: it just misses the "
     "error. Its "
     "online time over that of the reduced run is the miss speed-up. Rival and near miss are neighbours of this sweep: "
     "if cost rises with accuracy between them, the speed-up at exactly equal error lies between miss speed-up and "
     "speed-up; a contender outside this sweep may be cheaper than both."},
    {"break-even",
     "Simulated seconds after which offline plus online time of the reduced run falls below that of "
     "its rival: the difference of their offline times divided by what a simulated second gains; never where nothing "
     "is "
     "gained. Preparation is timed once, so that no range is known."},
    {"real-time factor",
     "Simulated seconds per computing second, online: 1 keeps up with real time. Its range is that of the time."},
    {"perturbed",
     "A time during which something else had the core: processor time over wall-clock time (busy) below 0.9. Its range "
     "goes down to that share of it."},
    {"edge of its sweep",
     "The rival has the largest time step or tolerance, or the coarsest mesh, that was run with its integrator in that "
     "case: beyond it a cheaper full-order contender may reach the error."},
    {"within noise",
     "The ranges of both times leave open which is faster; with a single run on either side, times within a factor "
     "1.2, and what perturbed them."},
    {"order",
     "p of error ~ r^-p, step^p or tolerance^p, fitted over the points named in the table of orders; its standard "
     "error "
     "is that of the fit."},
    {"check",
     "A bound that the case file sets. It holds where value and error bar together are within it, fails where no value "
     "within the error bar is, and is not decidable between the two."}};

}  // namespace

std::vector<Explanation> own_words() {
  std::vector<Explanation> all;
  for (const auto& [term, text] : words) all.push_back({term, text});
  return all;
}

std::vector<Explanation> definitions(const Evaluation& evaluation) {
  std::vector<Explanation> all;
  for (const auto& [metric, text] : evaluation.input.metric_docs) all.push_back({metric, text});
  for (Explanation& one : own_words()) all.push_back(std::move(one));
  return all;
}

}  // namespace mb
