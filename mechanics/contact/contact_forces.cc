#include "mechanics/contact/contact_forces.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <span>
#include <stdexcept>

namespace mb {

namespace {

bool is_flat(const Contact& contact) {
  return !contact.partner && std::holds_alternative<HalfSpace>(contact.surface.shape) && !contact.law.friction;
}

// The rows of one below those of the other.
Eigen::SparseMatrix<double, Eigen::RowMajor> below(const SparseMatrix& upper, const SparseMatrix& lower) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Index j = 0; j < upper.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator it(upper, j); it; ++it) entries.emplace_back(it.row(), j, it.value());
    for (SparseMatrix::InnerIterator it(lower, j); it; ++it)
      entries.emplace_back(upper.rows() + it.row(), j, it.value());
  }
  Eigen::SparseMatrix<double, Eigen::RowMajor> all(upper.rows() + lower.rows(), upper.cols());
  all.setFromTriplets(entries.begin(), entries.end());
  return all;
}

// n^T U_i of every point, or U itself, and that of a partner's nodes.
Eigen::SparseMatrix<double, Eigen::RowMajor> rows_of(const Contact& contact, const Vector3d& normal) {
  const SparseMatrix& U = contact.points.U;
  if (contact.partner) return below(U, contact.partner->U);
  if (!is_flat(contact)) return U;
  std::vector<Eigen::Triplet<double>> entries;
  for (Index j = 0; j < U.outerSize(); ++j)
    for (SparseMatrix::InnerIterator it(U, j); it; ++it) {
      const double along = normal[it.row() % 3] * it.value();
      if (along != 0) entries.emplace_back(it.row() / 3, j, along);
    }
  Eigen::SparseMatrix<double, Eigen::RowMajor> D(U.rows() / 3, U.cols());
  D.setFromTriplets(entries.begin(), entries.end());
  return D;
}

void require_consistent(const Contact& contact, Index n) {
  const auto& [X, w, U] = contact.points;
  if (U.rows() != 3 * X.cols() || w.size() != X.cols() || U.cols() != n)
    throw std::invalid_argument("contact: points, weights and observation differ in size");
  if (contact.partner && contact.partner->U.cols() != n)
    throw std::invalid_argument("contact: body and partner have other unknowns");
}

// Of a row with more entries than columns, as where nodes share their unknowns: those of a reduced body, which all do.
void add_up(Index n, std::vector<std::pair<Index, double>>& row) {
  VectorXd sum = VectorXd::Zero(n);
  for (const auto& [column, entry] : row) sum[column] += entry;
  row.clear();
  for (Index column = 0; column < n; ++column)
    if (sum[column] != 0) row.emplace_back(column, sum[column]);
}

}  // namespace

bool ContactForces::meet() const {
  return std::ranges::any_of(parts_, [](const Part& part) { return part.contact->meets; });
}

ContactForces::ContactForces(const std::vector<Contact>& contacts) {
  std::set<Index> all;
  for (const Contact& contact : contacts) {
    require_consistent(contact, contacts.front().points.U.cols());
    Part part{.contact = &contact, .flat = is_flat(contact)};
    if (contact.partner) part.feet.emplace(*contact.partner, contact.points.X.cols());
    if (part.flat) {
      part.normal = contact.surface.pose.orientation * Vector3d::UnitZ();
      part.gap0 = (contact.points.X.colwise() - contact.surface.pose.position).transpose() * part.normal;
    }
    part.D = rows_of(contact, part.normal);
    for (Index i = 0; i < part.D.outerSize(); ++i)
      for (Rows::InnerIterator it(part.D, i); it; ++it) all.insert(it.col());
    parts_.push_back(std::move(part));
  }
  dofs_.assign(all.begin(), all.end());
  place_.assign(dofs_.size(), -1);
  std::vector<Index> place(contacts.empty() ? 0 : static_cast<size_t>(contacts.front().points.U.cols()), -1);
  for (size_t c = 0; c < dofs_.size(); ++c) place[static_cast<size_t>(dofs_[c])] = static_cast<Index>(c);
  for (Part& part : parts_) {
    std::vector<Eigen::Triplet<double>> entries;
    for (Index i = 0; i < part.D.outerSize(); ++i)
      for (Rows::InnerIterator it(part.D, i); it; ++it)
        entries.emplace_back(i, place[static_cast<size_t>(it.col())], it.value());
    Rows D(part.D.rows(), static_cast<Index>(dofs_.size()));
    D.setFromTriplets(entries.begin(), entries.end());
    part.D = std::move(D);
    part.t = part.rate = part.y = VectorXd::Zero(part.D.rows());
  }
}

void ContactForces::flat_tractions(const Part& part, ContactSum& sum, bool with_tangent) {
  const PenaltyLaw& law = part.contact->law;
  const VectorXd& w = part.contact->points.w;
  double force = 0;
  for (Index i = 0; i < w.size(); ++i) {
    const double gap = part.gap0[i] + part.y[i];
    sum.least_gap = std::min(sum.least_gap, gap);
    part.t[i] = 0;
    if (!(gap < 0)) continue;
    const double damped = 1 - law.damping * part.rate[i];
    const auto [elastic, by_gap] = layer(law, gap);
    sum.stored += w[i] * stored_energy(law, gap);
    if (!(damped > 0)) {  // leaves faster than the layer follows: what it holds is lost
      sum.dissipation += w[i] * elastic * part.rate[i];
      continue;
    }
    part.t[i] = w[i] * elastic * damped;
    force += part.t[i];
    sum.dissipation += w[i] * elastic * law.damping * part.rate[i] * part.rate[i];
    if (!with_tangent) continue;
    part.touching.push_back(i);
    part.by_x.emplace_back(Eigen::Matrix3d::Constant(w[i] * by_gap * damped));
    part.by_v.emplace_back(Eigen::Matrix3d::Constant(-w[i] * elastic * law.damping));
  }
  sum.force += force * part.normal;
}

void ContactForces::tractions(const Part& part, ContactSum& sum, bool with_tangent) {
  const auto& [X, w, U] = part.contact->points;
  for (Index i = 0; i < w.size(); ++i) {
    const Vector3d x = X.col(i) + part.y.segment<3>(3 * i), v = part.rate.segment<3>(3 * i);
    const double value = gap_value(part.contact->surface, x);
    sum.least_gap = std::min(sum.least_gap, value);
    part.t.segment<3>(3 * i).setZero();
    if (!(value < 0)) continue;
    const Gap at = gap(part.contact->surface, x);
    const Traction3 t = contact_traction(part.contact->law, at, v);
    push(part, i, t, at, v, sum);
    if (!with_tangent) continue;
    part.touching.push_back(i);
    part.by_x.push_back(w[i] * t.by_x);
    part.by_v.push_back(w[i] * t.by_v);
  }
}

void ContactForces::push(const Part& part, Index i, const Traction3& t, const Gap& at, const Vector3d& v,
                         ContactSum& sum) {
  const double w = part.contact->points.w[i];
  part.t.segment<3>(3 * i) = w * t.t;
  sum.force += w * t.t;
  sum.stored += w * stored_energy(part.contact->law, at.value);
  sum.dissipation -= w * (t.t.dot(v) - layer(part.contact->law, at.value).pressure * at.normal.dot(v));
}

// The curvature of the partner's boundary is left out of the tangent: what it adds is p, k_n gap, by the radius of
// curvature, against k_n.
void ContactForces::tractions_between(const Part& part, ContactSum& sum, bool with_tangent) {
  const auto& [X, w, U] = part.contact->points;
  const Facets& facets = *part.contact->partner;
  const Index m = X.cols();
  part.feet->move_to(part.y.tail(3 * facets.X.cols()));
  part.t.setZero();
  for (Index i = 0; i < m; ++i) {
    const auto near = (*part.feet)(i, X.col(i) + part.y.segment<3>(3 * i));
    sum.least_gap = std::min(sum.least_gap, near.gap);
    if (!near.foot) continue;
    const FacetFoot& foot = *near.foot;
    const auto nodes = facets.nodes.col(foot.patch);
    Vector3d v = part.rate.segment<3>(3 * i);
    for (Index a = 0; a < nodes.size(); ++a) v -= foot.N[a] * part.rate.segment<3>(3 * (m + nodes[a]));
    const Gap at{foot.gap, foot.normal, Eigen::Matrix3d::Zero()};
    const Traction3 t = contact_traction(part.contact->law, at, v);
    push(part, i, t, at, v, sum);
    for (Index a = 0; a < nodes.size(); ++a) part.t.segment<3>(3 * (m + nodes[a])) -= w[i] * foot.N[a] * t.t;
    if (!with_tangent) continue;
    part.touching.push_back(i);
    part.at.push_back(foot);
    part.by_x.push_back(w[i] * t.by_x);
    part.by_v.push_back(w[i] * t.by_v);
  }
}

ContactSum ContactForces::evaluate(const VectorXd& u, const VectorXd& v, VectorXd& f, bool with_tangent) const {
  ContactSum sum{std::numeric_limits<double>::infinity(), Vector3d::Zero(), 0, 0};
  f.setZero(static_cast<Index>(dofs_.size()));
  for (const Part& part : parts_) {
    part.touching.clear();
    part.at.clear();
    part.by_x.clear();
    part.by_v.clear();
    part.y.noalias() = part.D * u;
    part.rate.noalias() = part.D * v;
    if (part.flat)
      flat_tractions(part, sum, with_tangent);
    else if (part.feet)
      tractions_between(part, sum, with_tangent);
    else
      tractions(part, sum, with_tangent);
    if (sum.least_gap < 0) f.noalias() += part.D.transpose() * part.t;
  }
  return sum;
}

ContactSum ContactForces::operator()(const VectorXd& u, const VectorXd& v, VectorXd& f) const {
  return evaluate(u, v, f, false);
}

ContactSum ContactForces::operator()(const VectorXd& u, const VectorXd& v, VectorXd& f, Tangent& tangent) const {
  const ContactSum sum = evaluate(u, v, f, true);
  assemble(tangent);
  return sum;
}

// Of a touching point's displacement, relative to its foot: n^T D_i, or D_i - sum_a N_a D_a along one axis.
void ContactForces::relative_row(const Part& part, size_t touching, Index component, Row& row) {
  row.clear();
  const Index i = part.touching[touching];
  for (Rows::InnerIterator it(part.D, part.flat ? i : 3 * i + component); it; ++it)
    row.emplace_back(it.col(), it.value());
  if (!part.feet) return;
  const FacetFoot& foot = part.at[touching];
  const auto nodes = part.contact->partner->nodes.col(foot.patch);
  for (Index a = 0; a < nodes.size(); ++a)
    for (Rows::InnerIterator it(part.D, 3 * (part.contact->points.X.cols() + nodes[a]) + component); it; ++it)
      row.emplace_back(it.col(), -foot.N[a] * it.value());
  if (static_cast<Index>(row.size()) > part.D.cols()) add_up(part.D.cols(), row);
}

// K = sum_i D_i^T B_i D_i over touching points, B_i of 1 x 1 (all entries of it alike) or 3 x 3.
void ContactForces::assemble(Tangent& tangent) const {
  std::vector<Index>& active = tangent.active;
  active.clear();
  std::array<Row, 3> rows;
  const auto look = [&](const Part& part, size_t p) {
    const Index n = part.flat ? 1 : 3;
    for (Index k = 0; k < n; ++k) relative_row(part, p, k, rows[static_cast<size_t>(k)]);
    return std::span(rows.data(), static_cast<size_t>(n));
  };
  for (const Part& part : parts_)
    for (size_t p = 0; p < part.touching.size(); ++p)
      for (const Row& row : look(part, p))
        for (const auto& [column, entry] : row) {
          Index& place = place_[static_cast<size_t>(column)];
          if (place < 0) place = static_cast<Index>(active.size()), active.push_back(column);
        }
  const auto n = static_cast<Index>(active.size());
  tangent.by_u.setZero(n, n);
  tangent.by_v.setZero(n, n);
  for (const Part& part : parts_)
    for (size_t p = 0; p < part.touching.size(); ++p) {
      const auto seen = look(part, p);
      for (size_t k = 0; k < seen.size(); ++k)
        for (size_t l = 0; l < seen.size(); ++l) {
          const double by_u = part.by_x[p](static_cast<Index>(k), static_cast<Index>(l));
          const double by_v = part.by_v[p](static_cast<Index>(k), static_cast<Index>(l));
          for (const auto& [column_b, b] : seen[l])
            for (const auto& [column_a, a] : seen[k]) {
              const Index i = place_[static_cast<size_t>(column_a)], j = place_[static_cast<size_t>(column_b)];
              tangent.by_u(i, j) += a * b * by_u;
              tangent.by_v(i, j) += a * b * by_v;
            }
        }
    }
  for (const Index c : active) place_[static_cast<size_t>(c)] = -1;
}

}  // namespace mb
