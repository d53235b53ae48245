// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/cell_closing.hpp"
#include "core/base/error.hpp"
#include "core/grid/hexahedron.hpp"
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

namespace core {
namespace {

constexpr double round_off = 1e-11; // of the largest face, after sums over its sub-faces

using FaceKey = std::tuple<BlockId, int, int, int, int>;
using CellKey = std::tuple<BlockId, int, int, int>;

FaceKey key_of(BlockId block, int axis, Index3 face) { return {block, axis, face.i, face.j, face.k}; }
CellKey key_of(BlockId block, Index3 cell) { return {block, cell.i, cell.j, cell.k}; }

/// A cell whose area vectors do not add up to zero.
struct OpenCell {
    BlockId block;
    Index3 cell;
    Vec3 open;      ///< their sum, outward [m2]
    double largest; ///< of its faces [m2]
};

/// In the order of their faces, each cell once.
std::vector<OpenCell> open_cells(const MultiBlock& grid, const SubFaceJoints& joints)
{
    std::map<FaceKey, Vec3> changes, sums;
    for (const AreaChange& c : joints.area_changes)
        changes.try_emplace(key_of(c.block, c.axis, c.face), Vec3::Zero()).first->second += c.area;
    const auto add = [&](BlockId block, Side side, Index3 cell, const Vec3& outward) {
        if (is_high(side)) ++cell[axis_of(side)];
        sums.try_emplace(key_of(block, axis_of(side), cell), Vec3::Zero()).first->second += is_high(side) ? outward : Vec3(-outward);
    };
    for (const SubFaceInterface& f : joints.interfaces)
        for (const JoinedSubFace& s : f.faces) {
            add(f.contact.a, f.contact.side_a, s.a, s.area);
            add(f.contact.b, f.contact.side_b, s.b, -s.area);
        }
    std::vector<OpenCell> found;
    std::map<CellKey, bool> seen;
    for (const auto& [key, unused] : sums) {
        const auto [block, across, fi, fj, fk] = key;
        const Vertices& v = grid.blocks[std::size_t(block)];
        Index3 cell{fi, fj, fk};
        if (cell[across] > 0) --cell[across];
        if (!seen.try_emplace(key_of(block, cell), true).second) continue;
        Vec3 open = Vec3::Zero();
        double largest = 0;
        for (const Side side : all_sides) {
            Index3 face = cell;
            if (is_high(side)) ++face[axis_of(side)];
            const FaceKey at = key_of(block, axis_of(side), face);
            Vec3 area = face_shape(face_corners(v, axis_of(side), face)).area;
            if (const auto joined = sums.find(at); joined != sums.end()) area = joined->second;
            else if (const auto bent = changes.find(at); bent != changes.end()) area += bent->second;
            open += is_high(side) ? area : Vec3(-area);
            largest = std::max(largest, area.norm());
        }
        if (!(open.norm() <= round_off * largest)) found.push_back({block, cell, open, largest});
    }
    return found;
}

/// A sub-face between two open cells.
struct Link {
    JoinedSubFace* face;
    int a, b; ///< numbers of the cells
};

/// Open cells and the sub-faces between them.
class OpenCells {
public:
    OpenCells(const MultiBlock& grid, SubFaceJoints& joints) : cells_(open_cells(grid, joints)), group_(cells_.size())
    {
        std::map<CellKey, int> number;
        for (std::size_t n = 0; n < cells_.size(); ++n) number[key_of(cells_[n].block, cells_[n].cell)] = int(n);
        std::iota(group_.begin(), group_.end(), 0);
        for (SubFaceInterface& f : joints.interfaces)
            for (JoinedSubFace& s : f.faces) {
                const auto a = number.find(key_of(f.contact.a, s.a)), b = number.find(key_of(f.contact.b, s.b));
                if (a == number.end() || b == number.end()) continue;
                links_.push_back({&s, a->second, b->second});
                group_[std::size_t(leader(a->second))] = leader(b->second);
            }
        for (std::size_t n = 0; n < cells_.size(); ++n) group_[n] = leader(int(n));
    }
    [[nodiscard]] bool empty() const { return cells_.empty(); }

    /// What each sub-face is to gain.
    [[nodiscard]] std::vector<Vec3> changes() const
    {
        const auto n = Eigen::Index(cells_.size());
        std::vector<Eigen::Triplet<double>> entries;
        for (const Link& l : links_) {
            const double weight = l.face->area.norm();
            for (const auto& [row, column, sign] : {std::tuple(l.a, l.a, 1), {l.b, l.b, 1}, {l.a, l.b, -1}, {l.b, l.a, -1}})
                entries.emplace_back(row, column, sign * weight);
        }
        Eigen::MatrixX3d right(n, 3);
        for (Eigen::Index c = 0; c < n; ++c) {
            const OpenCell& cell = cells_[std::size_t(c)];
            right.row(c) = cell.open;
            if (group_[std::size_t(c)] == c) entries.emplace_back(int(c), int(c), cell.largest); // one of each group is held
        }
        Eigen::SparseMatrix<double> matrix(n, n);
        matrix.setFromTriplets(entries.begin(), entries.end());
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
        const Eigen::MatrixX3d potential = factors.solve(right);
        std::vector<Vec3> changes;
        for (const Link& l : links_) changes.push_back(l.face->area.norm() * (potential.row(l.b) - potential.row(l.a)).transpose());
        return changes;
    }
    /// Closes the groups of cells that can be.
    void apply(const std::vector<Vec3>& changes) const
    {
        constexpr double most = 1.0 / 3;
        std::vector<Vec3> sum(cells_.size(), Vec3::Zero());
        std::vector<double> largest(cells_.size(), 0);
        std::vector<bool> can(cells_.size(), true);
        for (std::size_t n = 0; n < cells_.size(); ++n) {
            const auto group = std::size_t(group_[n]);
            sum[group] += cells_[n].open;
            largest[group] = std::max(largest[group], cells_[n].largest);
        }
        for (std::size_t n = 0; n < cells_.size(); ++n)
            if (sum[n].norm() > round_off * largest[n]) can[n] = false;
        for (std::size_t n = 0; n < links_.size(); ++n)
            if (changes[n].norm() > most * links_[n].face->area.norm()) can[std::size_t(group_[std::size_t(links_[n].a)])] = false;
        for (std::size_t n = 0; n < links_.size(); ++n)
            if (can[std::size_t(group_[std::size_t(links_[n].a)])]) set_area(links_[n].face->area + changes[n], *links_[n].face);
    }

private:
    [[nodiscard]] int leader(int n) const
    {
        while (group_[std::size_t(n)] != n) n = group_[std::size_t(n)];
        return n;
    }

    std::vector<OpenCell> cells_;
    std::vector<Link> links_;
    std::vector<int> group_; ///< number of the first cell of its group, for each cell
};

} // namespace

void set_area(const Vec3& area, JoinedSubFace& face)
{
    constexpr double least_cosine = 0.05; // between S and d: keeps the two-point part positive on any grid
    const Vec3 d = face.from_a - face.from_b;
    face.area = area;
    face.transmissibility = area.squaredNorm() / std::max(area.dot(d), least_cosine * area.norm() * d.norm());
    face.cross = area - face.transmissibility * d;
}

void close_cells(const MultiBlock& grid, SubFaceJoints& joints)
{
    const OpenCells open(grid, joints);
    if (!open.empty()) open.apply(open.changes());
}

void require_closed_cells(const MultiBlock& grid, const SubFaceJoints& joints)
{
    for (const OpenCell& c : open_cells(grid, joints))
        core::require<ConfigError>(false, text("cell (", c.cell.i, ", ", c.cell.j, ", ", c.cell.k, ") of block ", c.block,
                                               " cannot be closed: its faces and sub-faces leave ", c.open.norm() / c.largest,
                                               " of a face open; let points match where curved interfaces meet, or refine there"));
}

} // namespace core
