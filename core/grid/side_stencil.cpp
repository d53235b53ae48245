// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/side_stencil.hpp"
#include "core/grid/side_tiling.hpp"
#include <algorithm>
#include <cmath>
#include <optional>

namespace core {
namespace {

/// The cell itself, or where it lies in a block reached through sides that match.
std::optional<HaloSource> found_from(const Topology& topology, HaloSource at)
{
    constexpr int longest_walk = 6;
    for (int step = 0; step <= longest_walk; ++step) {
        const Extents n = topology.cells[std::size_t(at.block)];
        if (n.contains(at.cell)) return at;
        const Neighbour* next = nullptr;
        for (int m = 0; m < 3 && next == nullptr; ++m)
            if (at.cell[m] < 0 || at.cell[m] >= n[m]) {
                const auto& beyond = topology.neighbour(at.block, side_of(m, at.cell[m] >= n[m]));
                if (beyond) next = &*beyond;
            }
        if (next == nullptr) return std::nullopt;
        at = {next->block, next->map(at.cell), at.motion.then(next->motion), at.weight};
    }
    return std::nullopt;
}

/// Points along an axis and their weights.
struct AxisStencil {
    int first = 0;
    std::vector<double> weights;
};

/// Lagrange's interpolation to `x` between the points lowest ... highest, at most two on either side, as LayerWeights has it.
AxisStencil axis_stencil(double x, int lowest, int highest, LayerWeights kind)
{
    if (lowest == highest) return {lowest, {1.0}};
    if (kind == LayerWeights::linear) {
        const double within = std::clamp(x, double(lowest), double(highest));
        const int cell = std::min(int(std::floor(within)), highest - 1);
        return {cell, {cell + 1 - within, within - cell}};
    }
    const int cell = std::clamp(int(std::floor(x)), lowest, highest - 1);
    const bool between = x >= lowest && x <= highest;
    const int first = between ? std::max(cell - 1, lowest) : cell, last = between ? std::min(cell + 2, highest) : cell + 1;
    AxisStencil stencil{first, {}};
    double sum = 0;
    for (int n = first; n <= last; ++n) {
        double weight = 1;
        for (int other = first; other <= last; ++other)
            if (other != n) weight *= (x - other) / (n - other);
        stencil.weights.push_back(weight);
        sum += weight;
    }
    for (double& weight : stencil.weights) weight /= sum;
    return stencil;
}

/// The layer of a place: its cells by their indices along the two axes of the side, those beyond its rim included.
class Layer {
public:
    Layer(const Topology& topology, const SidePlace& place, int depth)
        : topology_(topology), place_(place), n_(topology.cells[std::size_t(place.block)]), axes_(tangential_axes(place.side))
    {
        const int axis = axis_of(place.side);
        normal_ = is_high(place.side) ? n_[axis] - 1 - depth : depth;
    }
    [[nodiscard]] std::optional<HaloSource> cell(int p, int q) const
    {
        Index3 c;
        c[axis_of(place_.side)] = normal_;
        c[axes_[0]] = p;
        c[axes_[1]] = q;
        return found_from(topology_, {place_.block, c, place_.motion, 1});
    }
    /// Last index in the direction of `step` of the cells that a stencil may use, at most two beyond the rim.
    [[nodiscard]] int reach(int axis, int step, std::array<int, 2> at) const
    {
        const int count = n_[axes_[std::size_t(axis)]], rim = step > 0 ? count - 1 : 0;
        int reached = rim;
        for (int n = 1; n <= 2; ++n) {
            at[std::size_t(axis)] = rim + n * step;
            if (!cell(at[0], at[1])) break;
            reached = rim + n * step;
        }
        return reached;
    }
    [[nodiscard]] int count(int axis) const { return n_[axes_[std::size_t(axis)]]; }

private:
    const Topology& topology_;
    SidePlace place_;
    Extents n_;
    std::array<int, 2> axes_;
    int normal_ = 0;
};

/// The product of two stencils; nothing if one of its cells does not exist.
std::vector<HaloSource> product(const Layer& layer, const AxisStencil& p, const AxisStencil& q)
{
    std::vector<HaloSource> sources;
    for (std::size_t b = 0; b < q.weights.size(); ++b)
        for (std::size_t a = 0; a < p.weights.size(); ++a) {
            auto source = layer.cell(p.first + int(a), q.first + int(b));
            if (!source) return {};
            source->weight = p.weights[a] * q.weights[b];
            if (source->weight != 0) sources.push_back(*source);
        }
    return sources;
}

} // namespace

std::vector<HaloSource> layer_stencil(const Topology& topology, const SidePlace& place, int depth, LayerWeights weights)
{
    const Layer layer(topology, place, depth);
    const double p = place.p - 0.5, q = place.q - 0.5; // centres of cells lie half way between vertices
    const auto inside = [&](int axis, double x) { return std::clamp(int(std::floor(x)), 0, layer.count(axis) - 1); };
    const std::array<int, 2> at{inside(0, p), inside(1, q)};
    if (!layer.cell(at[0], at[1])) return {};
    auto sources = product(layer, axis_stencil(p, layer.reach(0, -1, at), layer.reach(0, 1, at), weights),
                           axis_stencil(q, layer.reach(1, -1, at), layer.reach(1, 1, at), weights));
    // Round an edge where the blocks beyond have no common corner the stencil stays in the block.
    if (sources.empty())
        sources = product(layer, axis_stencil(p, 0, layer.count(0) - 1, weights), axis_stencil(q, 0, layer.count(1) - 1, weights));
    return sources;
}

} // namespace core
