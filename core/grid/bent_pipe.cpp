// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/bent_pipe.hpp"
#include "core/base/error.hpp"

namespace core {
namespace {

/// A place on the axis: the point, and the directions along the pipe and in its section as columns.
struct Station {
    Vec3 point = Vec3::Zero();
    Mat3 frame = Mat3::Identity();
};

/// The station at `share` of a piece that starts at `from`.
Station along(const PipePiece& piece, const Station& from, double share)
{
    const Vec3 ahead = from.frame.col(0);
    if (piece.angle == 0) return {from.point + share * piece.length * ahead, from.frame};
    const Vec3 inward = (piece.towards - piece.towards.dot(ahead) * ahead).normalized();
    const Mat3 turn = Eigen::AngleAxisd(share * piece.angle, ahead.cross(inward)).toRotationMatrix();
    const Vec3 centre = from.point + piece.radius * inward;
    return {centre + turn * (from.point - centre), turn * from.frame};
}

void check_piece(const BentPipe& pipe, std::size_t n, const Vec3& ahead)
{
    const PipePiece& p = pipe.pieces[n];
    const std::string name = text("piece ", n, " of the bent pipe");
    require<ConfigError>(p.cells > 0 && p.blocks > 0 && p.cells % p.blocks == 0,
                         text(name, ": ", p.cells, " cells do not divide into ", p.blocks, " blocks"));
    if (p.angle == 0) return require<ConfigError>(p.length > 0, name + " needs a length or an angle");
    require<ConfigError>(p.angle > 0 && p.length == 0, name + " has a length and an angle: it is straight or an arc");
    require<ConfigError>(p.radius > pipe.diameter / 2, text(name, ": an arc of radius ", p.radius,
                                                            " m is tighter than the pipe, whose radius is ", pipe.diameter / 2, " m"));
    require<ConfigError>(p.towards.cross(ahead).norm() > 1e-6 * p.towards.norm() && p.towards.norm() > 0,
                         name + " bends along its own axis: 'towards' must point to a side of the pipe");
}

Vertices swept(const BentPipe& pipe, int part, const std::vector<Station>& stations)
{
    const auto cells = butterfly_cells(pipe, part);
    Vertices v({int(stations.size()), cells[0] + 1, cells[1] + 1}, 0, Vec3::Zero());
    for_each_cell(v.extents(), [&](int i, int j, int k) {
        const Station& s = stations[std::size_t(i)];
        const Eigen::Vector2d yz = butterfly_point(pipe, part, j, k);
        v(i, j, k) = s.point + s.frame * Vec3(0, yz.x(), yz.y());
    });
    return v;
}

} // namespace

MultiBlock make_bent_pipe(const BentPipe& pipe)
{
    check(pipe);
    require<ConfigError>(!pipe.pieces.empty(), "a bent pipe needs at least one piece");
    MultiBlock grid;
    Station start;
    for (std::size_t n = 0; n < pipe.pieces.size(); ++n) {
        const PipePiece& piece = pipe.pieces[n];
        check_piece(pipe, n, start.frame.col(0));
        const int cells = piece.cells / piece.blocks;
        for (int block = 0; block < piece.blocks; ++block) {
            std::vector<Station> stations;
            for (int i = 0; i <= cells; ++i) stations.push_back(along(piece, start, double(block * cells + i) / piece.cells));
            for (int part = 0; part < butterfly_parts; ++part) grid.blocks.push_back(swept(pipe, part, stations));
        }
        start = along(piece, start, 1);
    }
    if (pipe.periodic) {
        require<ConfigError>((start.frame - Mat3::Identity()).norm() < 1e-9,
                             "the ends of a periodic pipe must look the same way: its arcs do not add up to none");
        if (start.point.norm() > 1e-9 * pipe.diameter) grid.periods.push_back(start.point);
    }
    grid.boundary_name = [](BlockId, Side s) { return std::string(s == Side::i_low ? "start" : s == Side::i_high ? "end" : "wall"); };
    return grid;
}

} // namespace core
