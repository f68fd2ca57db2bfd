#include "reports/claims.h"

#include <algorithm>

#include "reports/claim_instances.h"

namespace mb {
namespace {

constexpr const char* statements[][2] = {
    {"C1", "up to two orders of magnitude less computing time, with reasonable accuracy"},
    {"C2", "dropping high modes removes temporal aliasing and the need for time averaging"},
    {"C3", "many inverse problems have a closed form"},
    {"C4", "rigid, linear and quadratic modes suffice, but not for bodies of disparate dimensions"},
    {"C5", "low modes stay valid as the body deforms, high modes do not"},
    {"C6", "the largest stable explicit step is inversely proportional to the highest frequency kept"},
    {"C7", "for fixed excitation energy a mode's displacement falls with the square of its frequency"},
    {"C8", "the residual of the full equations detects truncation; modes chosen from it repair it"},
    {"C9", "modes of a moment-matched box or of a single 20-node element look right"},
    {"C10", "low modes are well described by polynomials of low degree"},
    {"C11", "collision costs O(m) against O(n m)"},
    {"C12", "analytic contact regions give more accurate forces than vertex contact"},
    {"C13", "inverse problems shrink from thousands of unknowns to a few dozen"},
    {"C14", "a ball on a two-by-four ran at about one CPU second a simulated second on a machine of one MIPS"},
    {"C15", "the modal transform is a preconditioner with better conditioning"},
    {"C16", "modal superposition can drive plastic and viscous material"}};

// What fixed energy decides; fixed force and impulse stand beside it.
std::vector<Instance> amplitudes(const Evaluation& evaluation) {
  std::vector<Instance> all = rows_of(evaluation, "C7", "mode-amplitude-exponents", "held fixed", "exponent");
  for (Instance& one : all) one.decides = one.label == "energy";
  return all;
}

void rule_on(Claim& claim, const Evaluation& evaluation) {
  if (claim.id == "C1") rule_on_speed_up(claim, evaluation);
  if (claim.id == "C4") rule_on_polynomials(claim, evaluation);
  if (claim.id == "C6") rule_on_steps(claim, evaluation);
  if (claim.id == "C11") rule_on_collision(claim, evaluation);
  if (claim.id == "C12") rule_on_contact(claim, evaluation);
  if (claim.id == "C2") {
    claim.evidence = "aliasing";
    claim.criterion = "verdicts of the aliasing tables, a frame rate each; number: aliasing of modes cut at F/2";
    conclude(claim, rows_of(evaluation, claim.id, "aliasing-claim", "frame rate", "aliasing cut modal"));
  }
  if (claim.id == "C14") {
    claim.evidence = "instructions";
    claim.criterion =
        "million instructions a simulated second of rigid, linear and quadratic modes, stepping and displacements at "
        "frames: claimed about 1, at most 2 holds";
    conclude(claim, rows_of(evaluation, claim.id, "instructions", "contender", "MIPS for real time"));
  }
  if (claim.id == "C7") {
    claim.evidence = "mode-amplitudes";
    claim.criterion = "exponent of displacement over frequency for fixed energy; claimed 2, theory 1";
    conclude(claim, amplitudes(evaluation));
  }
}

}  // namespace

const char* to_string(Ruling ruling) {
  switch (ruling) {
    case Ruling::holds:
      return "holds";
    case Ruling::holds_within_limits:
      return "holds within stated limits";
    case Ruling::does_not_hold:
      return "does not hold";
    case Ruling::not_decided:
      return "not decided";
    case Ruling::not_measured:
      return "not measured here";
  }
  return "";
}

Ruling together(const std::vector<Ruling>& rulings) {
  const auto n_of = [&](Ruling one) { return std::count(rulings.begin(), rulings.end(), one); };
  const auto n_holds = n_of(Ruling::holds), n_limits = n_of(Ruling::holds_within_limits);
  const auto n_fails = n_of(Ruling::does_not_hold);
  if (n_holds + n_limits + n_fails == 0) return n_of(Ruling::not_decided) ? Ruling::not_decided : Ruling::not_measured;
  if (n_limits + n_fails == 0) return Ruling::holds;
  return n_holds + n_limits > 0 ? Ruling::holds_within_limits : Ruling::does_not_hold;
}

std::vector<Claim> claims(const Evaluation& evaluation) {
  std::vector<Claim> all;
  for (const auto& [id, statement] : statements) {
    Claim& claim = all.emplace_back();
    claim.id = id;
    claim.statement = statement;
    rule_on(claim, evaluation);
  }
  return all;
}

Sheet claims_table(const Evaluation& evaluation) {
  Sheet table{
      .name = "claims",
      .title = "The paper's claims",
      .note =
          "Pentland and Williams, Good Vibrations, SIGGRAPH 1989. Verdicts follow from the records and tables of "
          "this report and decide no exit code.",
      .columns = {{"id", ""},
                  {"claim", ""},
                  {"verdict", ""},
                  {"measured", ""},
                  {"limits", ""},
                  {"judged by", ""},
                  {"evidence", ""}},
      .rows = {},
      .n_keys = 0};
  for (const Claim& claim : claims(evaluation)) {
    const bool measured = claim.ruling != Ruling::not_measured;
    table.rows.push_back({text_cell(claim.id), text_cell(claim.statement), text_cell(to_string(claim.ruling)),
                          text_cell(measured ? claim.measured : ""), text_cell(claim.limits),
                          text_cell(measured ? claim.criterion : ""), text_cell(measured ? claim.evidence : "")});
  }
  return table;
}

}  // namespace mb
