// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/sub_face_joining.hpp"
#include "core/base/error.hpp"
#include "core/grid/area_changes.hpp"
#include "core/grid/cell_closing.hpp"
#include "core/grid/hexahedron.hpp"
#include "core/grid/side_stencil.hpp"
#include <algorithm>
#include <list>
#include <map>

namespace core {
namespace {

using SideKey = std::pair<BlockId, Side>;

std::string name_of(const SideKey& side) { return text("side ", side_words[std::size_t(side.second)], " of block ", side.first); }

SideContact reversed(const SideContact& c) { return {c.b, c.a, c.side_b, c.side_a, -c.shift}; }

/// The contacts with the master first. Sides above a surface and those below it take turns, so no side is both.
std::vector<SideContact> with_masters_first(std::vector<SideContact> contacts)
{
    for (SideContact& c : contacts)
        if (SideKey(c.b, c.side_b) < SideKey(c.a, c.side_a)) c = reversed(c);
    std::stable_sort(contacts.begin(), contacts.end(), [](const SideContact& l, const SideContact& r) {
        return std::tuple(l.a, l.side_a, l.b, l.side_b) < std::tuple(r.a, r.side_a, r.b, r.side_b);
    });
    std::map<SideKey, bool> is_master;
    for (const SideContact& first : contacts) {
        is_master.try_emplace({first.a, first.side_a}, true);
        for (bool more = true; more;) { // spreads over all that touch each other
            more = false;
            for (const SideContact& c : contacts) {
                const auto a = is_master.find({c.a, c.side_a}), b = is_master.find({c.b, c.side_b});
                if (a != is_master.end()) more = is_master.try_emplace({c.b, c.side_b}, !a->second).second || more;
                else if (b != is_master.end()) more = is_master.try_emplace({c.a, c.side_a}, !b->second).second || more;
            }
        }
    }
    for (SideContact& c : contacts) {
        require<ConfigError>(is_master[{c.a, c.side_a}] != is_master[{c.b, c.side_b}],
                             text(name_of({c.a, c.side_a}), " and ", name_of({c.b, c.side_b}), " lie on the same side of their interface"));
        if (!is_master[{c.a, c.side_a}]) c = reversed(c);
    }
    return contacts;
}

/// One contact with its geometry; places as the master has them, but points and rim of the overlap as the other side has them.
struct Contact {
    SideContact sides;
    SideTiling master, other;
    SideOverlap overlap;

    Contact(const MultiBlock& grid, const SideContact& c)
        : sides(c),
          master(grid.blocks[std::size_t(c.a)], c.side_a),
          other(grid.blocks[std::size_t(c.b)], c.side_b, -c.shift),
          overlap(core::overlap(master, other))
    {
        require<ConfigError>(!overlap.faces.empty(), text(name_of({c.a, c.side_a}), " and ", name_of({c.b, c.side_b}),
                                                          " are said to touch, but do not lie on each other"));
        for (EdgePoint& e : overlap.points) e.point += c.shift;
        for (Vec3& x : overlap.rim) x += c.shift;
    }
};

SidePlace place_on(const SideTiling& tiling, BlockId block, Side side, const Vec3& x, const Vec3& shift)
{
    const TilingPlace at = tiling.nearest(x);
    return {block, side, std::clamp(at.p, 0.0, double(tiling.np())), std::clamp(at.q, 0.0, double(tiling.nq())), Motion(shift)};
}

/// Where a layer's stencil for a place lies [m].
Vec3 stencil_centre(const MultiBlock& grid, const Topology& topology, const SidePlace& place)
{
    Vec3 x = Vec3::Zero();
    for (const HaloSource& s : layer_stencil(topology, place, 0))
        x += s.weight * s.motion.origin_of(cell_shape(grid.blocks[std::size_t(s.block)], s.cell).centroid);
    return x;
}

JoinedSubFace joined(const MultiBlock& grid, const Topology& topology, const Contact& c, const SubFace& f)
{
    const SideContact& s = c.sides;
    const double towards_b = (axis_of(s.side_a) == 1) == is_high(s.side_a) ? -1 : 1;
    JoinedSubFace face{};
    face.a = c.master.cell(f.master.p, f.master.q);
    face.b = c.other.cell(f.other.p, f.other.q);
    const auto centroid = [&](BlockId block, Index3 cell) { return cell_shape(grid.blocks[std::size_t(block)], cell).centroid; };
    face.from_a = f.centre - centroid(s.a, face.a);
    face.from_b = f.centre - (centroid(s.b, face.b) - s.shift);
    set_area(towards_b * f.area, face);
    face.on_a = place_on(c.master, s.a, s.side_a, f.centre, Vec3::Zero());
    face.on_b = place_on(c.other, s.b, s.side_b, f.centre, s.shift);
    const double to_a = std::abs(face.area.dot(f.centre - stencil_centre(grid, topology, face.on_a)));
    const double to_b = std::abs(face.area.dot(stencil_centre(grid, topology, face.on_b) - f.centre));
    face.weight = to_a / (to_a + to_b);
    return face;
}

/// A side by the area of each of its faces that each contact covers.
class Cover {
public:
    explicit Cover(const SideTiling& tiling) : np_(tiling.np()), faces_(std::size_t(tiling.np() * tiling.nq())) {}

    void add(FaceIndex f, const Contact& contact, double area)
    {
        auto& parts = faces_[std::size_t(f.p + np_ * f.q)];
        if (parts.empty() || parts.back().first != &contact) parts.emplace_back(&contact, 0.0);
        parts.back().second += area;
    }
    /// The contact that covers the largest part of a face.
    /// @throws ConfigError if the face is not covered.
    [[nodiscard]] const Contact& largest(FaceIndex f, double whole, const SideKey& side) const
    {
        constexpr double enough = 0.5; // coarse faces on a curved interface miss less; what is missing bends their edges
        double sum = 0;
        const Contact* largest = nullptr;
        double most = 0;
        for (const auto& [contact, area] : faces_[std::size_t(f.p + np_ * f.q)]) {
            sum += area;
            if (area <= most) continue;
            most = area;
            largest = contact;
        }
        require<ConfigError>(largest != nullptr && sum >= enough * whole,
                             text(name_of(side), " lies on others over ", int(100 * sum / whole), " % of its face (", f.p, ", ", f.q,
                                  ") only: let it end where they end"));
        return *largest;
    }

private:
    int np_;
    std::vector<std::vector<std::pair<const Contact*, double>>> faces_;
};

/// For each face of a side where its centre lies on the side that covers it.
std::vector<SidePlace> places_of(const MultiBlock& grid, const SideKey& side, const Cover& cover)
{
    const SideTiling tiling(grid.blocks[std::size_t(side.first)], side.second);
    std::vector<SidePlace> places;
    for (int q = 0; q < tiling.nq(); ++q)
        for (int p = 0; p < tiling.np(); ++p) {
            const Contact& c = cover.largest({p, q}, tiling.area(p, q).norm(), side);
            const Vec3 centre = tiling.point(p + 0.5, q + 0.5);
            const SideContact& s = c.sides;
            if (SideKey(s.a, s.side_a) == side) places.push_back(place_on(c.other, s.b, s.side_b, centre, s.shift));
            else places.push_back(place_on(c.master, s.a, s.side_a, centre - s.shift, -s.shift));
        }
    return places;
}

} // namespace

SubFaceJoints join_at_sub_faces(const MultiBlock& grid, const Topology& topology)
{
    std::list<Contact> contacts;
    for (const SideContact& c : with_masters_first(grid.contacts)) contacts.emplace_back(grid, c);
    SubFaceJoints joints;
    std::map<SideKey, Cover> covers;
    std::map<SideKey, std::vector<const SideOverlap*>> bent;
    for (const Contact& c : contacts) {
        Cover& of_a = covers.try_emplace({c.sides.a, c.sides.side_a}, c.master).first->second;
        Cover& of_b = covers.try_emplace({c.sides.b, c.sides.side_b}, c.other).first->second;
        auto& joint = joints.interfaces.emplace_back(SubFaceInterface{c.sides, {}});
        for (const SubFace& f : c.overlap.faces) {
            of_a.add(f.master, c, f.area.norm());
            of_b.add(f.other, c, f.area.norm());
            joint.faces.push_back(joined(grid, topology, c, f));
        }
        bent[{c.sides.b, c.sides.side_b}].push_back(&c.overlap);
    }
    joints.places.resize(grid.blocks.size());
    for (const auto& [side, cover] : covers) {
        require<ConfigError>(!topology.neighbour(side.first, side.second),
                             text(name_of(side), " has a neighbour with matching points already"));
        joints.places[std::size_t(side.first)][std::size_t(side.second)] = places_of(grid, side, cover);
    }
    std::vector<BentSide> bent_sides;
    for (const auto& [side, overlaps] : bent) bent_sides.push_back({side.first, side.second, overlaps});
    Topology joined_topology = topology;
    joined_topology.joints.places = joints.places;
    joints.area_changes = area_changes(grid, joined_topology, bent_sides);
    close_cells(grid, joints);
    require_closed_cells(grid, joints);
    return joints;
}

} // namespace core
