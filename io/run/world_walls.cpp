// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/world_walls.hpp"
#include "core/base/error.hpp"
#include "core/grid/surface.hpp"
#include "io/build/grid_builder.hpp"
#include "io/build/wall_shapes.hpp"
#include "physics/particles/triangle_mesh.hpp"
#include <numbers>

namespace io {
namespace {

physics::WallSide side_of(WallSide side) { return side == WallSide::inside ? physics::WallSide::inside : physics::WallSide::outside; }

} // namespace

physics::WallMotion motion_of(const WallKeys& keys, const core::Vec3& origin)
{
    physics::WallMotion motion;
    motion.axis_point = point_of(keys) - origin;
    if (!keys.motion) return motion;
    const MotionKeys& given = *keys.motion;
    motion.velocity = given.velocity.value_or(core::Vec3::Zero());
    if (const auto& turn = given.rotation) {
        motion.axis_point = turn->point - origin;
        motion.angular_velocity = turn->rate * turn->axis;
    }
    if (const auto& sway = given.oscillation) {
        motion.amplitude = sway->amplitude;
        motion.angular_frequency = 2 * std::numbers::pi * sway->frequency;
        motion.phase = sway->phase;
    }
    motion.start = given.start;
    if (given.stop) motion.stop = *given.stop;
    return motion;
}

std::vector<physics::Wall> own_walls(const Scene& scene, const core::Vec3& origin)
{
    const WallMaterials materials(scene);
    std::vector<physics::Wall> made;
    for (std::size_t n = 0; n < scene.walls.size(); ++n) {
        const WallKeys& wall = scene.walls[n];
        const physics::WallMotion motion = motion_of(wall, origin);
        const int material = materials.of(wall);
        if (const auto& p = wall.plane) made.push_back(physics::PlaneWall{p->point - origin, p->normal, motion, int(n), material});
        if (const auto& c = wall.cylinder)
            made.push_back(physics::CylinderWall{c->point - origin, c->axis, c->radius, side_of(c->particles), motion, int(n), material});
    }
    return made;
}

std::vector<physics::Wall> primitive_walls(const Scene& scene, const core::Domain& domain)
{
    std::vector<physics::Wall> walls;
    if (scene.contact->walls == WallShape::primitive) walls = primitive_walls(scene.grid, WallMaterials(scene));
    const auto own = own_walls(scene, domain.origin);
    walls.insert(walls.end(), own.begin(), own.end());
    return walls;
}

void add_own_surfaces(const Scene& scene, physics::ParticleDynamics& dynamics)
{
    const std::vector<WallKeys>& walls = scene.walls;
    const WallMaterials materials(scene);
    const core::Vec3 origin = dynamics.domain().origin;
    for (std::size_t n = 0; n < walls.size(); ++n) {
        auto triangles = triangles_of(walls[n]);
        if (triangles.empty()) continue;
        for (auto& corners : triangles)
            for (core::Vec3& x : corners) x -= origin;
        const auto mesh = physics::joined_triangles(triangles);
        dynamics.add_surface({mesh, smooth_angle_of(walls[n]), materials.of(walls[n])}, motion_of(walls[n], origin), int(n));
        if (walls[n].stl && walls[n].stl->particles) dynamics.set_side({mesh, side_of(*walls[n].stl->particles)});
    }
    dynamics.report_walls(int(walls.size()));
}

std::vector<physics::Wall> walls_at_start(const Scene& scene, const core::Domain& domain)
{
    std::vector<physics::Wall> walls = primitive_walls(scene, domain);
    if (scene.contact->walls == WallShape::faces) {
        const auto grid = primitive_walls(scene.grid, WallMaterials(scene));
        walls.insert(walls.end(), grid.begin(), grid.end());
    }
    return walls;
}

physics::Obstacles obstacles_of(const std::vector<physics::Wall>& walls, const physics::ParticleDynamics& dynamics)
{
    if (!dynamics.has_surfaces()) return {walls};
    return {walls,
            [&dynamics](const core::Vec3& x, double r) { return dynamics.surface_at(x, r) >= 0 || dynamics.surface_around(x) >= 0; }};
}

physics::WallSurface grid_surface(double largest, const core::Mesh& mesh, const core::Domain& domain, const WallMaterials& materials)
{
    constexpr double smooth_angle = 0.6; // [rad]; a pipe of 12 faces or more is round, the edges of a box are sharp
    const std::vector<std::string> names = wall_names(mesh);
    core::Surface surface = core::boundary_surface(mesh, names, 2 * largest);
    for (core::Vec3& x : surface.vertices) x -= domain.origin;
    std::vector<int> of_name, of_face;
    for (const std::string& name : names) of_name.push_back(materials.of_side(name));
    const bool alike = std::adjacent_find(of_name.begin(), of_name.end(), std::not_equal_to()) == of_name.end();
    if (alike) of_face.assign(1, of_name.empty() ? 0 : of_name.front());
    else
        for (const int name : surface.name) of_face.push_back(of_name[std::size_t(name)]);
    return {surface.vertices, surface.quads, smooth_angle, of_face};
}

void require_inside(const core::Locator& locator, const core::Domain& domain, const std::vector<core::Sphere>& grains)
{
    constexpr double reach = 0.9, slack = 0.1; // of the radius: faces cut the arcs of curved walls
    for (const core::Sphere& grain : grains)
        core::for_each({-1, -1, -1}, {2, 2, 2}, [&](int i, int j, int k) {
            const core::Vec3 way(i, j, k);
            core::Vec3 x = grain.position + reach * grain.radius / std::max(1.0, way.norm()) * way;
            for (int a = 0; a < 3; ++a) x[a] = domain.wrapped(a, x[a]);
            x += domain.origin;
            const auto at = locator.find(x);
            core::require<core::ConfigError>(
                at && (locator.position(*at) - x).norm() < slack * grain.radius,
                core::text("particle ", grain.id, " at (", (grain.position + domain.origin).transpose(),
                           ") m does not lie in the grid as a whole: give the particles a region inside its walls"));
        });
}

void require_clear_of_walls(const std::vector<WallKeys>& walls, const std::vector<core::Sphere>& grains,
                            const physics::ParticleDynamics& dynamics)
{
    constexpr double reach = 0.9; // of the radius: beds that settled on the wall touch it
    const auto refuse = [&](const core::Sphere& grain, const char* how, int wall) {
        throw core::ConfigError(core::text("particle ", grain.id, how, walls[std::size_t(wall)].name, "' at the start, at (",
                                           (grain.position + dynamics.domain().origin).transpose(),
                                           ") m: give the particles a region that is clear of it"));
    };
    for (const core::Sphere& grain : grains) {
        if (const int wall = dynamics.surface_at(grain.position, reach * grain.radius); wall >= 0)
            refuse(grain, " sticks in the wall '", wall);
        if (const int wall = dynamics.surface_around(grain.position); wall >= 0)
            refuse(grain, " lies on the wrong side of the wall '", wall);
    }
}

void require_slow_walls(const std::vector<WallKeys>& walls, double smallest, const core::Domain& domain, double step)
{
    constexpr double largest_share = 0.1;
    for (const WallKeys& wall : walls) {
        const double way = step * motion_of(wall, domain.origin).largest_speed(domain.size.norm());
        core::require<core::ConfigError>(way <= largest_share * smallest,
                                         core::text("wall '", wall.name, "' goes up to ", way, " m in a sub-step of ", step,
                                                    " s, more than ", largest_share,
                                                    " of the smallest diameter: make it slower or the contacts stiffer"));
    }
}

} // namespace io
