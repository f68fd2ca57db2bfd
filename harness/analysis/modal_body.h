// The body under analysis with its lowest modes, solved for once and cut as often as asked.
#pragma once

#include <string>
#include <variant>

#include "cases/contract/finding.h"
#include "cases/contract/modes.h"
#include "harness/analysis/analysis.h"
#include "mechanics/system/static_response.h"
#include "modal/bases/mode_pairs.h"

namespace mb {

// The first n_elastic elastic modes and all rigid ones; more where a multiplet would be cut, by the rule of
// lowest_modes; fewer where there are no more.
Modes leading(const Modes& modes, int n_elastic);

// [1/s] What rounding leaves in a sum of n terms as large as the largest entry of C, n x n or its diagonal.
double rounding_of_damping(const MatrixXd& C);

// zeta_i = phi_i^T C phi_i / (2 omega_i) of the elastic modes, by the damping operator of the system.
VectorXd damping_ratios(const System& system, const Modes& modes);
// The same, zero where 2 zeta omega is what rounding of the largest of them leaves in C, and nowhere negative.
VectorXd without_rounding(const VectorXd& omega, const VectorXd& zeta);

// [-] What rounding of the entries of K and M makes of a frequency omega [rad/s] of theirs, eps lambda_max/(2 omega^2):
// |dK| <= eps |K| moves lambda by at most eps lambda_max.
double rounding_of_frequency(const Modes& modes, double omega);

struct ModalBody {
  const Model& scene_model;  // valid until the context is asked for a model again
  const BodyModel& model;    // its first body
  const System& system;
  ShiftedFactor shifted;
  Modes modes;
};
// With n_elastic elastic modes, if the body has as many; on its own mesh, or on that of a whole scene's.
ModalBody modal_body(const AnalysisContext& context, int n_elastic);
ModalBody modal_body(const AnalysisContext& context, int n_elastic, const Resolution& meshes);

// Elastic modes as other meshes may be held against them.
struct SeenModes {
  VectorXd omega;   // [rad/s]
  MatrixXd shapes;  // seen_at (mode_pairs.h)
};
SeenModes seen_modes(const ModalBody& body);
SeenModes seen_modes(const FullModel& full, const Quadrature& volume, const Modes& modes);
// [rad/s] Of every own mode that of its pair, the farthest where there are several, or of the same place where none
// moves alike; NaN where the other has fewer modes.
VectorXd paired_frequencies(const SeenModes& own, const SeenModes& other);

// What tells how far numbers of the own mesh are off: the truth's `finer`. Where errors fall by q from the one to the
// other, |own - exact| = q/(q - 1) |own - finer|, and a quarter more, twice at the least; where the own is `finer`,
// |own - exact| <= F |own - coarser|, as of truths (harness/study/mesh_bar.h). What a mesh leaves as it is, as the
// sides of a cylinder's cells, it tells nothing of: 1e-8 of frequencies of torsion.
struct AnotherMesh {
  Resolution meshes;
  double bar_per_distance;  // [-] >= 2, or F of `coarser`; infinite where errors need not fall
};
AnotherMesh another_mesh(const Scene& scene);
PerDistance own_bars_per_distance(const Scene& scene, const TruthSet& truth);  // likewise, of motions under its loads

// Of a mesh that the case does not state, so that nobody has asked yet whether it fits: throws std::runtime_error with
// both numbers where it takes more memory than there is.
Model model_of_own_mesh(const std::shared_ptr<const Scene>& scene, const Resolution& mesh);

// Mode counts of the study, closed form and steppings together, ascending, without 0 and those beyond a third of more
// than 350 degrees of freedom of the body, where only a dense solver would do; never empty.
std::vector<int> mode_counts(const AnalysisContext& context);
// At most n_wanted of them, evenly picked, the smallest and the largest among them.
std::vector<int> few(const std::vector<int>& counts, int n_wanted);

// Whether no support holds the body: its rigid motion is then taken out before anything is compared.
bool is_free(const AnalysisContext& context);

// A table without rows; who calls adds run, case, profile and provenance.
Finding table(std::string analysis, std::string name, std::string title, std::string note,
              std::vector<FindingColumn> columns);
// Error bars of the row that was added last, by names of columns; rows before it that have none get none.
void bar_last_row(Finding& finding, const std::vector<std::pair<const char*, double>>& bars);

inline FindingCell number(double value) { return value; }
inline FindingCell count(Index n) { return static_cast<double>(n); }
FindingCell not_applicable();  // NaN

}  // namespace mb
