// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/picture/picture_light.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace io::detail {
namespace {

constexpr float reach = 3.0f; // neighbours farther than this many largest radii cover less than 3 % of the sky each

struct Bin {
    std::uint64_t key = 0;
    std::size_t sphere = 0;
    auto operator<=>(const Bin&) const = default;
};

std::uint64_t key_of(std::array<std::int64_t, 3> cell)
{
    constexpr std::uint64_t mask = (1u << 21) - 1;
    return (std::uint64_t(cell[0]) & mask) << 42 | (std::uint64_t(cell[1]) & mask) << 21 | (std::uint64_t(cell[2]) & mask);
}

std::array<std::int64_t, 3> cell_of(const Sphere& s, float size)
{
    return {std::int64_t(std::floor(s.x / size)), std::int64_t(std::floor(s.y / size)), std::int64_t(std::floor(s.z / size))};
}

void add_cover(const Sphere& from, const Sphere& by, float cutoff, std::array<float, 4>& sky)
{
    const float d[3] = {by.x - from.x, by.y - from.y, by.z - from.z};
    const float distance = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    if (distance >= cutoff || distance <= 0.0f) return;
    const float fade = 1.0f - distance / cutoff, share = by.radius * by.radius / (distance * distance) * std::min(1.0f, 2.0f * fade);
    for (std::size_t c = 0; c < 3; ++c) sky[c] += 0.5f * share * d[c] / distance;
    sky[3] += 0.25f * share;
}

} // namespace

std::vector<std::array<float, 4>> covered_sky(const std::vector<Sphere>& spheres)
{
    std::vector<std::array<float, 4>> sky(spheres.size(), {0, 0, 0, 0});
    float largest = 0.0f;
    for (const Sphere& s : spheres) largest = std::max(largest, s.radius);
    if (largest <= 0.0f) return sky;
    const float size = reach * largest;
    std::vector<Bin> bins;
    for (std::size_t n = 0; n < spheres.size(); ++n) bins.push_back({key_of(cell_of(spheres[n], size)), n});
    std::sort(bins.begin(), bins.end());
    for (std::size_t n = 0; n < spheres.size(); ++n) {
        const auto home = cell_of(spheres[n], size);
        for (int neighbour = 0; neighbour < 27; ++neighbour) {
            const auto key = key_of({home[0] + neighbour % 3 - 1, home[1] + neighbour / 3 % 3 - 1, home[2] + neighbour / 9 - 1});
            for (auto bin = std::lower_bound(bins.begin(), bins.end(), Bin{key, 0}); bin != bins.end() && bin->key == key; ++bin)
                if (bin->sphere != n) add_cover(spheres[n], spheres[bin->sphere], size, sky[n]);
        }
    }
    return sky;
}

} // namespace io::detail
