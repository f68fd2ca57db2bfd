#include "cases/scene/read_material.h"

#include <fmt/format.h>

#include <algorithm>

#include "cases/scene/number_text.h"

namespace mb {

namespace {

// From the softest gel to beyond diamond, from thin gas to beyond osmium: M, K and their ratios stay far from overflow
// and underflow in double precision.
const Range modulus_range{1, 1e13, "Pa"};
const Range density_range{1e-3, 1e5, "kg/m^3"};
const Range poisson_range{-1, 0.5, "", true, true};  // where K is positive definite
constexpr double nearest = 1e-8;                     // [-] 1 - 2 nu and 1 + nu: half of double precision is left to K
const Range ratio_range{-100, 100};                  // orthotropic: bounded by sqrt(E_i/E_j), see is_stable

std::optional<Orthotropy> read_orthotropy(Section section) {
  const auto youngs = section.vector("youngs_moduli", modulus_range);
  const auto poisson = section.vector("poissons_ratios", ratio_range);
  const auto shear = section.vector("shear_moduli", modulus_range);
  section.finish();
  if (!youngs || !poisson || !shear) return std::nullopt;
  const Orthotropy orthotropy{*youngs, *poisson, *shear};
  if (is_stable(orthotropy)) return orthotropy;
  section.error("poissons_ratios", "with these ratios the compliance is not positive definite: the body would give way",
                "each nu_ij^2 < E_i/E_j, and 1 - nu_xy nu_yx - nu_yz nu_zy - nu_xz nu_zx - 2 nu_yx nu_zy nu_xz > 0");
  return std::nullopt;
}

// The moduli of an orthotropic material stand for those of an isotropic one: either, not both.
std::optional<Material> read_orthotropic(Section& section) {
  for (const char* key : {"youngs_modulus", "poissons_ratio"}) {
    if (!section.has(key)) continue;
    section.findings().error(
        section.where_key(key),
        fmt::format("{} has both 'orthotropy' and '{}': 'orthotropy' replaces it", section.title(), key));
  }
  const auto table = section.section("orthotropy");
  const auto orthotropy = table ? read_orthotropy(*table) : std::nullopt;
  if (!orthotropy) return std::nullopt;
  return Material{orthotropy->youngs_moduli.maxCoeff(), 0, 1, orthotropy};
}

std::optional<Material> read_isotropic(Section& section) {
  const auto modulus = section.number("youngs_modulus", modulus_range);
  const auto ratio = section.number("poissons_ratio", poisson_range);
  if (!modulus || !ratio) return std::nullopt;
  const double least = std::min(1 - 2 * *ratio, 1 + *ratio);
  if (!(least >= nearest))
    section.error("poissons_ratio",
                  fmt::format("so near the end of its range moduli of shear and of volume are {} apart: the stiffness "
                              "matrix loses half of the digits of the smaller and more",
                              number_beside(1 / least, 1 / nearest)),
                  fmt::format("1 - 2 nu and 1 + nu must be at least {}", number_text(nearest)));
  return Material{*modulus, *ratio, 1};
}

// A hundred million times as stiff or soft: the condition number of K then has half of double precision left.
const Range factor_range{1e-8, 1e8};

std::vector<Inclusion> read_inclusions(Section& material) {
  std::vector<Inclusion> inclusions;
  for (Section& section : material.sections("inclusion", {0, 64})) {
    const auto centre = section.vector("centre", {-1e4, 1e4, "m"});
    const auto size = section.vector("size", {1e-6, 1e4, "m"});
    const auto factor = section.number("stiffness_factor", factor_range);
    section.finish();
    if (centre && size && factor) inclusions.push_back({*centre, *size, *factor});
  }
  return inclusions;
}

}  // namespace

std::optional<Material> read_material(Section section) {
  for (const char* key : {"youngs_modulus", "poissons_ratio", "density"}) section.has(key);  // their order in lists
  auto material = section.has("orthotropy") ? read_orthotropic(section) : read_isotropic(section);
  const auto density = section.number("density", density_range);
  const auto inclusions = read_inclusions(section);
  section.not_yet("plasticity");
  section.finish();
  if (!material || !density) return std::nullopt;
  material->density = *density;
  material->inclusions = inclusions;
  return material;
}

DampingDraft read_damping(Section section) {
  // Beyond, every mode is overdamped by more than double precision resolves.
  DampingDraft damping{{section.number("alpha", {0, 1e9, "1/s"}, 0), section.number("beta", {0, 1e3, "s"}, 0)}, {}, {}};
  if (section.has("ratios")) {
    damping.ratios = section.numbers("ratios", {0, 1e9}, {1, 256}).value_or(std::vector<double>{});
    damping.ratios_at = section.where("ratios");
  }
  section.finish();
  return damping;
}

}  // namespace mb
