// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/study/study_error.hpp"
#include "core/base/error.hpp"
#include "core/comm/reduce.hpp"
#include "io/run/initial_flow.hpp"
#include "io/run/metric_groups.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace io {
namespace {

constexpr int samples = 20;

physics::WomersleyFlow exact_flow(const Scene& scene)
{
    const Drive& drive = *scene.fluid->drive;
    return physics::WomersleyFlow({scene.grid.pipe->diameter / 2, scene.fluid->material.viscosity,
                                   *drive.pressure_gradient / scene.fluid->material.density, 2 * std::numbers::pi * *drive.frequency});
}

double radius(const core::Vec3& x) { return std::hypot(x.y(), x.z()); }

} // namespace

WomersleyError::WomersleyError(World& world, int periods) : world_(world), start_((periods - 1) / *world.scene().fluid->drive->frequency)
{
    const physics::WomersleyFlow flow = exact_flow(world.scene());
    start_from(world, [&](const core::Vec3& x) { return core::Vec3(flow.velocity(radius(x), 0.0), 0, 0); });
    for (core::LocalBlock b = 0; b < world.mesh().own_count(); ++b) {
        auto& amplitudes = exact_.emplace_back();
        const core::BlockGeometry& g = world.mesh().geometry(b);
        core::for_each_cell(g.cells, [&](int i, int j, int k) { amplitudes.push_back(flow.amplitude(radius(g.centre(i, j, k)))); });
    }
}

void WomersleyError::after_step()
{
    const double omega = 2 * std::numbers::pi * *world_.scene().fluid->drive->frequency, time = world_.time();
    if (time <= start_ * (1 + 1e-9)) return;
    const std::complex<double> phase = std::polar(1.0, omega * time);
    const core::Mesh& mesh = world_.mesh();
    const auto visit = [&](core::LocalBlock b, auto body) {
        const auto u = world_.fluid()->state().velocity.on(b);
        auto amplitude = exact_[std::size_t(b)].begin();
        core::for_each_cell(mesh.geometry(b).cells, [&](int i, int j, int k) {
            const double expected = std::real(*amplitude++ * phase);
            body(mesh.geometry(b).volume(i, j, k), core::Vec3(u.x(i, j, k) - expected, u.y(i, j, k), u.z(i, j, k)).norm(),
                 std::abs(expected));
        });
    };
    const auto sum = [&](auto term) {
        return core::sum_over_blocks(mesh, world_.ranks(), [&](core::LocalBlock b) {
            double total = 0;
            visit(b, [&](double volume, double error, double expected) { total += volume * term(error, expected); });
            return total;
        });
    };
    const auto largest = [&](auto term) {
        return core::max_over_blocks(mesh, world_.ranks(), [&](core::LocalBlock b) {
            double most = 0;
            visit(b, [&](double, double error, double expected) { most = std::max(most, term(error, expected)); });
            return most;
        });
    };
    squares_ += sum([](double error, double) { return error * error; });
    exact_squares_ += sum([](double, double expected) { return expected * expected; });
    worst_ = std::max(worst_, largest([](double error, double) { return error; }));
    largest_ = std::max(largest_, largest([](double, double expected) { return expected; }));
}

ErrorNorms WomersleyError::norms() const { return {std::sqrt(squares_ / exact_squares_), worst_ / largest_}; }

std::vector<double> WomersleyError::trace() const
{
    std::vector<double> values;
    for (core::LocalBlock b = 0; b < world_.mesh().own_count(); ++b) {
        const auto u = world_.fluid()->state().velocity.on(b);
        core::for_each_cell(world_.mesh().geometry(b).cells, [&](int i, int j, int k) { values.push_back(u.x(i, j, k)); });
    }
    return values;
}

SampledCurves::SampledCurves(World& world) : world_(world)
{
    const Scene& scene = world.scene();
    if (world.fluid() && scene.fluid->drive) groups_.push_back(drive_metrics(world));
    if (world.grains() && scene.gravity) groups_.push_back(height_metrics(world));
    core::require<core::ConfigError>(!groups_.empty(), "error: self needs a scene with a drive, or with particles and gravity");
    before_ = values();
}

std::vector<double> SampledCurves::values() const
{
    std::vector<double> all;
    for (const MetricGroup& group : groups_) {
        const auto row = group.values();
        for (std::size_t n = 0; n < row.size(); ++n)
            if (group.names[n] == "axis_speed" ||
                (group.names[n].starts_with("mean_height_") && !group.names[n].starts_with("mean_height_error_")))
                all.push_back(row[n]);
    }
    return all;
}

void SampledCurves::after_step()
{
    const std::vector<double> now = values();
    const double time = world_.time(), every = world_.scene().run.until / samples;
    for (; next_ <= samples && next_ * every <= time * (1 + 1e-9); ++next_) {
        const double share = (next_ * every - time_before_) / (time - time_before_);
        for (std::size_t n = 0; n < now.size(); ++n) trace_.push_back((1 - share) * before_[n] + share * now[n]);
    }
    before_ = now;
    time_before_ = time;
}

ErrorNorms difference(const std::vector<double>& trace, const std::vector<double>& reference)
{
    double squares = 0, worst = 0, largest = 0;
    for (std::size_t n = 0; n < reference.size(); ++n) {
        const double error = std::abs(trace[n] - reference[n]);
        squares += error * error;
        worst = std::max(worst, error);
        largest = std::max(largest, std::abs(reference[n]));
    }
    if (largest == 0) return {};
    return {std::sqrt(squares / double(reference.size())) / largest, worst / largest};
}

} // namespace io
