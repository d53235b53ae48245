// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/files/plot3d_parts.hpp"
#include <charconv>
#include <fmt/format.h>

namespace io {

namespace {

using core::ConfigError, core::require;

/// One word of the text as numbers: "0.5", "1.5D-3" or "3*0.5".
void append(std::string word, const std::string& file, std::vector<double>& numbers)
{
    for (char& c : word)
        if (c == 'd' || c == 'D') c = 'e'; // Fortran's double precision
    const auto number_in = [&](std::size_t begin, std::size_t end, auto& value) {
        const char* first = word.data() + begin + (word[begin] == '+' ? 1 : 0);
        const auto [stop, error] = std::from_chars(first, word.data() + end, value);
        require<ConfigError>(error == std::errc() && stop == word.data() + end,
                             fmt::format("{}: '{}' is not a number (word {} of the file)", file, word, numbers.size() + 1));
    };
    const std::size_t star = word.find('*');
    long count = 1;
    if (star != std::string::npos) number_in(0, star, count);
    require<ConfigError>(count > 0 && count <= 1'000'000'000, fmt::format("{}: '{}' repeats {} times", file, word, count));
    double value = 0;
    require<ConfigError>(star != word.size() - 1, fmt::format("{}: '{}' repeats nothing", file, word));
    number_in(star == std::string::npos ? 0 : star + 1, word.size(), value);
    numbers.insert(numbers.end(), std::size_t(count), value);
}

[[nodiscard]] std::vector<double> numbers_of(const std::string& text, const std::string& file)
{
    constexpr auto gaps = " \t\r\n,";
    std::vector<double> numbers;
    for (std::size_t begin = text.find_first_not_of(gaps); begin != std::string::npos;) {
        const std::size_t end = std::min(text.find_first_of(gaps, begin), text.size());
        append(text.substr(begin, end - begin), file, numbers);
        begin = text.find_first_not_of(gaps, end);
    }
    return numbers;
}

/// Blocks of which `header` numbers are before the sizes; empty if the amount of numbers does not fit.
[[nodiscard]] std::vector<Plot3dBlock> split(const std::vector<double>& all, std::size_t header, std::size_t count)
{
    if (count < 1 || header + 3 * count > all.size()) return {};
    std::vector<Plot3dBlock> blocks(count);
    std::size_t points = 0;
    for (std::size_t b = 0; b < count; ++b) {
        for (int m = 0; m < 3; ++m) {
            const double n = all[header + 3 * b + std::size_t(m)];
            if (!(n >= 1 && n < 1e6) || n != std::floor(n)) return {};
            (m == 0 ? blocks[b].points.ni : m == 1 ? blocks[b].points.nj : blocks[b].points.nk) = int(n);
        }
        points += std::size_t(blocks[b].points.size());
    }
    const std::size_t rest = all.size() - header - 3 * count;
    if (rest != 3 * points && rest != 4 * points) return {};
    auto next = all.begin() + std::ptrdiff_t(header + 3 * count);
    for (auto& block : blocks) {
        const auto size = std::ptrdiff_t(rest / points) * block.points.size();
        block.numbers.assign(next, next + size);
        next += size;
    }
    return blocks;
}

} // namespace

core::Vertices vertices_of(const Plot3dBlock& block, std::size_t number, const std::string& file)
{
    const core::Extents n = block.points;
    const auto size = std::size_t(n.size());
    require<ConfigError>(
        n.ni >= 2 && n.nj >= 2 && n.nk >= 2,
        fmt::format("{}: block {} has {} x {} x {} points; each direction needs two or more", file, number, n.ni, n.nj, n.nk));
    core::Vertices vertices(n, 0, core::Vec3::Zero());
    for (std::size_t p = 0; p < size; ++p) {
        const core::Vec3 x(block.numbers[p], block.numbers[size + p], block.numbers[2 * size + p]);
        const bool blanked = block.numbers.size() > 3 * size && block.numbers[3 * size + p] == 0;
        const auto place = [&] { return fmt::format("point {} of block {}", p, number); };
        require<ConfigError>(x.allFinite(), fmt::format("{}: {} is not finite", file, place()));
        require<ConfigError>(!blanked, fmt::format("{}: {} is blanked; cut the blocks so that none is", file, place()));
        vertices.data()[p] = x;
    }
    return vertices;
}

std::vector<Plot3dBlock> read_plot3d_text(const std::string& text, const std::string& file)
{
    const std::vector<double> all = numbers_of(text, file);
    std::vector<Plot3dBlock> blocks;
    if (!all.empty() && all[0] >= 1 && all[0] < 1e6) blocks = split(all, 1, std::size_t(all[0]));
    if (blocks.empty()) blocks = split(all, 0, 1);
    require<ConfigError>(!blocks.empty(),
                         fmt::format("{}: its {} numbers are not those of a three-dimensional Plot3D grid: number of blocks, "
                                     "three sizes of each, then x, y and z of all its points",
                                     file, all.size()));
    return blocks;
}

} // namespace io
