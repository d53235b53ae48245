// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/particles/ghosts.hpp"
#include "core/particles/exchange.hpp"

#include <algorithm>
#include <numeric>

namespace core {
namespace {

constexpr int motion_tag = 103;
constexpr std::size_t motion_values = 9;

/// Calls visit(value) for position, velocity and spin of particle i.
template <class Set, class Visit>
void for_each_motion(Set& particles, std::size_t i, Visit visit)
{
    for (auto* triple : {&particles.position, &particles.velocity, &particles.spin})
        for (auto& column : *triple) visit(column[i]);
}

} // namespace

std::vector<std::int64_t> bins_of_interest(const ParticleSet& particles, const BinLattice& lattice)
{
    std::vector<std::int64_t> occupied;
    for (int i = 0; i < particles.owned; ++i) occupied.push_back(lattice.key(lattice.bin(particles.position_of(i))));
    std::sort(occupied.begin(), occupied.end());
    occupied.erase(std::unique(occupied.begin(), occupied.end()), occupied.end());
    std::vector<std::int64_t> keys;
    for (const auto key : occupied) {
        const Bin home = lattice.from_key(key);
        for (int step = 0; step < 27; ++step) {
            Bin b{home[0] + step % 3 - 1, home[1] + step / 3 % 3 - 1, home[2] + step / 9 - 1};
            bool inside = true;
            for (std::size_t a = 0; a < 3; ++a) {
                if (lattice.periodic[a]) b[a] = (b[a] + lattice.count[a]) % lattice.count[a];
                inside = inside && b[a] >= 0 && b[a] < lattice.count[a];
            }
            if (inside) keys.push_back(lattice.key(b));
        }
    }
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    return keys;
}

void Ghosts::choose(const ParticleSet& particles, const BinLattice& lattice, const std::vector<std::vector<std::int64_t>>& wanted)
{
    chosen_.assign(wanted.size(), {});
    for (int i = 0; i < particles.owned; ++i) {
        const auto key = lattice.key(lattice.bin(particles.position_of(i)));
        for (std::size_t r = 0; r < wanted.size(); ++r)
            if (std::binary_search(wanted[r].begin(), wanted[r].end(), key)) chosen_[r].push_back(i);
    }
}

std::vector<std::byte> Ghosts::describe(const ParticleSet& particles, int rank) const
{
    std::vector<std::byte> bytes;
    for (const int chosen : chosen_[std::size_t(rank)]) {
        const auto i = std::size_t(chosen);
        write_bytes(bytes, particles.id[i]);
        write_bytes(bytes, particles.species[i]);
        for (const auto* column : {&particles.radius, &particles.mass, &particles.inertia}) write_bytes(bytes, (*column)[i]);
        for_each_motion(particles, i, [&](const double& value) { write_bytes(bytes, value); });
    }
    return bytes;
}

void Ghosts::adopt(const std::vector<std::vector<std::byte>>& descriptions, ParticleSet& particles)
{
    constexpr auto each = sizeof(std::int64_t) + sizeof(std::int32_t) + (3 + motion_values) * sizeof(double);
    count_.clear();
    for (const auto& bytes : descriptions) count_.push_back(int(bytes.size() / each));
    particles.resize_ghosts(std::accumulate(count_.begin(), count_.end(), 0));
    auto i = std::size_t(particles.owned);
    for (const auto& bytes : descriptions)
        for (ByteReader reader(bytes); !reader.empty(); ++i) {
            particles.id[i] = reader.read<std::int64_t>();
            particles.species[i] = reader.read<std::int32_t>();
            for (auto* column : {&particles.radius, &particles.mass, &particles.inertia}) (*column)[i] = reader.read<double>();
            for_each_motion(particles, i, [&](double& value) { value = reader.read<double>(); });
        }
}

void Ghosts::post_motion(const ParticleSet& particles, const Communicator& communicator, Pending& pending)
{
    const auto ranks = chosen_.size();
    out_.resize(ranks);
    in_.resize(ranks);
    for (std::size_t r = 0; r < ranks; ++r) {
        in_[r].resize(motion_values * std::size_t(count_[r]));
        if (!in_[r].empty()) communicator.receive(std::as_writable_bytes(std::span(in_[r])), int(r), motion_tag, pending);
        out_[r].clear();
        for (const int i : chosen_[r]) for_each_motion(particles, std::size_t(i), [&](const double& value) { out_[r].push_back(value); });
        if (!out_[r].empty()) communicator.send(std::as_bytes(std::span<const double>(out_[r])), int(r), motion_tag, pending);
    }
}

void Ghosts::take_motion(ParticleSet& particles) const
{
    auto i = std::size_t(particles.owned);
    for (const auto& values : in_)
        for (auto next = values.begin(); next != values.end(); ++i) for_each_motion(particles, i, [&](double& value) { value = *next++; });
}

} // namespace core
