#include "mechanics/contact/contact_forces.h"

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

namespace mb {

namespace {

bool is_flat(const Contact& contact) {
  return std::holds_alternative<HalfSpace>(contact.surface.shape) && !contact.law.friction;
}

// n^T U_i of every point, or U itself.
Eigen::SparseMatrix<double, Eigen::RowMajor> rows_of(const Contact& contact, const Vector3d& normal) {
  const SparseMatrix& U = contact.points.U;
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
}

}  // namespace

bool ContactForces::meet() const {
  return std::ranges::any_of(parts_, [](const Part& part) { return part.contact->meets; });
}

ContactForces::ContactForces(const std::vector<Contact>& contacts) {
  std::set<Index> all;
  for (const Contact& contact : contacts) {
    require_consistent(contact, contacts.front().points.U.cols());
    Part part{&contact, is_flat(contact), {}, {}, Vector3d::Zero(), {}, {}, {}, {}, {}, {}};
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
    part.t.segment<3>(3 * i) = w[i] * t.t;
    sum.force += w[i] * t.t;
    sum.stored += w[i] * stored_energy(part.contact->law, value);
    sum.dissipation -= w[i] * (t.t.dot(v) - layer(part.contact->law, value).pressure * at.normal.dot(v));
    if (!with_tangent) continue;
    part.touching.push_back(i);
    part.by_x.push_back(w[i] * t.by_x);
    part.by_v.push_back(w[i] * t.by_v);
  }
}

ContactSum ContactForces::evaluate(const VectorXd& u, const VectorXd& v, VectorXd& f, bool with_tangent) const {
  ContactSum sum{std::numeric_limits<double>::infinity(), Vector3d::Zero(), 0, 0};
  f.setZero(static_cast<Index>(dofs_.size()));
  for (const Part& part : parts_) {
    part.touching.clear();
    part.by_x.clear();
    part.by_v.clear();
    part.y.noalias() = part.D * u;
    part.rate.noalias() = part.D * v;
    part.flat ? flat_tractions(part, sum, with_tangent) : tractions(part, sum, with_tangent);
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

// K = sum_i D_i^T B_i D_i over touching points, B_i of 1 x 1 (all entries of it alike) or 3 x 3.
void ContactForces::assemble(Tangent& tangent) const {
  std::vector<Index>& active = tangent.active;
  active.clear();
  for (const Part& part : parts_)
    for (const Index i : part.touching)
      for (Index k = 0; k < (part.flat ? 1 : 3); ++k)
        for (Rows::InnerIterator it(part.D, part.flat ? i : 3 * i + k); it; ++it) {
          Index& place = place_[static_cast<size_t>(it.col())];
          if (place < 0) place = static_cast<Index>(active.size()), active.push_back(it.col());
        }
  const auto n = static_cast<Index>(active.size());
  tangent.by_u.setZero(n, n);
  tangent.by_v.setZero(n, n);
  const auto at = [&](const Rows::InnerIterator& it) { return place_[static_cast<size_t>(it.col())]; };
  for (const Part& part : parts_)
    for (size_t p = 0; p < part.touching.size(); ++p) {
      const Index i = part.touching[p], rows = part.flat ? 1 : 3;
      for (Index k = 0; k < rows; ++k)
        for (Index l = 0; l < rows; ++l)
          for (Rows::InnerIterator b(part.D, rows * i + l); b; ++b)
            for (Rows::InnerIterator a(part.D, rows * i + k); a; ++a) {
              const double factor = a.value() * b.value();
              tangent.by_u(at(a), at(b)) += factor * part.by_x[p](k, l);
              tangent.by_v(at(a), at(b)) += factor * part.by_v[p](k, l);
            }
    }
  for (const Index c : active) place_[static_cast<size_t>(c)] = -1;
}

}  // namespace mb
