// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/side_overlap.hpp"
#include "core/grid/sub_face_merge.hpp"
#include <algorithm>
#include <cmath>
#include <tuple>

namespace core {
namespace {

/// A corner of a sub-face: its place on the master, and in space.
struct Node {
    double p, q;
    Vec3 x;
};

using Polygon = std::vector<Node>;

bool is_rim(double value, int last) { return value == 0 || value == last; }
bool is_whole(double value) { return value == std::floor(value); }

/// The vertices of the other side on the master, ordered as there. Those on edges of the master lie on them exactly.
class PlacedSide {
public:
    PlacedSide(const SideTiling& master, const SideTiling& other, const OverlapTolerance& tolerance) : other_(other), np_(other.np())
    {
        for (int q = 0; q <= other.nq(); ++q)
            for (int p = 0; p <= other.np(); ++p) {
                TilingPlace at = master.nearest(other.vertex(p, q));
                const bool on_rim = p == 0 || q == 0 || p == other.np() || q == other.nq();
                const double rim = on_rim ? tolerance.rim + at.gap : tolerance.snap;
                at.p = snapped(at.p, master.np(), tolerance.snap, rim);
                at.q = snapped(at.q, master.nq(), tolerance.snap, rim);
                // On the rim the neighbours of the two sides must find the same place.
                const auto on_line = [&](int axis, double line, double near) {
                    return master.nearest_on_line(axis, int(line), other.vertex(p, q), near);
                };
                if (is_rim(at.q, master.nq())) at.p = snapped(on_line(0, at.q, at.p), master.np(), tolerance.snap, rim);
                if (is_rim(at.p, master.np())) at.q = snapped(on_line(1, at.p, at.q), master.nq(), tolerance.snap, rim);
                const bool inside = at.p >= 0 && at.p <= master.np() && at.q >= 0 && at.q <= master.nq();
                const bool on_edge = inside && (is_whole(at.p) || is_whole(at.q));
                nodes_.push_back({at.p, at.q, on_edge ? master.point(at.p, at.q) : other.vertex(p, q)});
                near_.push_back(at.gap < tolerance.gap || !inside);
            }
    }

    [[nodiscard]] const Node& node(int p, int q) const { return nodes_[std::size_t(p + (np_ + 1) * q)]; }
    [[nodiscard]] bool near(int p, int q) const { return near_[std::size_t(p + (np_ + 1) * q)]; }
    [[nodiscard]] bool near_face(int p, int q) const { return near(p, q) && near(p + 1, q) && near(p, q + 1) && near(p + 1, q + 1); }
    [[nodiscard]] const SideTiling& tiling() const { return other_; }

private:
    [[nodiscard]] static double snapped(double value, int last, double to_edge, double to_rim)
    {
        const double whole = std::round(value);
        const bool at_rim = whole == 0 || whole == last;
        return std::abs(value - whole) < (at_rim ? std::max(to_edge, to_rim) : to_edge) ? whole : value;
    }

    const SideTiling& other_;
    int np_;
    std::vector<Node> nodes_;
    std::vector<bool> near_;
};

/// Where the straight line between two nodes, straight in the master's indices, crosses p or q = line. The same bits from either end.
Node crossing(const SideTiling& master, const Node& a, const Node& b, bool along_p, double line)
{
    const bool swap = std::pair(b.p, b.q) < std::pair(a.p, a.q);
    const Node &first = swap ? b : a, &second = swap ? a : b;
    Node c{line, line, Vec3::Zero()};
    if (along_p) c.q = first.q + (line - first.p) / (second.p - first.p) * (second.q - first.q);
    else c.p = first.p + (line - first.q) / (second.q - first.q) * (second.p - first.p);
    c.x = master.point(c.p, c.q);
    return c;
}

/// The part of a polygon on one side of a line of the master's indices.
Polygon clipped(const SideTiling& master, const Polygon& polygon, bool along_p, double line, double sign)
{
    Polygon part;
    for (std::size_t n = 0; n < polygon.size(); ++n) {
        const Node &a = polygon[n], &b = polygon[(n + 1) % polygon.size()];
        const double da = sign * ((along_p ? a.p : a.q) - line), db = sign * ((along_p ? b.p : b.q) - line);
        if (da >= 0) part.push_back(a);
        if (da * db < 0) part.push_back(crossing(master, a, b, along_p, line));
    }
    return part;
}

double index_area(const Polygon& polygon)
{
    double twice = 0;
    for (std::size_t n = 0; n < polygon.size(); ++n) {
        const Node &a = polygon[n], &b = polygon[(n + 1) % polygon.size()];
        twice += a.p * b.q - b.p * a.q;
    }
    return 0.5 * twice;
}

SubFace sub_face(const Polygon& polygon, FaceIndex master, FaceIndex other)
{
    SubFace face{master, other, Vec3::Zero(), Vec3::Zero()};
    Vec3 middle = Vec3::Zero();
    for (const Node& n : polygon) middle += n.x / double(polygon.size());
    double total = 0;
    for (std::size_t n = 0; n < polygon.size(); ++n) {
        const Vec3 &a = polygon[n].x, &b = polygon[(n + 1) % polygon.size()].x;
        const Vec3 area = 0.5 * (a - middle).cross(b - middle);
        face.area += area;
        face.centre += area.norm() * (a + b + middle) / 3;
        total += area.norm();
    }
    face.centre = total > 0 ? Vec3(face.centre / total) : middle;
    return face;
}

/// Adds the sub-faces of one face of the other side.
void cut(const SideTiling& master, const PlacedSide& placed, int p, int q, SideOverlap& result)
{
    Polygon whole{placed.node(p, q), placed.node(p + 1, q), placed.node(p + 1, q + 1), placed.node(p, q + 1)};
    if (index_area(whole) < 0) std::reverse(whole.begin(), whole.end());
    const auto [p_least, p_most] = std::minmax({whole[0].p, whole[1].p, whole[2].p, whole[3].p});
    const auto [q_least, q_most] = std::minmax({whole[0].q, whole[1].q, whole[2].q, whole[3].q});
    const int i0 = std::max(0, int(std::floor(p_least))), i1 = std::min(master.np(), int(std::ceil(p_most)));
    const int j0 = std::max(0, int(std::floor(q_least))), j1 = std::min(master.nq(), int(std::ceil(q_most)));
    for (int i = i0; i < i1; ++i) {
        const Polygon column = clipped(master, clipped(master, whole, true, i, 1), true, i + 1, -1);
        for (int j = j0; j < j1; ++j) {
            const Polygon piece = clipped(master, clipped(master, column, false, j, 1), false, j + 1, -1);
            if (piece.size() >= 3 && index_area(piece) > 0) result.faces.push_back(sub_face(piece, {i, j}, {p, q}));
        }
    }
}

/// Adds the points of the edge from one node of the other side to the next.
void add_points(const SideTiling& master, const PlacedSide& placed, int axis, FaceIndex vertex, std::vector<EdgePoint>& points)
{
    const FaceIndex next{vertex.p + (axis == 0), vertex.q + (axis == 1)};
    const Node &a = placed.node(vertex.p, vertex.q), &b = placed.node(next.p, next.q);
    if (a.x != placed.tiling().vertex(vertex.p, vertex.q)) points.push_back({axis, vertex, 0, a.x});
    if (b.x != placed.tiling().vertex(next.p, next.q)) points.push_back({axis, vertex, 1, b.x});
    for (const bool along_p : {true, false}) {
        const double from = along_p ? a.p : a.q, to = along_p ? b.p : b.q;
        const int last = along_p ? master.np() : master.nq();
        const int first_line = std::max(0, int(std::floor(std::min(from, to))) + 1),
                  end_line = std::min(last + 1, int(std::ceil(std::max(from, to))));
        for (int line = first_line; line < end_line; ++line) {
            const Node c = crossing(master, a, b, along_p, line);
            const bool inside = c.p >= 0 && c.p <= master.np() && c.q >= 0 && c.q <= master.nq();
            if (inside) points.push_back({axis, vertex, (line - from) / (to - from), c.x});
        }
    }
}

} // namespace

SideOverlap overlap(const SideTiling& master, const SideTiling& other, const OverlapTolerance& tolerance)
{
    const PlacedSide placed(master, other, tolerance);
    SideOverlap result;
    double sense = 0;
    for (int q = 0; q < other.nq(); ++q)
        for (int p = 0; p < other.np(); ++p) {
            if (!placed.near_face(p, q)) continue;
            const std::size_t before = result.faces.size();
            cut(master, placed, p, q, result);
            for (std::size_t n = before; n < result.faces.size(); ++n) sense += result.faces[n].area.dot(other.area(p, q));
        }
    result.same_sense = sense >= 0;
    if (result.faces.empty()) return result;
    for (int axis = 0; axis < 2; ++axis)
        for (int q = 0; q + (axis == 1) <= other.nq(); ++q)
            for (int p = 0; p + (axis == 0) <= other.np(); ++p)
                if (placed.near(p, q) && placed.near(p + (axis == 0), q + (axis == 1)))
                    add_points(master, placed, axis, {p, q}, result.points);
    for (int q = 0; q <= master.nq(); ++q)
        for (int p = 0; p <= master.np(); ++p)
            if (p == 0 || q == 0 || p == master.np() || q == master.nq()) result.rim.push_back(master.vertex(p, q));
    merge_slivers(master, other, tolerance.sliver, result);
    std::sort(result.faces.begin(), result.faces.end(), [](const SubFace& a, const SubFace& b) {
        return std::tuple(a.master.q, a.master.p, a.other.q, a.other.p) < std::tuple(b.master.q, b.master.p, b.other.q, b.other.p);
    });
    return result;
}

} // namespace core
