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

void sort_unique(std::vector<std::int64_t>& values)
{
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// Whose neighbours are looked for in a bin of a level: those of its own particles, or those of smaller ones.
enum class Around { own, smaller };

/// A number for a bin of a level and what it is wanted for.
std::int64_t mark_of(std::int64_t key, int level, Around around) { return (key * radius_octaves + level) * 2 + std::int64_t(around); }

/// Adds the marks of the bins `occupied` and of all around them.
void add_marks(const BinLattice& lattice, std::vector<std::int64_t> occupied, int level, Around around, std::vector<std::int64_t>& marks)
{
    sort_unique(occupied);
    for (const auto key : occupied) {
        const Bin home = lattice.from_key(key);
        for (int step = 0; step < 27; ++step) {
            Bin b{home[0] + step % 3 - 1, home[1] + step / 3 % 3 - 1, home[2] + step / 9 - 1};
            bool inside = true;
            for (std::size_t a = 0; a < 3; ++a) {
                if (lattice.periodic[a]) b[a] = (b[a] + lattice.count[a]) % lattice.count[a];
                inside = inside && b[a] >= 0 && b[a] < lattice.count[a];
            }
            if (inside) marks.push_back(mark_of(lattice.key(b), level, around));
        }
    }
}

} // namespace

std::vector<std::int64_t> bins_of_interest(const ParticleSet& particles, const LevelBins& bins)
{
    const int levels = bins.sizes.count();
    std::vector<std::int64_t> marks;
    for (int level = 0; level < levels; ++level) {
        const BinLattice& lattice = bins.lattice[std::size_t(level)];
        std::vector<std::int64_t> own, smaller;
        for (int i = 0; i < particles.owned; ++i) {
            const int here = bins.sizes.level_of(particles.radius[std::size_t(i)]);
            if (here >= level) (here == level ? own : smaller).push_back(lattice.key(lattice.bin(particles.position_of(i))));
        }
        add_marks(lattice, std::move(own), level, Around::own, marks);
        add_marks(lattice, std::move(smaller), level, Around::smaller, marks);
    }
    sort_unique(marks);
    return marks;
}

void Ghosts::choose(const ParticleSet& particles, const LevelBins& bins, const std::vector<std::vector<std::int64_t>>& wanted)
{
    chosen_.assign(wanted.size(), {});
    std::vector<std::int64_t> marks;
    for (int i = 0; i < particles.owned; ++i) {
        const int own = bins.sizes.level_of(particles.radius[std::size_t(i)]);
        marks.clear();
        for (int level = 0; level <= own; ++level) {
            const BinLattice& lattice = bins.lattice[std::size_t(level)];
            const auto key = lattice.key(lattice.bin(particles.position_of(i)));
            marks.push_back(mark_of(key, level, Around::own));
            if (level == own && own + 1 < bins.sizes.count()) marks.push_back(mark_of(key, level, Around::smaller));
        }
        for (std::size_t r = 0; r < wanted.size(); ++r)
            if (std::any_of(marks.begin(), marks.end(), [&](auto m) { return std::binary_search(wanted[r].begin(), wanted[r].end(), m); }))
                chosen_[r].push_back(i);
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
