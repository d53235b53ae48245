// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Checks of a scene's walls that need several keys.
#include "core/base/error.hpp"
#include "io/build/wall_shapes.hpp"
#include "io/scene/scene_reader.hpp"
#include "physics/particles/triangle_mesh.hpp"

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

void check_shape(const WallKeys& wall, const std::string& path, const Locations& locations, Problems& problems)
{
    if (wall.tube && locations.good(path + ".tube") && wall.tube->from == wall.tube->to)
        problems.add(locations.at(path + ".tube.to"), "the axis of the tube has no length", "give two different points");
    if (wall.disc && locations.good(path + ".disc") && wall.disc->hole >= wall.disc->radius)
        problems.add(locations.at(path + ".disc.hole"), "the hole leaves nothing of the disc", "make it smaller than the radius");
}

} // namespace

void read_wall_files(std::vector<WallKeys>& walls, const std::filesystem::path& folder, Locations& locations, Problems& problems)
{
    for (std::size_t n = 0; n < walls.size(); ++n) {
        const std::string path = fmt::format("walls.{}.stl.file", n);
        if (!walls[n].stl || !locations.good(path)) continue;
        std::string& file = walls[n].stl->file;
        file = std::filesystem::absolute(folder / file).lexically_normal().string();
        try {
            const physics::TriangleMesh mesh = physics::joined_triangles(triangles_of(walls[n]));
            const auto rim = walls[n].stl->particles ? physics::rim_of(mesh) : std::nullopt;
            if (rim)
                problems.add(
                    locations.at(fmt::format("walls.{}.stl.particles", n)),
                    fmt::format("the surface is open at ({:.6g}, {:.6g}, {:.6g}) m: it has no inside", rim->x(), rim->y(), rim->z()),
                    "remove it, or close the surface");
        } catch (const core::ConfigError& error) {
            problems.add(locations.at(path), error.what(), "");
            locations.spoil(path);
        }
    }
}

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
        check_shape(wall, path, locations, problems);
        if (wall.motion) check_motion(*wall.motion, path + ".motion", locations, problems);
    }
}

} // namespace io
