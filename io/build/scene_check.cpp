// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Checks of a scene that need several keys.
#include "io/build/coupling_builder.hpp"
#include "io/scene/scene_reader.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace io {

namespace {

class SceneChecker {
public:
    SceneChecker(const Scene& scene, const Locations& locations, Problems& problems)
        : scene_(scene), locations_(locations), problems_(problems)
    {
    }

    void check()
    {
        if (!scene_.fluid && !locations_.given("particles"))
            complain("", "the scene has neither 'fluid' nor 'particles'", "add one of them");
        if (scene_.fluid) check_boundaries(scene_, locations_, problems_);
        if (scene_.fluid && scene_.fluid->drive) check_drive(*scene_.fluid->drive);
        if (scene_.grid.turn) check_turn(scene_, locations_, problems_);
        check_particles(scene_, locations_, problems_);
        check_company();
        check_walls(scene_, locations_, problems_);
        check_contact(scene_, locations_, problems_);
        if (scene_.coupling) check_filter(*scene_.coupling);
        if (is_one_way(scene_)) check_one_way(*scene_.coupling);
        if (scene_.run.time_step && all_good({"run.time_step", "run.until"}) && *scene_.run.time_step > scene_.run.until)
            complain("run.time_step", "the time step is longer than the run", "make it shorter than run.until");
    }

private:
    void complain(const std::string& path, const std::string& message, const std::string& hint)
    {
        problems_.add(locations_.at(path), message, hint);
    }

    [[nodiscard]] bool all_good(const std::vector<std::string>& paths) const
    {
        return std::all_of(paths.begin(), paths.end(), [&](const auto& path) { return locations_.good(path); });
    }

    void check_drive(const Drive& drive)
    {
        const std::string path = "fluid.drive";
        const int axis = drive.axis == Axis::axial ? 0 : static_cast<int>(drive.axis) - 1;
        if (all_good({path + ".axis", "grid.periodic"}) && !scene_.grid.is_periodic(axis))
            complain(locations_.given(path + ".axis") ? path + ".axis" : path,
                     fmt::format("the drive acts along {}, which is not periodic", axis_words[std::size_t(axis) + 1]),
                     "add the axis to grid.periodic");
        if (drive.frequency && drive.reverse_at) complain(path + ".reverse_at", "'reverse_at' excludes 'frequency'", "keep one of the two");
        if (drive.over_time) check_drive_over_time(drive);
        if (drive.reverse_at && !drive.pressure_gradient && all_good({path}))
            complain(path + ".reverse_at", "'reverse_at' needs 'pressure_gradient'", "remove it, or give the gradient");
        if (drive.flow_rate || drive.bulk_velocity) check_prescribed_flow(path);
        if (drive.reverse_at && locations_.good(path + ".pressure_gradient") && drive.pressure_gradient == 0.0)
            complain(path + ".pressure_gradient", "without a gradient the flow never reverses", "write a gradient other than 0");
        if (drive.reverse_at && !scene_.grid.pipe && locations_.good("grid"))
            complain(path + ".reverse_at", fmt::format("'reverse_at' watches the axis of a pipe, and this is a {}", scene_.grid.shape()),
                     "use 'frequency', or grid.pipe");
    }

    void check_drive_over_time(const Drive& drive)
    {
        const std::string path = "fluid.drive.over_time";
        if (drive.frequency)
            complain(path, "'over_time' excludes 'frequency'", "keep one of the two; over_time has a frequency of its own");
        if (drive.reverse_at) complain(path, "'over_time' excludes 'reverse_at'", "keep one of the two");
        if (locations_.good("run.until")) check_course(*drive.over_time, path, scene_.run.until, locations_, problems_);
    }

    /// The same must flow through all sections.
    void check_prescribed_flow(const std::string& path)
    {
        for (const Boundary& boundary : scene_.fluid->boundaries)
            if (boundary.kind == BoundaryKind::inflow || physics::gives_pressure(boundary.kind))
                complain(path, fmt::format("a flow cannot be prescribed where fluid also goes through '{}'", boundary.at),
                         "give a pressure_gradient, or make that boundary a wall");
    }

    /// Keys that need others, and keys that would do nothing.
    void check_company()
    {
        const bool particles = !scene_.particles.empty() || locations_.given("particles");
        if (particles && scene_.contact && scene_.contact->walls == WallShape::primitive && !scene_.grid.is_primitive())
            complain("contact.walls", fmt::format("grid.{} is neither the exact pipe nor the exact box", scene_.grid.shape()),
                     "write walls: faces");
        if (particles && !scene_.contact) complain("particles", "particles need 'contact'", "add contact: { stiffness: 5 kN/m }");
        if (!particles && scene_.contact) complain("contact", "'contact' does nothing without 'particles'", "remove it, or add particles");
        if (!particles && scene_.output.energy_budget == EnergyBudget::kept)
            complain("output.energy_budget", "'energy_budget' does nothing without 'particles'", "remove it, or add particles");
        check_bed_measures(particles);
        if (scene_.coupling && (!particles || !scene_.fluid))
            complain("coupling", "'coupling' needs both 'fluid' and 'particles'", "remove it, or add what is missing");
        if (scene_.coupling && scene_.coupling->dispersion == Switch::on && scene_.fluid && !scene_.fluid->is_turbulent())
            complain("coupling.dispersion", "'dispersion' needs a model of turbulence, whose fluctuations spread the particles",
                     "add fluid.turbulence: { model: k-epsilon }, or remove it");
    }

    void check_bed_measures(bool particles)
    {
        using enum GrainMeasure;
        for (const GrainMeasure what : {transport, segregation, profile})
            if (particles && scene_.measures(what) && !scene_.gravity)
                complain("output.grains",
                         fmt::format("'{}' needs 'gravity', which says what lies above a bed", grain_measure_words[std::size_t(what)]),
                         "remove it, or add gravity");
        if (particles && scene_.measures(profile) && scene_.output.results.clock == Interval::Clock::never)
            complain("output.grains", "'profile' needs 'output.results', which says when it is written", "add results: every 0.1 s");
    }

    /// What says something of grains that the fluid feels.
    void check_one_way(const Coupling& coupling)
    {
        const auto refuse = [&](const char* key, const char* reason) {
            complain(fmt::format("coupling.{}", key), fmt::format("'feedback: one_way' excludes '{}': {}", key, reason),
                     "remove one of the two");
        };
        if (coupling.mode != CouplingMode::automatic) refuse("mode", "the fluid waits for nobody");
        if (coupling.own_disturbance == Switch::on) refuse("own_disturbance", "no particle disturbs the fluid");
        if (coupling.size_mixture == Switch::on) refuse("size_mixture", "drag is that of a particle alone");
        if (coupling.added_mass == AddedMass::zuber) refuse("added_mass", "added mass is that of a particle alone; 'on' is that");
    }

    void check_filter(const Coupling& coupling)
    {
        if (!all_good({"coupling.filter", "grid", "particles"})) return;
        double width = coupling.filter.value;
        double largest = 0.0;
        for (const Species& species : scene_.particles) {
            if (!has_sizes(species)) return;
            largest = std::max(largest, size_range(species)[1]);
        }
        if (coupling.filter.in_diameters) width *= largest;
        const core::Vec3 domain = scene_.grid.high() - scene_.grid.low();
        if (width > 0.5 * domain.minCoeff())
            complain("coupling.filter", fmt::format("a filter of {} m is wider than half of the domain", number_text(width)),
                     fmt::format("the domain is {} m wide", number_text(domain.minCoeff())));
    }

    const Scene& scene_;
    const Locations& locations_;
    Problems& problems_;
};

} // namespace

void check_scene(const Scene& scene, const Locations& locations, Problems& problems) { SceneChecker(scene, locations, problems).check(); }

} // namespace io
