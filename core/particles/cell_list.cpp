// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/particles/cell_list.hpp"

#include <algorithm>
#include <numeric>

namespace core {
namespace {

/// Counting sort of the particles `members`: start[b] is the first entry of bin b, order the particles of all bins.
void sort_by_bin(const ParticleSet& particles, const BinLattice& lattice, const std::vector<int>& members, std::vector<int>& start,
                 std::vector<int>& order)
{
    std::vector<std::int64_t> keys(members.size(), 0);
    start.assign(std::size_t(lattice.bins()) + 1, 0);
    for (std::size_t n = 0; n < members.size(); ++n) {
        keys[n] = lattice.key(lattice.bin(particles.position_of(members[n])));
        ++start[std::size_t(keys[n]) + 1];
    }
    for (std::size_t b = 1; b < start.size(); ++b) start[b] += start[b - 1];
    std::vector<int> next(start.begin(), start.end() - 1);
    order.resize(members.size());
    for (std::size_t n = 0; n < members.size(); ++n) order[std::size_t(next[std::size_t(keys[n])]++)] = members[n];
}

} // namespace

std::vector<int> order_by_bin(const ParticleSet& particles, const BinLattice& lattice)
{
    std::vector<int> start, order;
    std::vector<int> owned(std::size_t(particles.owned));
    std::iota(owned.begin(), owned.end(), 0);
    sort_by_bin(particles, lattice, owned, start, order);
    const auto by_id = [&](int a, int b) { return particles.id[std::size_t(a)] < particles.id[std::size_t(b)]; };
    for (std::size_t b = 0; b + 1 < start.size(); ++b) std::sort(order.begin() + start[b], order.begin() + start[b + 1], by_id);
    return order;
}

void CellLists::build(const ParticleSet& particles, const LevelBins& bins)
{
    sizes_ = bins.sizes;
    level_.resize(bins.lattice.size());
    members_.resize(bins.lattice.size());
    for (auto& members : members_) members.clear();
    for (int i = 0; i < particles.size(); ++i) members_[std::size_t(sizes_.level_of(particles.radius[std::size_t(i)]))].push_back(i);
    for (std::size_t level = 0; level < level_.size(); ++level) level_[level].build(particles, bins.lattice[level], members_[level]);
}

void CellList::build(const ParticleSet& particles, const BinLattice& lattice, const std::vector<int>& members)
{
    lattice_ = lattice;
    sort_by_bin(particles, lattice, members, start_, index);
    for (auto* column : {&x, &y, &z, &radius}) column->resize(index.size());
    for (std::size_t k = 0; k < index.size(); ++k) {
        const auto i = std::size_t(index[k]);
        x[k] = float(particles.position[0][i] - lattice.low[0]);
        y[k] = float(particles.position[1][i] - lattice.low[1]);
        z[k] = float(particles.position[2][i] - lattice.low[2]);
        radius[k] = float(particles.radius[i]);
    }
    double reach = 0.0;
    for (int a = 0; a < 3; ++a) reach = std::max(reach, lattice.width[a] * double(lattice.count[std::size_t(a)]));
    rounding_ = float(1e-6 * reach);
}

int CellList::rows_around(const Bin& home, std::array<CellRow, 27>& rows) const
{
    struct Step {
        std::int64_t bin;
        int image;
    };
    const auto steps_along = [&](int axis, std::array<Step, 3>& steps) {
        const auto n = lattice_.count[std::size_t(axis)];
        int found = 0;
        for (std::int64_t b = home[std::size_t(axis)] - 1; b <= home[std::size_t(axis)] + 1; ++b) {
            if (b >= 0 && b < n) steps[std::size_t(found++)] = {b, 0};
            else if (lattice_.periodic[std::size_t(axis)]) steps[std::size_t(found++)] = {b < 0 ? b + n : b - n, b < 0 ? -1 : 1};
        }
        return found;
    };
    std::array<std::array<Step, 3>, 3> steps;
    std::array<int, 3> counts;
    for (std::size_t a = 0; a < 3; ++a) counts[a] = steps_along(int(a), steps[a]);
    const auto slow = std::size_t(lattice_.order[0]), middle = std::size_t(lattice_.order[1]), fast = std::size_t(lattice_.order[2]);
    int found = 0;
    for (int s = 0; s < counts[slow]; ++s)
        for (int m = 0; m < counts[middle]; ++m)
            for (int f = 0; f < counts[fast]; ++f) {
                std::array<Step, 3> step;
                step[slow] = steps[slow][std::size_t(s)];
                step[middle] = steps[middle][std::size_t(m)];
                step[fast] = steps[fast][std::size_t(f)];
                const auto key = std::size_t(lattice_.key({step[0].bin, step[1].bin, step[2].bin}));
                const CellRow row{start_[key], start_[key + 1], image_number(step[0].image, step[1].image, step[2].image)};
                if (f > 0 && rows[std::size_t(found - 1)].end == row.begin && rows[std::size_t(found - 1)].image == row.image)
                    rows[std::size_t(found - 1)].end = row.end;
                else rows[std::size_t(found++)] = row;
            }
    return found;
}

} // namespace core
