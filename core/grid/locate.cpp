// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/locate.hpp"
#include "core/grid/trilinear.hpp"
#include <cmath>

namespace core {
namespace {

struct Bounds {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::max());
    Vec3 high = Vec3::Constant(std::numeric_limits<double>::lowest());
    void add(const Vec3& x)
    {
        low = low.cwiseMin(x);
        high = high.cwiseMax(x);
    }
};

Bounds bounds_of(const Vertices& v, Index3 c)
{
    Bounds box;
    for_each(c, {c.i + 2, c.j + 2, c.k + 2}, [&](int i, int j, int k) { box.add(v(i, j, k)); });
    const Vec3 margin = Locator::tolerance_cells * (box.high - box.low);
    return {box.low - margin, box.high + margin};
}

double excess(double xi) { return xi < 0 ? -xi : xi > 1 ? xi - 1 : 0; }

/// Well inside a cell, at least `margin` from its faces: then no other cell holds the point.
bool well_inside(const Vec3& xi)
{
    constexpr double margin = 1e-6;
    return xi.minCoeff() > margin && xi.maxCoeff() < 1 - margin;
}

} // namespace

Locator::Locator(const Mesh& mesh) : mesh_(&mesh)
{
    Bounds all;
    for (BlockId b = 0; b < mesh.blocks(); ++b)
        for (const Vec3& x : mesh.vertices(b).data()) all.add(x);
    const Vec3 extent = all.high - all.low;
    const double edge = std::cbrt(extent.prod() / double(mesh.total_cells()));
    bins_.low = all.low;
    for (int m = 0; m < 3; ++m) {
        const int n = std::clamp(int(extent[m] / edge), 1, 512);
        (m == 0 ? bins_.count.ni : m == 1 ? bins_.count.nj : bins_.count.nk) = n;
        bins_.size[m] = extent[m] / n;
    }
    const auto visit = [&](auto&& use) {
        for (BlockId b = 0; b < mesh.blocks(); ++b)
            for_each_cell(mesh.cells(b), [&](int i, int j, int k) {
                const Bounds box = bounds_of(mesh.vertices(b), {i, j, k});
                const Index3 low = bin_of(box.low), high = bin_of(box.high);
                for_each(low, {high.i + 1, high.j + 1, high.k + 1}, [&](int p, int q, int r) {
                    use(std::size_t(p + bins_.count.ni * (q + bins_.count.nj * r)), b, Index3{i, j, k});
                });
            });
    };
    bins_.first.assign(std::size_t(bins_.count.size()) + 1, 0);
    visit([&](std::size_t bin, BlockId, Index3) { ++bins_.first[bin + 1]; });
    for (std::size_t n = 1; n < bins_.first.size(); ++n) bins_.first[n] += bins_.first[n - 1];
    bins_.cells.resize(std::size_t(bins_.first.back()));
    auto next = bins_.first;
    visit([&](std::size_t bin, BlockId b, Index3 c) { bins_.cells[std::size_t(next[bin]++)] = {b, c}; });
    find_owners();
}

void Locator::find_owners()
{
    for (std::size_t bin = 0; bin + 1 < bins_.first.size(); ++bin) {
        const auto begin = bins_.cells.begin() + bins_.first[bin], end = bins_.cells.begin() + bins_.first[bin + 1];
        const int first = begin == end ? -1 : mesh_->owner(begin->first);
        const bool same = std::all_of(begin, end, [&](const auto& c) { return mesh_->owner(c.first) == first; });
        bins_.owner.push_back(same ? first : -1);
    }
}

Index3 Locator::bin_of(const Vec3& x) const
{
    Index3 bin;
    for (int m = 0; m < 3; ++m)
        bin[m] = int(std::clamp(std::floor((x[m] - bins_.low[m]) / bins_.size[m]), 0.0, double(bins_.count[m] - 1)));
    return bin;
}

std::size_t Locator::bin_number(const Vec3& x) const
{
    const Index3 b = bin_of(x);
    return std::size_t(b.i + bins_.count.ni * (b.j + bins_.count.nj * b.k));
}

int Locator::owner(const Vec3& x) const
{
    if (const int all = bins_.owner[bin_number(x)]; all >= 0) return all;
    const auto at = find(x);
    return at ? mesh_->owner(at->block) : 0;
}

Vec3 Locator::position(const Location& at) const { return TrilinearCell(mesh_->vertices(at.block), at.cell).position(at.xi); }

std::optional<Location> Locator::find(const Vec3& x) const
{
    const std::size_t bin = bin_number(x);
    std::optional<Location> best;
    double least = tolerance_cells;
    for (int n = bins_.first[bin]; n < bins_.first[bin + 1]; ++n) {
        const auto& [block, cell] = bins_.cells[std::size_t(n)];
        const auto xi = TrilinearCell(mesh_->vertices(block), cell).inverse(x, Vec3::Constant(0.5));
        if (!xi) continue;
        const double out = std::max({excess((*xi)[0]), excess((*xi)[1]), excess((*xi)[2])});
        if (out < least) {
            least = out;
            best = Location{block, cell, xi->cwiseMax(0.0).cwiseMin(1.0)};
        }
        if (out == 0) break;
    }
    return best;
}

std::optional<Location> Locator::walk(const Vec3& x, Location at, int steps) const
{
    for (; steps > 0; --steps) {
        // Always from the middle: the bits of xi must not depend on the way that led to the cell.
        const auto xi = TrilinearCell(mesh_->vertices(at.block), at.cell).inverse(x, Vec3::Constant(0.5));
        if (!xi) return std::nullopt;
        if (well_inside(*xi)) {
            at.xi = *xi;
            return at;
        }
        int axis = 0;
        for (int m = 1; m < 3; ++m)
            if (excess((*xi)[m]) > excess((*xi)[axis])) axis = m;
        if (excess((*xi)[axis]) == 0) return std::nullopt;
        const bool high = (*xi)[axis] > 1;
        at.cell[axis] += high ? 1 : -1;
        if (mesh_->cells(at.block).contains(at.cell)) continue;
        const auto& beyond = mesh_->topology().neighbour(at.block, side_of(axis, high));
        if (!beyond || !beyond->motion.is_identity()) return std::nullopt;
        at.cell = beyond->map(at.cell);
        at.block = beyond->block;
    }
    return std::nullopt;
}

std::optional<Location> Locator::find_beyond_seams(const Vec3& x) const
{
    const auto through = [&](const Vec3& shift) -> std::optional<Location> {
        if (shift.isZero(0)) return std::nullopt;
        for (const Vec3& image : {Vec3(x + shift), Vec3(x - shift)})
            if (auto at = find(image)) return at;
        return std::nullopt;
    };
    for (const Interface& seam : mesh_->topology().interfaces)
        if (!seam.motion.turns)
            if (auto at = through(seam.motion.shift)) return at;
    for (const SubFaceInterface& seam : mesh_->topology().joints.interfaces)
        if (auto at = through(seam.contact.shift)) return at;
    return std::nullopt;
}

std::optional<Location> Locator::find(const Vec3& x, const Location& near) const
{
    constexpr int most_steps = 12;
    if (near.block >= 0)
        if (auto at = walk(x, near, most_steps)) return at;
    const auto direct = find(x);
    if (direct && (position(*direct) - x).norm() < 1e-9 * bins_.size.norm()) return direct;
    const auto beyond = find_beyond_seams(x); // else beyond a seam, or beyond a wall by less than the tolerance
    return beyond ? beyond : direct;
}

} // namespace core
