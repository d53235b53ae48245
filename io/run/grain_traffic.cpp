// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/grain_traffic.hpp"
#include "core/base/error.hpp"
#include "io/build/grid_builder.hpp"
#include "io/files/exact_sums.hpp"
#include "io/run/world_grains.hpp"
#include "io/run/world_walls.hpp"
#include <algorithm>
#include <cstring>

namespace io {
namespace {

constexpr std::int64_t whole_doubles = std::int64_t(1) << 52; // sums stay whole numbers that checkpoints can hold

/// A number for each id so that sums of them tell sets of ids apart: the finaliser of splitmix64, cut to 52 bits.
/// @source  Steele, Lea & Flood (2014), Fast splittable pseudorandom number generators, section 4.
std::int64_t mark_of(std::int64_t id)
{
    auto z = std::uint64_t(id) + 0x9e3779b97f4a7c15U;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return std::int64_t((z ^ (z >> 31)) % std::uint64_t(whole_doubles));
}

/// The values of all ranks, sorted.
template <class T, class Less>
std::vector<T> gathered(const core::Communicator& ranks, const std::vector<T>& mine, Less less)
{
    std::vector<T> all;
    for (const auto& bytes : ranks.gather_all(std::as_bytes(std::span(mine)))) {
        const std::size_t old = all.size();
        all.resize(old + bytes.size() / sizeof(T));
        if (!bytes.empty()) std::memcpy(static_cast<void*>(all.data() + old), bytes.data(), bytes.size());
    }
    std::sort(all.begin(), all.end(), less);
    return all;
}

std::vector<std::int64_t> ids_of(const core::ParticleSet& grains, const core::Communicator& ranks)
{
    return gathered(ranks, std::vector<std::int64_t>(grains.id.begin(), grains.id.begin() + grains.owned), std::less<>());
}

std::string list_of(const std::vector<std::int64_t>& ids)
{
    constexpr std::size_t most = 10;
    std::string text;
    for (std::size_t n = 0; n < std::min(most, ids.size()); ++n) text += core::text(n > 0 ? ", " : "", ids[n]);
    return ids.size() > most ? core::text(text, " and ", ids.size() - most, " more") : text;
}

physics::Inflow inflow_of(const Species& species, std::int32_t number, const core::Domain& domain)
{
    const InflowKeys& keys = *species.inflow;
    physics::Inflow inflow;
    inflow.like.density = species.density;
    inflow.like.velocity = keys.velocity;
    inflow.like.species = number;
    inflow.sizes =
        species.sizes ? species.sizes->distribution() : physics::listed_sizes({{*species.diameter, 1.0}}, physics::ShareOf::number);
    inflow.region = keys.region.region(domain);
    inflow.measure = keys.rate ? physics::Inflow::Measure::number : physics::Inflow::Measure::mass;
    inflow.rate = keys.rate ? *keys.rate : *keys.mass_rate;
    inflow.begin = keys.begin;
    if (keys.end) inflow.end = *keys.end;
    return inflow;
}

/// A sphere as it goes round the ranks.
struct Near {
    std::int64_t id;
    std::array<double, 3> position;
    double radius;
};

} // namespace

GrainTraffic::GrainTraffic(const Scene& scene, const core::Domain& domain, std::int64_t grains)
    : domain_(domain), walls_(walls_at_start(scene, domain)), seed_(std::uint64_t(scene.run.random_seed))
{
    for (std::size_t n = 0; n < scene.particles.size(); ++n)
        if (scene.particles[n].inflow) {
            inflows_.push_back(inflow_of(scene.particles[n], std::int32_t(n), domain));
            inflow_names_.push_back(scene.particles[n].name);
        }
    for (const Outlet& outlet : scene.outlets) {
        outlets_.push_back(outlet.region.region(domain));
        outlet_names_.push_back(outlet.name);
    }
    state_.next_id = state_.count = grains;
    for (std::int64_t id = 0; id < grains; ++id) state_.marks = (state_.marks + mark_of(id)) % whole_doubles;
    state_.entered.resize(inflows_.size());
    state_.taken.resize(outlets_.size());
}

void GrainTraffic::check(const core::ParticleSet& grains, const core::ParticleSet& before, const core::Communicator& ranks) const
{
    std::array<std::int64_t, 2> here{grains.owned, 0};
    for (int i = 0; i < grains.owned; ++i) here[1] = (here[1] + mark_of(grains.id[std::size_t(i)])) % whole_doubles;
    ranks.sum(here);
    if (here[0] == state_.count && here[1] % whole_doubles == state_.marks) return;
    const auto now = ids_of(grains, ranks), then = ids_of(before, ranks);
    std::vector<std::int64_t> lost, more;
    std::set_difference(then.begin(), then.end(), now.begin(), now.end(), std::back_inserter(lost));
    std::set_difference(now.begin(), now.end(), then.begin(), then.end(), std::back_inserter(more));
    throw core::NumericsError(core::text(here[0], " particles are here instead of ", state_.count,
                                         lost.empty() ? "" : "; lost since the step before: ", list_of(lost),
                                         more.empty() ? "" : "; not here before: ", list_of(more)));
}

bool GrainTraffic::pass(double time, const physics::OwnerOf& owner_of, physics::ParticleDynamics& dynamics, const core::Communicator& ranks)
{
    const bool went = !outlets_.empty() && take_away(dynamics, ranks);
    const bool came = !inflows_.empty() && let_in(time, owner_of, dynamics, ranks);
    return went || came;
}

bool GrainTraffic::take_away(physics::ParticleDynamics& dynamics, const core::Communicator& ranks)
{
    core::ParticleSet& p = dynamics.particles;
    std::vector<int> stay;
    std::vector<std::vector<double>> masses(outlets_.size());
    std::vector<std::int64_t> counts(outlets_.size() + 1, 0);
    for (int i = 0; i < p.owned; ++i) {
        std::size_t outlet = 0;
        while (outlet < outlets_.size() && !physics::contains(outlets_[outlet], p.position_of(i))) ++outlet;
        if (outlet == outlets_.size()) {
            stay.push_back(i);
            continue;
        }
        masses[outlet].push_back(p.mass[std::size_t(i)]);
        ++counts[outlet];
        counts.back() = (counts.back() + mark_of(p.id[std::size_t(i)])) % whole_doubles;
    }
    if (int(stay.size()) < p.owned) {
        p.reorder(stay);
        dynamics.history.reorder(stay);
    }
    ranks.sum(counts);
    if (std::all_of(counts.begin(), counts.end() - 1, [](auto c) { return c == 0; })) return false;
    const auto sums = exact_sums(ranks, masses);
    for (std::size_t n = 0; n < outlets_.size(); ++n) {
        state_.taken[n].count += counts[n];
        state_.taken[n].mass += sums[n];
        state_.count -= counts[n];
    }
    state_.marks = (state_.marks + whole_doubles - counts.back() % whole_doubles) % whole_doubles;
    return true;
}

bool GrainTraffic::let_in(double time, const physics::OwnerOf& owner_of, physics::ParticleDynamics& dynamics,
                          const core::Communicator& ranks)
{
    const std::int64_t next = state_.next_id;
    dynamics.place_surfaces(time);
    const physics::Obstacles obstacles = obstacles_of(walls_, dynamics);
    for (std::size_t n = 0; n < inflows_.size(); ++n) {
        const core::ParticleSet& p = dynamics.particles;
        std::vector<Near> mine;
        for (int i = 0; i < p.owned; ++i) {
            const core::Vec3 x = p.position_of(i);
            const double radius = p.radius[std::size_t(i)];
            if (physics::may_meet(inflows_[n], domain_, x, radius)) mine.push_back({p.id[std::size_t(i)], {x[0], x[1], x[2]}, radius});
        }
        std::vector<core::Sphere> near;
        for (const Near& s : gathered(ranks, mine, [](const Near&a, const Near&b) { return a.id < b.id; })) {
            core::Sphere& sphere = near.emplace_back();
            sphere.position = {s.position[0], s.position[1], s.position[2]};
            sphere.radius = s.radius;
        }
        const std::int64_t first = state_.next_id;
        const auto all = physics::entering(inflows_[n], time, domain_, obstacles, seed_, near, state_.next_id, state_.entered[n]);
        state_.count += state_.next_id - first;
        for (const core::Sphere& s : all) state_.marks = (state_.marks + mark_of(s.id)) % whole_doubles;
        add_grains(all, owner_of, ranks.rank(), dynamics);
    }
    return state_.next_id != next;
}

} // namespace io
