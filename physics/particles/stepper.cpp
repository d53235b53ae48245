// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/stepper.hpp"
#include "core/base/error.hpp"
#include "core/particles/migration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace physics {
namespace {

/// Greatest radius and number of the owned particles in each octave.
void count_sizes(const core::ParticleSet& particles, std::span<double> greatest, core::Octaves& count)
{
    std::fill(greatest.begin(), greatest.end(), 0.0);
    count.fill(0.0);
    for (int i = 0; i < particles.owned; ++i) {
        const double radius = particles.radius[std::size_t(i)];
        const auto octave = std::size_t(core::octave_of(radius));
        greatest[octave] = std::max(greatest[octave], radius);
        count[octave] += 1.0;
    }
}

} // namespace

ParticleStepper::ParticleStepper(ParticleDynamics& dynamics, OwnerOf owner_of, int rank, int ranks)
    : dynamics_(dynamics), owner_of_(std::move(owner_of)), rank_(rank), ranks_(ranks)
{
}

ParticleStepper::ParticleStepper(ParticleDynamics& dynamics, const ParticleStepper& like)
    : ParticleStepper(dynamics, like.owner_of_, like.rank_, like.ranks_)
{
}

void ParticleStepper::begin(const Motion& motion, int sub_steps, std::optional<double> time)
{
    dynamics_.begin(time);
    motion_ = motion;
    sub_steps_ = sub_steps;
    sub_step_ = -1;
    wait_ = Wait::nothing;
}

void ParticleStepper::hand_over() { handing_over_ = true; }

void ParticleStepper::give_up()
{
    dynamics_.forget_lists();
    have_ghosts_ = handing_over_ = false;
    sub_steps_ = 0;
    wait_ = Wait::nothing;
}

bool ParticleStepper::work(const core::Team& team)
{
    switch (wait_) {
    case Wait::nothing: // first half drift of the batch
        if (handing_over_) {
            have_ghosts_ = handing_over_ = false;
            dynamics_.measure_watched(team);
            dynamics_.dissolve(team);
            pack_leavers();
            wait_ = Wait::leaver_lengths;
            return true;
        }
        if (sub_steps_ == 0) return false;
        shared_[0] = dynamics_.start(team);
        time_ = 0.5 * dynamics_.step();
        sub_step_ = 0;
        wait_ = Wait::speeds;
        return true;
    case Wait::speeds: after_speeds(team); break;
    case Wait::displacement:
        if (dynamics_.keep_lists(shared_[0])) sub_step(team);
        else start_rebuild(team);
        break;
    case Wait::extent: wait_ = Wait::migrants; break;
    case Wait::migrants: sort_particles(team); break;
    case Wait::bin_lengths: wait_ = Wait::bins; break;
    case Wait::bins: choose_ghosts(); break;
    case Wait::ghost_lengths: wait_ = Wait::ghosts; break;
    case Wait::ghosts:
        ghosts_.adopt(exchange_.incoming, dynamics_.particles);
        have_ghosts_ = true;
        dynamics_.build(team);
        sub_step(team);
        break;
    case Wait::leaver_lengths: wait_ = Wait::leavers; break;
    case Wait::leavers:
        take_arrivals();
        wait_ = Wait::nothing;
        break;
    }
    return wait_ != Wait::nothing;
}

void ParticleStepper::after_speeds(const core::Team& team)
{
    core::require<core::NumericsError>(std::isfinite(shared_[0]),
                                       core::text("a particle has no finite speed in sub-step ", sub_step_, ": make the step smaller"));
    core::require<core::NumericsError>(
        dynamics_.step() <= dynamics_.longest_step(shared_[0]),
        core::text("a particle with ", std::sqrt(shared_[0]), " m/s would pass through others in a sub-step of ", dynamics_.step(),
                   " s: contacts are too soft, or their sub-steps longer than ", dynamics_.longest_step(shared_[0]), " s"));
    dynamics_.account(shared_[0], time_);
    if (have_ghosts_) {
        ghosts_.take_motion(dynamics_.particles);
        dynamics_.ghosts_moved();
    }
    if (sub_step_ == sub_steps_) {
        sub_steps_ = 0;
        wait_ = Wait::nothing;
        return;
    }
    dynamics_.move_walls(sub_step_);
    if (dynamics_.needs_check()) {
        shared_[0] = dynamics_.displacement(team);
        wait_ = Wait::displacement;
    } else sub_step(team);
}

void ParticleStepper::sub_step(const core::Team& team)
{
    shared_[0] = dynamics_.advance(motion_, team, sub_step_, sub_steps_);
    time_ = dynamics_.step();
    ++sub_step_;
    wait_ = Wait::speeds;
}

/// Migrants leave; meanwhile the ranks learn the extent of all particles.
void ParticleStepper::start_rebuild(const core::Team& team)
{
    have_ghosts_ = false;
    dynamics_.dissolve(team);
    const auto& particles = dynamics_.particles;
    const auto bounds = dynamics_.bounds();
    for (int a = 0; a < 3; ++a) {
        shared_[std::size_t(a)] = -bounds.low[a];
        shared_[std::size_t(3 + a)] = bounds.high[a];
    }
    count_sizes(particles, std::span(shared_).subspan(6), count_);
    pack_leavers();
    wait_ = Wait::extent;
}

/// Particles that other ranks own are packed for them. @pre dissolved
void ParticleStepper::pack_leavers()
{
    auto& particles = dynamics_.particles;
    exchange_.start(ranks_);
    std::vector<int> stay;
    for (int i = 0; i < particles.owned; ++i) {
        const int owner = ranks_ == 1 ? 0 : owner_of_(particles.position_of(i));
        if (owner == rank_) stay.push_back(i);
        else core::pack_particle(particles, dynamics_.history, i, exchange_.outgoing.at(std::size_t(owner)));
    }
    if (int(stay.size()) < particles.owned) {
        particles.reorder(stay);
        dynamics_.history.reorder(stay);
    }
}

void ParticleStepper::take_arrivals()
{
    for (const auto& bytes : exchange_.incoming) core::unpack_particles(bytes, dynamics_.particles, dynamics_.history);
}

void ParticleStepper::sort_particles(const core::Team&)
{
    auto& particles = dynamics_.particles;
    take_arrivals();
    const core::Bounds bounds{-core::Vec3(shared_[0], shared_[1], shared_[2]), core::Vec3(shared_[3], shared_[4], shared_[5])};
    core::Octaves greatest;
    std::copy(shared_.begin() + 6, shared_.end(), greatest.begin());
    dynamics_.sort(bounds, greatest, count_);
    exchange_.start(ranks_);
    if (ranks_ > 1) {
        const auto bins = core::bins_of_interest(particles, dynamics_.bins());
        for (int r = 0; r < ranks_; ++r)
            if (r != rank_) core::write_bytes(exchange_.outgoing[std::size_t(r)], std::span<const std::int64_t>(bins));
    }
    wait_ = Wait::bin_lengths;
}

void ParticleStepper::choose_ghosts()
{
    std::vector<std::vector<std::int64_t>> wanted(std::size_t(ranks_), std::vector<std::int64_t>{});
    for (int r = 0; r < ranks_; ++r)
        for (core::ByteReader reader(exchange_.incoming[std::size_t(r)]); !reader.empty();)
            wanted[std::size_t(r)].push_back(reader.read<std::int64_t>());
    ghosts_.choose(dynamics_.particles, dynamics_.bins(), wanted);
    exchange_.start(ranks_);
    for (int r = 0; r < ranks_; ++r) exchange_.outgoing[std::size_t(r)] = ghosts_.describe(dynamics_.particles, r);
    wait_ = Wait::ghost_lengths;
}

void ParticleStepper::post(const core::Communicator& communicator, core::Pending& pending)
{
    if (ranks_ == 1) return;
    switch (wait_) {
    case Wait::speeds:
        communicator.start_max(std::span(shared_).first(1), pending);
        if (have_ghosts_) ghosts_.post_motion(dynamics_.particles, communicator, pending);
        break;
    case Wait::displacement: communicator.start_max(std::span(shared_).first(1), pending); break;
    case Wait::extent:
        communicator.start_max(shared_, pending);
        communicator.start_sum(count_, pending);
        exchange_.post_lengths(communicator, pending);
        break;
    case Wait::bin_lengths:
    case Wait::leaver_lengths:
    case Wait::ghost_lengths: exchange_.post_lengths(communicator, pending); break;
    case Wait::migrants:
    case Wait::bins:
    case Wait::leavers:
    case Wait::ghosts: exchange_.post_data(communicator, pending); break;
    case Wait::nothing: break;
    }
}

} // namespace physics
