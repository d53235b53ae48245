// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/dynamics.hpp"
#include "core/base/error.hpp"
#include "core/base/renew.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

namespace physics {
namespace {

constexpr auto index_of(int i) { return std::size_t(i); }

// measured in a pipe of 16,000 kicked spheres: a flat optimum, 0.2-0.5 and 0.02-0.06 differ by less than 20 %
constexpr double usual_skin = 0.33; ///< Over the greatest radius.
constexpr double usual_near_skin = 0.03;

// in a sub-step, over the smallest radius: contacts of 30 sub-steps reach no deeper than 1.5 radii, and 2 would be through
constexpr double longest_move = 0.15;

int chunk_count(const core::ParticleSet& particles)
{
    return (particles.owned + core::particles_per_chunk - 1) / core::particles_per_chunk;
}

/// Greatest radius of the octave with which a tenth of all particles is counted, the smallest first: a few much smaller ones do not
/// decide. 1 m without particles: nothing is ever near.
double small_radius(const core::Octaves& greatest, const core::Octaves& count)
{
    constexpr double share = 0.1;
    const double all = std::accumulate(count.begin(), count.end(), 0.0);
    double sum = 0.0;
    for (std::size_t octave = 0; octave < count.size(); ++octave)
        if (sum += count[octave]; sum > 0.0 && sum >= share * all) return greatest[octave];
    return 1.0;
}

} // namespace

ParticleDynamics::ParticleDynamics(const core::Domain& domain, const ParticleParameters& parameters, std::vector<Wall> walls, double step)
    : domain_(domain),
      parameters_(parameters),
      step_(step),
      pair_laws_(pair_laws(parameters, step)),
      wall_laws_(wall_laws(parameters, step)),
      walls_(std::move(walls), kinds_of(wall_laws_, parameters.wall_materials * parameters.species), parameters.species),
      shifts_(core::image_shifts(domain))
{
    near_.species_count = parameters.species;
    near_.kinds = kinds_of(pair_laws_, parameters.species * parameters.species);
    near_.kind_count = 1 + *std::max_element(near_.kinds.begin(), near_.kinds.end());
    if (parameters.energy_budget == Budget::kept) energy_ = add_energy_columns(particles);
    if (resist_turning(pair_laws_) || resist_turning(wall_laws_)) history.width = core::rolling_memory;
}

/// The reach of the lists beyond touching. Lists are made anew when a particle has gone half of it, and the small ones are the fastest to
/// change their neighbours: theirs is the radius that counts.
void ParticleDynamics::set_reach(double radius)
{
    skin_ = parameters_.skin > 0 ? parameters_.skin : usual_skin * radius;
    near_skin_ = parameters_.near_skin > 0 ? std::min(parameters_.near_skin, skin_) : usual_near_skin * radius;
}

double ParticleDynamics::start(const core::Team& team) { return drift_all(particles, 0.5 * step_, team); }

double ParticleDynamics::longest_step(double speed2) const { return longest_move * least_radius_ / std::sqrt(std::max(speed2, 1e-300)); }

void ParticleDynamics::account(double speed2, double time)
{
    const double way = 1.000001 * std::sqrt(speed2) * time; // rounding of the positions
    travelled_ += way;
    near_travelled_ += way;
}

double ParticleDynamics::displacement(const core::Team& team) const
{
    constexpr double rounding = std::numeric_limits<float>::epsilon();
    if (!built_) return std::numeric_limits<double>::infinity();
    std::vector<double> greatest(index_of(chunk_count(particles)), 0.0);
    team.run(int(greatest.size()), [&](int c) {
        const int begin = c * core::particles_per_chunk, end = std::min(particles.owned, begin + core::particles_per_chunk);
        for (auto i = index_of(begin); i < index_of(end); ++i) {
            double square = 0.0, at = 0.0;
            for (std::size_t a = 0; a < 3; ++a) {
                const double then = reference_[a][i], d = particles.position[a][i] - extent_.low[int(a)] - then;
                square += d * d;
                at += std::abs(then);
            }
            greatest[index_of(c)] = std::max(greatest[index_of(c)], std::sqrt(square) + rounding * at);
        }
    });
    return greatest.empty() ? 0.0 : *std::max_element(greatest.begin(), greatest.end());
}

bool ParticleDynamics::keep_lists(double greatest_displacement)
{
    if (!built_ || 2.0 * (greatest_displacement + wall_way_) >= 0.8 * skin_) return false;
    travelled_ = greatest_displacement;
    return true;
}

void ParticleDynamics::dissolve(const core::Team& team)
{
    if (near_built_) {
        walls_.return_springs();
        near_.list_pairs(pairs_, team);
        history.clear();
        for (int i = 0; i < particles.owned; ++i) {
            near_.append_row(particles, pairs_, i, history);
            walls_.append_row(i, history);
            for (const SurfaceContacts& surface : surfaces_) surface.append_row(i, history);
            history.end_row();
        }
        near_.release();
    }
    particles.resize_ghosts(0);
    while (history.rows() < particles.owned) history.end_row(); // particles that were added without a history
    built_ = near_built_ = false;
    for (int a = 0; a < 3; ++a)
        if (domain_.periodic[index_of(a)])
            for (int i = 0; i < particles.owned; ++i) {
                double& x = particles.position[index_of(a)][index_of(i)];
                x = domain_.wrapped(a, x);
            }
}

void ParticleDynamics::set_step(double step)
{
    step_ = step;
    pair_laws_ = pair_laws(parameters_, step);
    wall_laws_ = wall_laws(parameters_, step);
}

void ParticleDynamics::forget_lists()
{
    particles.resize_ghosts(0);
    built_ = near_built_ = false;
}

core::Bounds ParticleDynamics::bounds() const
{
    core::Bounds b;
    for (int i = 0; i < particles.owned; ++i) {
        b.low = b.low.cwiseMin(particles.position_of(i));
        b.high = b.high.cwiseMax(particles.position_of(i));
    }
    return b;
}

void ParticleDynamics::sort(const core::Bounds& bounds, const core::Octaves& greatest, const core::Octaves& count)
{
    const double radius = small_radius(greatest, count);
    set_reach(radius);
    const core::Vec3 around = core::Vec3::Constant(*std::max_element(greatest.begin(), greatest.end()) + reach(skin_));
    extent_ = {bounds.low - around, bounds.high + around};
    const auto smallest = std::find_if(greatest.begin(), greatest.end(), [](double r) { return r > 0.0; });
    const auto all = std::int64_t(std::accumulate(count.begin(), count.end(), 0.0));
    const bool can_meet = all > 1 || !walls_.empty() || !surfaces_.empty();
    least_radius_ = smallest == greatest.end() || !can_meet ? std::numeric_limits<double>::infinity() : *smallest;
    const core::SizeLevels sizes(greatest);
    bins_ = core::make_level_bins(domain_, bounds, sizes, reach(skin_), all);
    const auto order = core::order_by_bin(particles, bins_.lattice[std::size_t(sizes.level_of(radius))]);
    particles.reorder(order);
    history.reorder(order);
}

void ParticleDynamics::build(const core::Team& team)
{
    core::CellLists cells;
    cells.build(particles, bins_);
    pairs_.build(particles, cells, reach(skin_), team);
    walls_.build(particles, reach(0.5 * skin_), history); // half: what walls do themselves is in wall_way_
    for (SurfaceContacts& surface : surfaces_) surface.build(particles, reach(0.5 * skin_), reach(0.5 * near_skin_), history);
    for (std::size_t a = 0; a < 3; ++a) {
        core::renew(reference_[a], index_of(particles.owned));
        for (std::size_t i = 0; i < index_of(particles.owned); ++i)
            reference_[a][i] = float(particles.position[a][i] - extent_.low[int(a)]);
    }
    built_ = true;
    near_built_ = false;
    travelled_ = wall_way_ = 0.0;
    planned_threads_ = 0;
}

void ParticleDynamics::refresh_near(const core::Team& team)
{
    core::NearPairs::Choice choice{particles, pairs_, shifts_, reach(near_skin_), slots_};
    if (near_built_) {
        walls_.return_springs();
        near_.refresh(choice, team);
    } else {
        near_.start(choice, history, team);
        history.release();
    }
    walls_.refresh(particles, reach(0.5 * near_skin_), team);
    for (SurfaceContacts& surface : surfaces_) surface.refresh(particles, team);
    near_built_ = true;
    near_travelled_ = near_wall_way_ = 0.0;
}

void ParticleDynamics::measure_watched(const core::Team& team)
{
    if (!contact_columns_) return;
    if (near_built_) measure_contacts(particles, pairs_, near_, shifts_, forces_, *contact_columns_, team);
    else measure_no_contacts(particles, *contact_columns_);
}

void ParticleDynamics::plan_chunks(int threads)
{
    const int chunks = chunk_count(particles), count = std::clamp(threads, 1, std::max(1, chunks));
    chunks_.segments.clear();
    for (int s = 0; s <= count; ++s) chunks_.segments.push_back(int(std::int64_t(chunks) * s / count));
    chunks_.deferred.assign(index_of(chunks), 0);
    for (int s = 0; s < count; ++s)
        for (int c = chunks_.segments[index_of(s)]; c < chunks_.segments[index_of(s) + 1]; ++c)
            for (const int later : pairs_.links[index_of(c)])
                if (later >= chunks_.segments[index_of(s) + 1]) chunks_.deferred[index_of(later)] = 1;
    planned_threads_ = threads;
    if (contact_columns_) slots_.keep_all(pairs_);
    else slots_.plan(pairs_, chunks_);
    records_.plan(particles, pairs_, chunks_);
    forces_.resize(index_of(slots_.count), pair_laws_, parameters_.energy_budget);
    std::vector<WallLoad> so_far = loads();
    so_far.resize(index_of(count * reports_));
    loads_ = std::move(so_far);
}

void ParticleDynamics::sum_chunk(int segment, int chunk, ForceSums& sums, const Account& account)
{
    const WallLoads loads = WallLoads(loads_).subspan(index_of(segment * reports_), index_of(reports_));
    sums.begin = chunk * core::particles_per_chunk;
    sums.end = std::min(particles.owned, sums.begin + core::particles_per_chunk);
    sum_pair_forces(pairs_, near_, forces_, sums);
    if (!forces_.couples.empty()) add_pair_couples(pairs_, near_, forces_, sums);
    if (account.energy) begin_budget(particles, pairs_, near_, forces_, sums, *account.energy);
    const WallSums walls{sums, loads, account.energy, account.shares};
    if (!walls_.empty()) walls_.add_forces(records_.seen_by(segment), wall_laws_, chunk, walls);
    for (SurfaceContacts& surface : surfaces_) surface.add_forces(particles, wall_laws_, chunk, walls);
}

/// A particle may move as soon as all its pairs are done. The pairs of chunks 0..c are all the pairs of their particles, so
/// one thread moves each chunk right after its pairs, while they are in its cache; chunks that meet pairs of an earlier segment wait.
template <class M>
double ParticleDynamics::advance_as(const M& motion, const core::Team& team, const DriftTimes& times)
{
    const int segments = int(chunks_.segments.size()) - 1;
    std::vector<double> greatest(index_of(segments), 0.0);
    const auto move = [&](int s, int c) {
        ForceSums sums;
        std::optional<EnergySums> energy;
        std::optional<WallShares> shares;
        if (energy_.kept()) energy.emplace();
        if (contact_columns_ && times.second_half == 0.0) shares.emplace(); // the last of the batch
        sum_chunk(s, c, sums, {energy ? &*energy : nullptr, shares ? &*shares : nullptr});
        if (shares) measure_walls(particles, *shares, sums.begin, sums.end, *contact_columns_);
        greatest[index_of(s)] = std::max(greatest[index_of(s)], move_chunk(particles, sums, motion, times));
        if (energy) finish_budget(particles, energy_, sums, *energy, times.step);
    };
    team.run(segments, [&](int s) {
        const PairScene scene{particles, records_.seen_by(s), pairs_, slots_, shifts_, pair_laws_, parameters_.seed};
        for (int c = chunks_.segments[index_of(s)]; c < chunks_.segments[index_of(s) + 1]; ++c) {
            records_.enter(particles, s, c);
            pair_forces(scene, near_, c, forces_);
            if (!chunks_.deferred[index_of(c)]) move(s, c);
        }
    });
    if (segments > 1)
        team.run(segments, [&](int s) {
            for (int c = chunks_.segments[index_of(s)]; c < chunks_.segments[index_of(s) + 1]; ++c)
                if (chunks_.deferred[index_of(c)]) {
                    if (!walls_.empty()) records_.copy(particles, s, c);
                    move(s, c);
                }
        });
    return *std::max_element(greatest.begin(), greatest.end());
}

double ParticleDynamics::advance(const Motion& motion, const core::Team& team, int sub_step, int sub_steps)
{
    ++load_steps_;
    if (particles.owned == 0) return 0.0;
    const bool planned = planned_threads_ == team.threads();
    if (!planned) plan_chunks(team.threads());
    if (!planned || !near_built_ || 2.0 * (near_travelled_ + near_wall_way_) >= near_skin_) refresh_near(team);
    const double half = 0.5 * step_;
    const DriftTimes times{step_, half, sub_step + 1 < sub_steps ? half : 0.0};
    return std::visit([&](const auto& m) { return advance_as(m, team, times); }, motion);
}

} // namespace physics
