// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/world_pictures.hpp"
#include "core/comm/reduce.hpp"
#include "core/grid/surface.hpp"
#include "io/build/grid_builder.hpp"
#include "io/build/wall_shapes.hpp"
#include "io/files/mesh_nodes.hpp"
#include "io/picture/picture_slice.hpp"
#include "io/run/gathered_particles.hpp"
#include "io/run/world_walls.hpp"
#include "physics/fluid/cell_loops.hpp"
#include <cmath>
#include <cstring>
#include <fmt/format.h>

namespace io {
namespace {

Surface wall_of(const core::Mesh& mesh, const PictureFrame& frame)
{
    double shortest = std::numeric_limits<double>::infinity();
    for (const core::Vec3& period : mesh.periods()) shortest = std::min(shortest, period.norm());
    // Less than nothing beyond the ends, so that rounding adds no image of a face that just touches them.
    const double margin = std::isfinite(shortest) ? -1e-6 * shortest : 0.0;
    const core::Surface surface = core::boundary_surface(mesh, wall_names(mesh), margin);
    Surface wall;
    for (const core::Vec3& x : surface.vertices) wall.points.push_back(frame(x));
    for (const auto& [a, b, c, d] : surface.quads) {
        wall.triangles.push_back({a, b, c});
        wall.triangles.push_back({a, c, d});
    }
    return wall;
}

std::vector<LegendEntry> legend_of(const Scene& scene)
{
    std::vector<LegendEntry> legend;
    for (std::size_t n = 0; n < scene.particles.size(); ++n) {
        const Species& species = scene.particles[n];
        std::string text = species.name;
        if (has_sizes(species)) {
            const auto [smallest, largest] = size_range(species);
            text += fmt::format(": {}{:.3g}", species.inflow ? "" : fmt::format("{} x ", *species.count), 1e3 * smallest);
            text += largest > smallest ? fmt::format("-{:.3g} mm", 1e3 * largest) : " mm";
        }
        legend.push_back({species_colour(int(n)), text});
    }
    return legend;
}

/// Time, and what part of the period of a drive that turns round: T = 4 U rho / G, or 1 / f.
std::string time_text(const Scene& scene, double time)
{
    std::string text = fmt::format("t = {:.4f} s", time);
    if (!scene.fluid || !scene.fluid->drive) return text;
    const Drive& drive = *scene.fluid->drive;
    double period = 0;
    if (drive.frequency) period = 1.0 / *drive.frequency;
    if (drive.over_time && drive.over_time->frequency) period = 1.0 / *drive.over_time->frequency;
    if (drive.reverse_at && drive.pressure_gradient)
        period = 4.0 * drive.reverse_at->axis_speed * scene.fluid->material.density / std::abs(*drive.pressure_gradient);
    return period > 0 ? text + fmt::format("    t/T = {:.2f}", time / period) : text;
}

/// The fluid's speed in the cells of a block.
core::Array3<double> speed_on(const physics::FluidState& state, core::LocalBlock b)
{
    const auto u = state.velocity.on(b);
    core::Array3<double> speed(u.x.extents());
    physics::map_cells(
        speed.view(), [](double x, double y, double z) { return std::sqrt(x * x + y * y + z * z); }, u.x, u.y, u.z);
    return speed;
}

ColourBar speed_bar(const World& world)
{
    const double largest = core::max_over_blocks(world.mesh(), world.ranks(), [&](core::LocalBlock b) {
        const auto speed = speed_on(world.fluid()->state(), b);
        return *std::max_element(speed.data().begin(), speed.data().end());
    });
    const auto& drive = world.scene().fluid->drive;
    const double limit = drive && drive->reverse_at ? drive->reverse_at->axis_speed : largest;
    return {"fluid speed [m/s]", 0.0, std::max(limit, 1e-12)};
}

} // namespace

WorldPictures::WorldPictures(const World& world, std::filesystem::path folder, const PictureStyle& style)
    : folder_(std::move(folder)), style_(style), frame_(picture_frame(world.scene()))
{
    if (!world.fluid()) style_.slice = PictureStyle::Slice::none;
    else if (!world.grains()) style_.slice = PictureStyle::Slice::speed; // or there is nothing to see
    if (world.ranks().rank() != 0) return;
    still_.camera = side_camera(world.scene(), frame_, double(style_.width) / style_.height);
    const auto& contact = world.scene().contact;
    if (!contact || contact->walls != WallShape::none) still_.walls.push_back(wall_of(world.mesh(), frame_));
    for (const WallKeys& wall : world.scene().walls)
        if (const auto triangles = triangles_of(wall); !triangles.empty())
            own_walls_.push_back({motion_of(wall, core::Vec3::Zero()), physics::joined_triangles(triangles)});
    still_.caption.title = world.scene().name;
    still_.caption.legend = legend_of(world.scene());
    std::error_code ignored; // a folder that cannot be made is an error of the first picture
    std::filesystem::create_directories(folder_, ignored);
    worker_ = std::make_unique<PictureWorker>(style_.width, style_.height);
}

Surface WorldPictures::OwnWall::at(double time, const PictureFrame& frame) const
{
    const physics::WallPose pose = motion.at(time);
    Surface shown;
    for (const core::Vec3& x : mesh.vertices) shown.points.push_back(frame(pose.place(x)));
    shown.triangles = mesh.triangles;
    return shown;
}

void WorldPictures::draw(const World& world, std::int64_t number)
{
    PictureScene picture = still_;
    const bool sliced = style_.slice == PictureStyle::Slice::speed;
    if (sliced) {
        picture.caption.bar = speed_bar(world);
        picture.quads = slice(world, *picture.caption.bar);
    }
    const auto particles = world.grains() ? gather_particles(*world.grains(), world.ranks()) : std::vector<GatheredParticle>{};
    if (!worker_) return;
    const float plane = frame_(0.5 * (world.scene().grid.low() + world.scene().grid.high()))[2];
    for (const GatheredParticle& p : particles) {
        const auto [x, y, z] = frame_({p.position[0], p.position[1], p.position[2]});
        if (!sliced || z < plane) picture.spheres.push_back({x, y, z, float(p.radius), species_colour(int(p.species))});
    }
    for (const OwnWall& wall : own_walls_) picture.walls.push_back(wall.at(world.time(), frame_));
    picture.caption.detail = time_text(world.scene(), world.time());
    worker_->submit(std::move(picture), (folder_ / fmt::format("frame_{:06}.png", number)).string());
}

std::vector<ColouredQuad> WorldPictures::slice(const World& world, const ColourBar& bar) const
{
    const Plane plane{0.5 * (world.scene().grid.low() + world.scene().grid.high()), frame_.axes.row(2).transpose()};
    const auto nodes = nodes_of(world.mesh());
    std::vector<ColouredQuad> mine;
    for (core::LocalBlock b = 0; b < world.mesh().own_count(); ++b) {
        const auto speed = speed_on(world.fluid()->state(), b);
        for (ColouredQuad quad : cut(nodes[std::size_t(b)], speed.view(), plane, bar)) {
            for (auto& corner : quad.corners) corner = frame_({corner[0], corner[1], corner[2]});
            mine.push_back(quad);
        }
    }
    std::vector<std::vector<std::byte>> to(std::size_t(world.ranks().size()));
    const auto bytes = std::as_bytes(std::span<const ColouredQuad>(mine));
    to[0].assign(bytes.begin(), bytes.end());
    std::vector<ColouredQuad> all;
    for (const auto& part : world.ranks().exchange_all(to)) {
        const std::size_t old = all.size();
        all.resize(old + part.size() / sizeof(ColouredQuad));
        if (!part.empty()) std::memcpy(all.data() + old, part.data(), part.size());
    }
    return all;
}

void WorldPictures::finish()
{
    if (worker_) worker_->finish();
}

std::string WorldPictures::take_warning()
{
    const std::string error = worker_ ? worker_->take_error() : std::string();
    return error.empty() ? error : "no pictures: " + error;
}

} // namespace io
