// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/one_cell.hpp"

#include "physics/coupling/added_mass.hpp"
#include "physics/coupling/contact_share.hpp"
#include "physics/coupling/predictor.hpp"
#include "physics/coupling/true_up.hpp"

#include <algorithm>
#include <cmath>

namespace testing {

using physics::GrainResponse;
using physics::Mode;

namespace {

constexpr int passes_of_iterated = 4;
constexpr int coarsening = 4;

void add(GrainResponse& sum, const GrainResponse& one)
{
    sum.reaction += one.reaction;
    sum.flux += one.flux;
    sum.displaced += one.displaced;
    sum.added += one.added;
    sum.added_flux += one.added_flux;
}

/// Hold from the second pass on.
template <class Lane>
double changed(const Lane& before, const Lane& now)
{
    const double applied = now.applied - before.applied, contact = now.contact - before.contact;
    return physics::changed_share(now.share, contact * applied, applied * applied, now.applied * now.applied);
}

double first_exponential(double x) { return x < 1e-8 ? 1.0 - 0.5 * x : -std::expm1(-x) / x; }

} // namespace

/// What one pass over the interval found.
struct OneCell::Pass {
    std::vector<Lane> real;
    std::vector<double> owed;
    double velocity = 0.0, force = 0.0, mistaken = 0.0;
};

OneCell::OneCell(const CellScene& scene) : scene_(scene), random_(scene.seed)
{
    const double s = scene.density_ratio;
    phi_ = s / (s + scene.loading);
    const bool two = scene.contact == Contact::half_locked || scene.contact == Contact::random_clamps;
    const double volume = (1.0 - phi_) / (two ? 2.0 : 1.0);
    for (int kind = 0; kind < (two ? 2 : 1); ++kind) {
        Grain grain;
        const double drag = scene.stiffness * s * volume * (kind == 0 ? 1.0 : 3.0);
        const double growth = physics::growth_share(drag / (s * volume) * (1.0 + scene.loading));
        grain.coupling = {s * volume, volume, drag, scene.added_mass * volume, growth};
        grains_.push_back(grain);
    }
    u_ = scene.motion == Motion::confined ? scene.flow(0.0) / phi_ : 0.0;
}

double OneCell::body_force(const Grain& grain) const
{
    if (scene_.motion == Motion::transverse) return 0.0;
    return -(scene_.density_ratio - 1.0) * grain.coupling.volume * scene_.gravity;
}

/// @param free  Velocity at the end of the sub-step, of length `h`, without contact.   @param give  Velocity per impulse.
double OneCell::contact_impulse(const Grain& grain, Hold hold, const Lane& lane, double free, double give, double h) const
{
    const double stop = -free / give;
    if (hold == Hold::free || (hold == Hold::scene && scene_.contact == Contact::none)) return 0.0;
    if (hold == Hold::fixed || scene_.contact == Contact::locked) return stop;
    if (scene_.contact == Contact::stick_slip) {
        const double limit = scene_.friction * grain.coupling.mass * h;
        return std::clamp(stop, -limit, limit);
    }
    if (scene_.contact == Contact::spring)
        return -grain.coupling.drag / (scene_.softness * scene_.dt * scene_.dt) * h * (lane.place + 0.5 * h * lane.velocity);
    return grain.clamped ? stop : 0.0;
}

double OneCell::told_to(const Grain& grain, const Told& told) const
{
    return physics::told_acceleration(told.acceleration, grain.told, told.repeated ? 0.0 : grain.share);
}

OneCell::Lane OneCell::advance(const Grain& grain, const Told& told, int substeps, Hold hold) const
{
    const auto& g = grain.coupling;
    const double h = scene_.dt / substeps;
    const double mass = g.mass + g.added_mass;
    const double x = g.drag / substeps / mass;
    const double decay = std::exp(-x);
    const double give = first_exponential(x) / mass;
    const double force = g.volume * told.force + body_force(grain) + grain.owed / scene_.dt;
    const double yield = 1.0 - grain.share, more = (delivery_factor(g, yield) - 1.0) * grain.owed / scene_.dt;
    const double seen = u_ + (told.velocity - u_) * physics::seen_share(g.growth, yield);
    const double drift = (1.0 - decay) * seen + give * h * (force + more + g.added_mass * told_to(grain, told));
    Lane lane{.velocity = grain.velocity, .place = grain.place};
    for (int k = 0; k < substeps; ++k) {
        const double free = decay * lane.velocity + drift;
        const double impulse = contact_impulse(grain, hold, lane, free, give, h);
        lane.place += 0.5 * h * lane.velocity;
        lane.velocity = free + give * impulse;
        lane.place += 0.5 * h * lane.velocity;
        lane.contact += impulse;
    }
    lane.applied = g.mass * (lane.velocity - grain.velocity) - lane.contact;
    lane.exchanged = lane.applied - force * scene_.dt;
    lane.share = physics::contact_share(lane.contact * lane.applied, lane.applied * lane.applied);
    return lane;
}

OneCell::Lane OneCell::predict(const Grain& grain, const Told& told, const Lane& real) const
{
    if (scene_.mode == Mode::coarse) return advance(grain, told, scene_.substeps / coarsening, Hold::scene);
    if (scene_.mode != Mode::concurrent) return real;
    const Lane free = advance(grain, told, 1, Hold::free);
    const Lane held = advance(grain, told, 1, Hold::fixed);
    const double share = grain.share;
    return {.velocity = free.velocity + share * (grain.velocity - free.velocity),
            .exchanged = free.exchanged + share * (held.exchanged - free.exchanged),
            .share = share};
}

OneCell::Pass OneCell::couple(const Told& told, double drive, const Pass* before) const
{
    Pass pass;
    GrainResponse predictor, projection;
    std::vector<GrainResponse> each_predictor, each_projection;
    std::vector<double> untold;
    double exchanged = 0.0, flux = 0.0;
    for (const Grain& grain : grains_) {
        pass.real.push_back(advance(grain, told, scene_.substeps, Hold::scene));
        const Lane known = predict(grain, told, pass.real.back());
        const double hold = before ? changed(before->real[pass.real.size() - 1], known) : known.share;
        const double stiffness = grain.coupling.drag / grain.coupling.mass;
        each_predictor.push_back(response_to_velocity(grain.coupling, physics::predictor_yield(hold)));
        each_projection.push_back(response_to_pressure(grain.coupling, physics::projection_yield(hold, stiffness)));
        add(predictor, each_predictor.back());
        add(projection, each_projection.back());
        untold.push_back(scene_.dt * (told.acceleration - told_to(grain, told)));
        exchanged += known.exchanged + each_predictor.back().added * untold.back();
        flux += grain.coupling.volume * known.velocity;
        pass.mistaken += known.exchanged - pass.real.back().exchanged;
    }
    const double dt = scene_.dt;
    const double advected = u_ + (scene_.motion == Motion::transverse ? drive : 0.0);
    const double miss = told.velocity - u_ - dt * told.acceleration;
    const double du = physics::predicted_change({ledger_, told.force, exchanged, told.velocity, advected, miss}, phi_, phi_, predictor, dt);
    const physics::CellResponse response = cell_response(phi_, phi_, projection, dt);
    double change = 0.0;
    if (scene_.motion == Motion::confined) {
        const double total = phi_ * (told.velocity + du) + flux + physics::predicted_solid_flux(du, miss, predictor);
        change = (scene_.flow(time_ + dt) - total) / response.mobility;
    }
    pass.velocity = told.velocity + du + response.velocity * change;
    pass.force = told.force + change;
    for (std::size_t i = 0; i < grains_.size(); ++i) {
        pass.owed.push_back(physics::owed_impulse({told.force, pass.force, change, du, response.velocity * change, miss + untold[i]},
                                                  grains_[i].coupling.volume, each_predictor[i], each_projection[i], dt));
    }
    return pass;
}

void OneCell::clamp_at_random()
{
    const auto next = [this] {
        random_ = random_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(random_ >> 11) / 9007199254740992.0;
    };
    const bool change = time_ == 0.0 || next() < 1.0 / 3.0;
    for (Grain& grain : grains_) {
        if (change) grain.clamped = next() < 0.5;
    }
}

void OneCell::step()
{
    if (scene_.contact == Contact::random_clamps) clamp_at_random();
    if (scene_.contact == Contact::half_locked) grains_[0].clamped = true;
    const double dt = scene_.dt;
    const double drive = scene_.flow(time_ + dt) - scene_.flow(time_);
    const int passes = scene_.mode == Mode::iterated || time_ == 0.0 ? passes_of_iterated : 1;
    const bool gives_way = scene_.contact == Contact::spring && physics::gives_way(scene_.stiffness * scene_.loading, scene_.softness);
    Told told{u_, acceleration_, force_};
    Pass pass;
    for (int k = 0; k < passes; ++k) {
        const Pass before = pass;
        if (k > 0) told = {pass.velocity, (pass.velocity - u_) / dt, pass.force, true};
        pass = couple(told, drive, k > 0 && gives_way ? &before : nullptr);
    }
    for (std::size_t i = 0; i < grains_.size(); ++i) {
        Grain& grain = grains_[i];
        grain.told = told_to(grain, told);
        grain.velocity = pass.real[i].velocity;
        grain.place = pass.real[i].place;
        grain.share = pass.real[i].share;
        grain.owed = pass.owed[i];
        outside_ += pass.real[i].contact + body_force(grain) * dt;
        moved_ += std::abs(pass.real[i].exchanged) + std::abs(pass.real[i].contact) + std::abs(grain.owed);
    }
    acceleration_ = (pass.velocity - u_) / dt;
    u_ = pass.velocity;
    force_ = pass.force;
    ledger_ = pass.mistaken;
    outside_ += dt * force_ + (scene_.motion == Motion::transverse ? phi_ * drive : 0.0);
    moved_ += dt * std::abs(force_) + std::abs(phi_ * u_);
    time_ += dt;
}

double OneCell::fastest() const
{
    double most = std::abs(u_);
    for (const Grain& grain : grains_) most = std::isfinite(grain.velocity) ? std::max(most, std::abs(grain.velocity)) : 1e300;
    return std::isfinite(most) ? most : 1e300;
}

double OneCell::closure() const
{
    double momentum = phi_ * u_ + ledger_ - outside_;
    for (const Grain& grain : grains_) momentum += grain.coupling.mass * grain.velocity + grain.owed;
    return std::abs(momentum) / std::max(moved_, 1e-300);
}

} // namespace testing
