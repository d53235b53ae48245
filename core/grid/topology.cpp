// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/topology.hpp"
#include "core/base/error.hpp"
#include "core/grid/sub_face_joining.hpp"

namespace core {
namespace {

struct SideRef {
    BlockId block;
    Side side;
};

std::array<int, 2> tangential(Side s)
{
    const int n = axis_of(s);
    return {n == 0 ? 1 : 0, n == 2 ? 1 : 2};
}

/// Vertex (p, q) of a side, counted along its tangential axes.
Index3 vertex_index(const Vertices& v, Side s, int p, int q)
{
    const auto t = tangential(s);
    Index3 c;
    c[axis_of(s)] = is_high(s) ? v.extents()[axis_of(s)] - 1 : 0;
    c[t[0]] = p;
    c[t[1]] = q;
    return c;
}

Vec3 centre(const Vertices& v, Side s)
{
    const auto t = tangential(s);
    const int np = v.extents()[t[0]] - 1, nq = v.extents()[t[1]] - 1;
    Vec3 sum = Vec3::Zero();
    for (int p : {0, np})
        for (int q : {0, nq}) sum += v.view()[vertex_index(v, s, p, q)];
    return sum / 4;
}

double smallest_edge(const Vertices& v, Side s)
{
    const auto t = tangential(s);
    double smallest = std::numeric_limits<double>::max();
    for (int q = 0; q < v.extents()[t[1]]; ++q)
        for (int p = 0; p < v.extents()[t[0]]; ++p) {
            const Vec3 x = v.view()[vertex_index(v, s, p, q)];
            if (p > 0) smallest = std::min(smallest, (x - v.view()[vertex_index(v, s, p - 1, q)]).norm());
            if (q > 0) smallest = std::min(smallest, (x - v.view()[vertex_index(v, s, p, q - 1)]).norm());
        }
    return smallest;
}

/// The map of vertex indices from side `a` to side `b` for one of the eight ways to lay one side on the other.
IndexMap vertex_map(SideRef a, SideRef b, const Extents& cells_a, const Extents& cells_b, int way)
{
    const auto ta = tangential(a.side), tb = tangential(b.side);
    const bool swap = (way & 4) != 0;
    IndexMap map;
    const int na = axis_of(a.side), nb = axis_of(b.side);
    const bool same_way = is_high(a.side) != is_high(b.side);
    map.axis[std::size_t(na)] = nb;
    map.sign[std::size_t(na)] = same_way ? 1 : -1;
    const int from = is_high(a.side) ? cells_a[na] : 0, to = is_high(b.side) ? cells_b[nb] : 0;
    map.offset[nb] = to - map.sign[std::size_t(na)] * from;
    for (int m = 0; m < 2; ++m) {
        const int axis_b = tb[std::size_t(swap ? 1 - m : m)];
        const bool reversed = (way & (1 << m)) != 0;
        map.axis[std::size_t(ta[std::size_t(m)])] = axis_b;
        map.sign[std::size_t(ta[std::size_t(m)])] = reversed ? -1 : 1;
        map.offset[axis_b] = reversed ? cells_b[axis_b] : 0;
    }
    return map;
}

/// The same map for cells instead of vertices: a reversed axis counts from the other end.
IndexMap cell_map(IndexMap map)
{
    for (int m = 0; m < 3; ++m)
        if (map.sign[std::size_t(m)] < 0) map.offset[map.axis[std::size_t(m)]] -= 1;
    return map;
}

bool fits(const MultiBlock& grid, SideRef a, SideRef b, const IndexMap& map, const Motion& motion, double tolerance)
{
    const Vertices& va = grid.blocks[std::size_t(a.block)];
    const Vertices& vb = grid.blocks[std::size_t(b.block)];
    const auto t = tangential(a.side);
    for (int m : t)
        if (va.extents()[m] != vb.extents()[map.axis[std::size_t(m)]]) return false;
    for (int q = 0; q < va.extents()[t[1]]; ++q)
        for (int p = 0; p < va.extents()[t[0]]; ++p) {
            const Index3 c = vertex_index(va, a.side, p, q);
            if ((motion.of_position(va.view()[c]) - vb.view()[map(c)]).norm() > tolerance) return false;
        }
    return true;
}

void copy_vertices(MultiBlock& grid, SideRef a, SideRef b, const IndexMap& map, const Motion& motion)
{
    const Vertices& va = grid.blocks[std::size_t(a.block)];
    const auto target = grid.blocks[std::size_t(b.block)].view();
    const auto t = tangential(a.side);
    for (int q = 0; q < va.extents()[t[1]]; ++q)
        for (int p = 0; p < va.extents()[t[0]]; ++p) {
            const Index3 c = vertex_index(va, a.side, p, q);
            target[map(c)] = motion.of_position(va.view()[c]);
        }
}

std::vector<Motion> motions_of(const MultiBlock& grid)
{
    std::vector<Motion> motions{Motion()};
    for (const Vec3& period : grid.periods) {
        motions.emplace_back(period);
        motions.emplace_back(Vec3(-period));
    }
    if (grid.turn) {
        motions.push_back(grid.turn->motion());
        motions.push_back(grid.turn->motion().inverse());
    }
    return motions;
}

std::optional<Interface> meeting(const MultiBlock& grid, SideRef a, SideRef b, const std::vector<Motion>& motions)
{
    const Vertices& va = grid.blocks[std::size_t(a.block)];
    const Vertices& vb = grid.blocks[std::size_t(b.block)];
    const double tolerance = grid.match_tolerance * smallest_edge(va, a.side);
    for (const Motion& motion : motions) {
        const bool itself = a.block == b.block && a.side == b.side;
        if (itself || (motion.of_position(centre(va, a.side)) - centre(vb, b.side)).norm() > tolerance) continue;
        for (int way = 0; way < 8; ++way) {
            const IndexMap map = vertex_map(a, b, cells_of(va), cells_of(vb), way);
            if (fits(grid, a, b, map, motion, tolerance)) return Interface{a.block, b.block, a.side, b.side, map, motion};
        }
    }
    return std::nullopt;
}

void connect(Topology& topology, const Interface& f)
{
    const auto enter = [&](BlockId block, Side side, const Neighbour& n) {
        auto& place = topology.neighbours[std::size_t(block)][std::size_t(side)];
        require<ConfigError>(!place.has_value(),
                             text("side ", side_words[std::size_t(side)], " of block ", block, " meets blocks ", place ? place->block : -1,
                                  " and ", n.block,
                                  ": cut the blocks so that each side meets one other, or take thicker ones if they are thinner than the "
                                  "tolerance with which sides are matched"));
        place = n;
    };
    enter(f.a, f.side_a, {f.b, f.side_b, f.a_to_b, f.motion});
    enter(f.b, f.side_b, {f.a, f.side_a, f.a_to_b.inverse(), f.motion.inverse()});
    topology.interfaces.push_back(f);
}

} // namespace

Topology match_sides(MultiBlock& grid)
{
    Topology topology;
    std::vector<SideRef> sides;
    for (std::size_t b = 0; b < grid.blocks.size(); ++b) {
        topology.cells.push_back(cells_of(grid.blocks[b]));
        for (Side s : all_sides) sides.push_back({BlockId(b), s});
    }
    topology.neighbours.resize(grid.blocks.size());
    const auto motions = motions_of(grid);
    for (std::size_t p = 0; p < sides.size(); ++p)
        for (std::size_t q = p + 1; q < sides.size(); ++q)
            if (auto found = meeting(grid, sides[p], sides[q], motions)) {
                copy_vertices(grid, sides[p], sides[q], found->a_to_b, found->motion);
                found->a_to_b = cell_map(found->a_to_b);
                connect(topology, *found);
            }
    if (!grid.contacts.empty()) topology.joints = join_at_sub_faces(grid, topology);
    for (const SideRef s : sides)
        if (topology.at_boundary(s.block, s.side)) topology.boundaries.push_back({s.block, s.side, grid.boundary_name(s.block, s.side)});
    return topology;
}

} // namespace core
