#include "reference/impact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "mechanics/system/joined.h"
#include "reference/impact_limits.h"
#include "reference/impact_member.h"

namespace mb {

namespace {

constexpr double reach = 0.35;   // [-] of the body's extent: faces that much farther than the nearest never touch
constexpr double blown_up = 10;  // [-] energy by all that there was
constexpr double infinite = std::numeric_limits<double>::infinity();

class PreparedImpact final : public Prepared {
 public:
  PreparedImpact(const Model& model, const Integrator& integrator, const Settings& settings)
      : scene_(model.scene), may_blow_up_(integrator.conditionally_stable) {
    if (!integrator.prepare_in_contact)
      throw std::invalid_argument("integrator '" + integrator.name + "' has no steps for full order in contact");
    for (size_t i = 0; i < model.bodies.size(); ++i) members_.emplace_back(model, i);
    start_ = start();
    std::vector<System> systems;
    for (ImpactMember& member : members_) {
      member.start_at(start_, integrator, settings);
      first_.push_back(n_);
      n_ += member.n();
      systems.push_back(member.system());
    }
    if (!(start_ < scene_->duration)) return;  // nothing is touched
    system_ = systems.size() == 1 ? systems.front() : joined(systems);
    for (size_t i = 0; i < members_.size(); ++i)
      for (const Meeting& meeting : members_[i].touchdown().meetings) add_contact(i, meeting);
    stepper_ = integrator.prepare_in_contact(system_, contacts_, settings, scene_->duration - start_);
  }

  Trajectory simulate(const Sampling& sampling) const override {
    if (sampling.shutter != 0) throw std::invalid_argument("no exact means in contact");
    const VectorXd& t = sampling.t;
    Index n_before = 0;
    while (n_before < t.size() && (t[n_before] < start_ || !stepper_)) ++n_before;
    Trajectory answer{t, {}, {}, Status::ok};
    States states;
    if (stepper_) states = stepper_->run(t.tail(t.size() - n_before).array() - start_);
    answer.work = states.work;
    answer.status = states.status;
    if (stepper_ && sampling.reconstruct && answer.status == Status::ok && t.size() > n_before)
      answer.status = checked(states, t.tail(t.size() - n_before));
    states.u.rightCols(states.u.cols() - states.n_valid).setZero();
    states.v.rightCols(states.v.cols() - states.n_valid).setZero();
    const ContactHistory contact = whole(states.contact, n_before, t.size());
    VectorXd left = states.energy;  // of what is known of the sum
    for (size_t i = members_.size(); i-- > 0;) {
      const States before = members_[i].before(t.head(n_before));
      answer.work.steps += before.work.steps;
      if (before.status != Status::ok) answer.status = before.status;
      answer.bodies.insert(answer.bodies.begin(), body(i, sampling, before, states, contact, left));
    }
    return answer;
  }

  Index n_unknowns() const override { return n_; }

 private:
  // Bodies in flight alone start where the first surfaces meet, but for those that spin. What is held moves from the
  // start, and may be met a little earlier or later than if it were rigid: then while they are still apart by what
  // impact flattens.
  double start() const {
    if (std::ranges::any_of(members_, &ImpactMember::spins)) return 0;
    const auto held = [](const ImpactMember& m) { return !m.free(); };
    if (std::ranges::all_of(members_, held)) return 0;
    double first = scene_->duration;
    for (const ImpactMember& member : members_)
      for (const Meeting& m : member.touchdown().meetings) {
        const double lead = std::ranges::any_of(members_, held) ? m.size.approach / m.size.speed : 0;
        first = std::min(first, std::max(0.0, m.t - lead));
      }
    return first;
  }

  // What is not met first may be met by another side of the body, once that has been turned back: of a plane the part
  // that looks at it and comes first on any way there, of other obstacles all of the boundary.
  double reach_to(const ImpactMember& member, const Meeting& meeting, const RigidSurface& met) const {
    const double usual = reach * extent(member.body().shape);
    if (meeting.t <= start_) return usual;
    const bool flat = std::holds_alternative<HalfSpace>(met.shape);
    const bool soon = partner_of(*scene_, scene_->contacts[meeting.contact]) && std::isfinite(meeting.t);
    if (!flat && !soon) return infinite;
    double nearest = infinite;
    const Pose frame = member.frame();
    for (Index i = 0; i < member.points().cols(); ++i)
      nearest = std::min(nearest, gap_value(met, frame.to_world(member.points().col(i))));
    return usual + std::max(0.0, nearest);
  }

  // Errors are judged by what is met: of an obstacle that a rigid body would not meet, by the size of the first touch.
  const ContactSize& size_for(const ImpactMember& member, const Meeting& meeting) const {
    if (std::isfinite(meeting.t)) return meeting.size;
    return std::ranges::min_element(member.touchdown().meetings, {}, &Meeting::t)->size;
  }

  size_t place_of(const Body& body) const {
    for (size_t i = 0; i < members_.size(); ++i)
      if (members_[i].body().name == body.name) return i;
    throw std::logic_error("a partner is no body of the scene");
  }

  void add_contact(size_t i, const Meeting& meeting) {
    const ImpactMember& member = members_[i];
    const ContactPair& pair = scene_->contacts[meeting.contact];
    RigidSurface met = surface_met(*scene_, member.body(), meeting);
    const Body* partner = partner_of(*scene_, pair);
    const size_t other = partner ? place_of(*partner) : i;
    if (partner) met.pose = members_[other].frame();
    const double within = reach_to(member, meeting, met);
    const ContactSize& scale = size_for(member, meeting);
    contacts_.push_back({member.contact_points(met, within, first_[i], n_),
                         met,
                         law_of(pair, meeting.size),
                         {scale.approach, scale.speed},
                         meeting.t <= start_});
    watched_.push_back({i, pair.obstacle, partner != nullptr});
    if (!partner) return;
    const RigidSurface own{member.body().shape, 0, member.frame()};
    contacts_.back().partner = std::make_shared<const Facets>(members_[other].facets(own, within, first_[other], n_));
  }

  // Throws std::runtime_error for an answer beyond what is simulated here, with what came first. One that an explicit
  // scheme has blown up is no such answer: it has a status.
  Status checked(const States& states, const VectorXd& t) const {
    std::optional<Fault> first;
    const auto note = [&](const std::optional<Fault>& fault) {
      if (fault && (!first || fault->t < first->t)) first = fault;
    };
    for (size_t i = 0; i < members_.size(); ++i)
      if (!members_[i].finite()) note(large_rotation(members_[i].body(), members_[i].rotation(part(states.u, i)), t));
    for (size_t c = 0; c < contacts_.size(); ++c) {
      const auto& [i, obstacle, of_body] = watched_[c];
      const ImpactMember& member = members_[i];
      if (of_body || member.finite()) continue;
      const Boundary all{member.contact_points(contacts_[c].surface, infinite, first_[i], n_), member.frame()};
      note(unwatched_overlap(member.body(), all, contacts_[c], obstacle, {t, states.u}));
    }
    if (!first) return Status::ok;
    if (may_blow_up_ && has_blown_up(states)) return Status::unstable;
    throw std::runtime_error(first->what);
  }

  bool has_blown_up(const States& states) const {
    double there_was = 0, now = 0;
    const auto u = states.u.rightCols(1), v = states.v.rightCols(1);
    for (size_t i = 0; i < members_.size(); ++i) {
      const ImpactMember& m = members_[i];
      const VectorXd load = m.weight();
      there_was += kinetic_energy(m.system(), m.system().v0) + load.lpNorm<1>() * extent(m.body().shape);
      now +=
          kinetic_energy(m.system(), part(v, i)) + strain_energy(m.system(), part(u, i)) - load.dot(part(u, i).col(0));
    }
    return !(now <= blown_up * there_was);
  }

  MatrixXd part(const MatrixXd& all, size_t i) const { return all.middleRows(first_[i], members_[i].n()); }

  // v of all members' states, zeros before the joint start and where they are not to be used.
  MatrixXd velocities(size_t i, const States& states, Index n_before, Index n_t) const {
    MatrixXd v = MatrixXd::Zero(members_[i].n(), n_t);
    if (stepper_) v.middleCols(n_before, states.v.cols()) = part(states.v, i);
    return v;
  }

  BodyTrajectory body(size_t i, const Sampling& sampling, const States& before, const States& states,
                      const ContactHistory& contact, VectorXd& left) const {
    const ImpactMember& member = members_[i];
    const Index n_t = sampling.t.size(), n_before = before.u.cols(), n_valid = states.u.cols();
    BodyTrajectory answer;
    answer.contact = of_body(contact, i);
    if (!sampling.reconstruct) return answer;
    MatrixXd u = MatrixXd::Zero(member.n(), n_t);
    u.leftCols(n_before) = before.u;
    if (stepper_) u.middleCols(n_before, n_valid) = part(states.u, i);
    answer.displacement = member.displacement(u, sampling.t);
    if (!sampling.strain) return answer;
    answer.strain = member.strain(u);
    if (member.free()) answer.momentum = member.momentum(u, velocities(i, states, n_before, n_t), sampling.t);
    answer.energy = VectorXd::Constant(n_t, member.energy_at_start());
    if (!member.free()) answer.energy.head(n_before) = member.energy(before.u, before.v);
    if (stepper_) answer.energy.segment(n_before, n_valid) = energy(i, states, answer.contact, n_before, left);
    return answer;
  }

  // Of the last body by its states; of the first what is left of the stepper's own sum, where there is one.
  VectorXd energy(size_t i, const States& states, const ContactHistory& contact, Index n_before, VectorXd& left) const {
    const ImpactMember& member = members_[i];
    const VectorXd fallen = member.energy(MatrixXd::Zero(member.n(), 1), MatrixXd::Zero(member.n(), 1));
    if (i == 0 && left.size() > 0) return left.array() + fallen[0];
    const VectorXd own = member.energy(part(states.u, i), part(states.v, i));
    if (left.size() > 0) left -= VectorXd(own.array() - fallen[0]);
    return own + contact.stored.segment(n_before, own.size());
  }

  // From the joint start on, before it nothing presses.
  ContactHistory whole(const ContactHistory& from, Index n_before, Index n_t) const {
    ContactHistory all{Matrix3Xd::Zero(3, n_t), Matrix3Xd::Zero(3, n_t), VectorXd::Zero(n_t), VectorXd::Zero(n_t),
                       from.touches};
    for (Touch& touch : all.touches) touch.start += start_, touch.end += start_, touch.peak_time += start_;
    if (n_before == n_t) return all;
    all.force.rightCols(n_t - n_before) = from.force;
    all.impulse.rightCols(n_t - n_before) = from.impulse;
    all.stored.tail(n_t - n_before) = from.stored;
    all.dissipated.tail(n_t - n_before) = from.dissipated;
    return all;
  }

  // What contact does to a body: the one whose points are looked at, or the other, which feels the opposite.
  ContactHistory of_body(const ContactHistory& of_first, size_t i) const {
    if (watched_.empty() || watched_.front().member == i) return of_first;
    return opposite(of_first);
  }

  struct Watched {
    size_t member;  // whose points they are
    std::string obstacle;
    bool of_body;  // whether that is another body
  };

  std::shared_ptr<const Scene> scene_;
  bool may_blow_up_;
  std::vector<ImpactMember> members_;
  std::vector<Index> first_;  // of each member's unknowns
  Index n_ = 0;
  double start_ = 0;  // [s] of the joint integration, at most the duration
  System system_;
  std::vector<Contact> contacts_;
  std::vector<Watched> watched_;      // of each contact
  std::unique_ptr<Stepper> stepper_;  // none: nothing is touched
};

}  // namespace

std::unique_ptr<Prepared> prepare_impact(const Model& model, const Integrator& integrator, const Settings& settings) {
  if (model.bodies.size() > 1 && model.scene->contacts.size() > 1)
    throw std::invalid_argument("full order in contact: of several bodies one contact alone");
  return std::make_unique<PreparedImpact>(model, integrator, settings);
}

}  // namespace mb
