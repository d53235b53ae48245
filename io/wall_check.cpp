// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Checks of a scene's walls that need several keys.
#include "io/scene_reader.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

namespace io {
namespace {

bool is_plain_word(const std::string& name)
{
    return !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_'; });
}

void check_motion(const MotionKeys& motion, const std::string& path, const Locations& locations, Problems& problems)
{
    if (!locations.good(path)) return;
    if (!motion.velocity && !motion.rotation && !motion.oscillation)
        problems.add(locations.at(path), "nothing moves this wall", "give velocity, rotation or oscillation, or remove 'motion'");
    if (motion.stop && *motion.stop <= motion.start)
        problems.add(locations.at(path + ".stop"), "the wall stops before it starts", "make 'stop' later than 'start'");
}

} // namespace

void check_walls(const Scene& scene, const Locations& locations, Problems& problems)
{
    if (locations.given("walls") && scene.particles.empty() && !locations.given("particles"))
        problems.add(locations.at("walls"), "'walls' do nothing without 'particles'", "remove them, or add particles");
    for (std::size_t n = 0; n < scene.walls.size(); ++n) {
        const WallKeys& wall = scene.walls[n];
        const std::string path = fmt::format("walls.{}", n);
        if (locations.good(path + ".name") && !is_plain_word(wall.name))
            problems.add(locations.at(path + ".name"), fmt::format("'{}' is no name for columns of metrics.csv", wall.name),
                         "use letters, digits and _");
        for (std::size_t m = 0; m < n; ++m)
            if (locations.good(path + ".name") && scene.walls[m].name == wall.name)
                problems.add(locations.at(path + ".name"), fmt::format("two walls are named '{}'", wall.name), "give each its own name");
        if (wall.motion) check_motion(*wall.motion, path + ".motion", locations, problems);
    }
}

} // namespace io
