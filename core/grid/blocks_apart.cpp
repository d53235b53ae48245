// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/blocks_apart.hpp"
#include "core/base/error.hpp"
#include "core/grid/trilinear.hpp"
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace core {
namespace {

using Box = Eigen::AlignedBox3d;

struct Cell {
    BlockId block;
    Index3 at;
};

template <class Visit>
void for_each_cell_of(const MultiBlock& grid, Visit visit)
{
    for (std::size_t b = 0; b < grid.blocks.size(); ++b)
        for_each_cell(cells_of(grid.blocks[b]), [&](int i, int j, int k) { visit(Cell{BlockId(b), {i, j, k}}); });
}

Box box_of(const MultiBlock& grid, const Cell& c)
{
    Box box;
    for_each(c.at, {c.at.i + 2, c.at.j + 2, c.at.k + 2},
             [&](int i, int j, int k) { box.extend(grid.blocks[std::size_t(c.block)](i, j, k)); });
    return box;
}

Vec3 centre_of(const MultiBlock& grid, const Cell& c)
{
    return TrilinearCell(grid.blocks[std::size_t(c.block)], c.at).position(Vec3::Constant(0.5));
}

bool holds(const MultiBlock& grid, const Cell& c, const Vec3& x)
{
    constexpr double margin = 1e-6; // in shares of the cell
    const auto xi = TrilinearCell(grid.blocks[std::size_t(c.block)], c.at).inverse(x, Vec3::Constant(0.5));
    return xi && xi->minCoeff() > margin && xi->maxCoeff() < 1 - margin;
}

/// The centres of all cells, sorted into equal bins of about one cell each.
class Centres {
public:
    explicit Centres(const MultiBlock& grid) : grid_(grid)
    {
        std::ptrdiff_t cells = 0;
        for (const Vertices& v : grid.blocks) {
            cells += cells_of(v).size();
            for (const Vec3& x : v.data()) domain_.extend(x);
        }
        const double edge = std::cbrt(domain_.volume() / double(cells));
        for (int m = 0; m < 3; ++m) count_[m] = std::clamp(int(domain_.sizes()[m] / edge), 1, 512);
        first_.assign(std::size_t(count_.prod()) + 1, 0);
        for_each_cell_of(grid, [&](const Cell& c) { ++first_[number(bin_of(centre_of(grid, c))) + 1]; });
        for (std::size_t n = 1; n < first_.size(); ++n) first_[n] += first_[n - 1];
        cells_.resize(std::size_t(cells));
        auto next = first_;
        for_each_cell_of(grid, [&](const Cell& c) { cells_[next[number(bin_of(centre_of(grid, c)))]++] = c; });
    }

    /// Calls visit(cell) for every cell whose centre may lie in `box`.
    template <class Visit>
    void for_each_near(const Box& box, Visit visit) const
    {
        const Eigen::Array3i low = bin_of(box.min()), high = bin_of(box.max());
        for_each({low[0], low[1], low[2]}, {high[0] + 1, high[1] + 1, high[2] + 1}, [&](int i, int j, int k) {
            const std::size_t bin = number({i, j, k});
            for (std::size_t n = first_[bin]; n < first_[bin + 1]; ++n) visit(cells_[n]);
        });
    }

private:
    [[nodiscard]] Eigen::Array3i bin_of(const Vec3& x) const
    {
        Eigen::Array3i bin;
        for (int m = 0; m < 3; ++m)
            bin[m] = int(std::clamp((x[m] - domain_.min()[m]) / domain_.sizes()[m] * count_[m], 0.0, double(count_[m] - 1)));
        return bin;
    }
    [[nodiscard]] std::size_t number(const Eigen::Array3i& bin) const
    {
        return std::size_t(bin[0] + std::ptrdiff_t(count_[0]) * (bin[1] + std::ptrdiff_t(count_[1]) * bin[2]));
    }

    const MultiBlock& grid_;
    Box domain_;
    Eigen::Array3i count_;
    std::vector<std::size_t> first_; ///< of each bin in cells_
    std::vector<Cell> cells_;
};

std::string words(const Cell& c) { return text("cell (", c.at.i, ", ", c.at.j, ", ", c.at.k, ") of block ", c.block); }

} // namespace

void require_apart(const MultiBlock& grid)
{
    if (grid.blocks.size() < 2) return;
    const Centres centres(grid);
    for_each_cell_of(grid, [&](const Cell& c) {
        const Box box = box_of(grid, c);
        centres.for_each_near(box, [&](const Cell& other) {
            if (other.block == c.block) return;
            const Vec3 x = centre_of(grid, other);
            require<ConfigError>(!box.contains(x) || !holds(grid, c, x),
                                 text("blocks ", std::min(c.block, other.block), " and ", std::max(c.block, other.block), " overlap: ",
                                      words(c), " holds the centre (", x.x(), " ", x.y(), " ", x.z(), ") m of ", words(other)));
        });
    });
}

} // namespace core
