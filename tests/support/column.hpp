// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A vertical column: grains with contacts, filtered exchange and projection, coupled as physics/coupling/response.hpp says.
#include "physics/coupling/mode.hpp"
#include "physics/coupling/predictor.hpp"
#include "physics/coupling/response.hpp"

#include <functional>
#include <vector>

namespace testing {

/// plate: grains rest on a permeable plate. periodic: they float, evenly spread over the column.
enum class Bottom { plate, periodic };

struct ColumnScene {
    double diameter = 2e-3, density_ratio = 2.65, density = 1000.0, viscosity = 1e-3; // [m], -, [kg/m3], [Pa s]
    double added_mass = 0.5, phi = 0.4, gravity = 9.81;
    double drag = 1.0; ///< factor of the drag law; 0 switches it off
    double dt = 1e-3, contact_time = 1.3e-4, restitution = 0.5;
    int layers = 10, cells = 40;
    Bottom bottom = Bottom::plate;
    physics::Mode mode = physics::Mode::pipelined;
    std::function<double(double)> flow = [](double) { return 0.0; }; ///< mixture volume flux (t) [m/s]
};

/// One stack of grains that stands for many side by side; fluid velocity and force at cell centres, periodic.
/// Grains sample with linear weights and a filter of three implicit diffusion steps of width 3 diameters.
class Column {
public:
    explicit Column(const ColumnScene& scene);
    void step();

    [[nodiscard]] double time() const { return time_; }
    [[nodiscard]] double mean_velocity() const;
    [[nodiscard]] double rms_velocity() const;
    /// Pressure drop over the column over the buoyant weight of the grains.
    [[nodiscard]] double drop_over_weight() const;
    /// Defect of total momentum over weight times time.
    [[nodiscard]] double closure() const;
    [[nodiscard]] double stiffness() const { return stiffness_; }

private:
    using Numbers = std::vector<double>;
    struct Told {
        Numbers velocity, acceleration, force;
    };
    struct Lane {
        Numbers place, velocity, contact, exchanged, share;
        double plate = 0.0;
    };
    struct Pass;
    struct Push;

    void locate(const Numbers& place);
    [[nodiscard]] Numbers sampled(const Numbers& field) const;
    [[nodiscard]] Numbers deposited(const Numbers& quantity) const;
    [[nodiscard]] Numbers filtered(Numbers field) const;
    [[nodiscard]] physics::GrainCoupling coupling_of(std::size_t i) const;
    void advect();
    [[nodiscard]] Push push_of(const Told& told, double h) const;
    void close(const Push& push, Lane& lane) const;
    [[nodiscard]] Lane advance(const Told& told, int substeps) const;
    [[nodiscard]] Lane fly(const Told& told) const;
    /// What the fluid takes the grains for.
    [[nodiscard]] Lane taken(const Told& told, const Lane& real) const;
    void contacts(const Lane& lane, Numbers& force, double& plate) const;
    [[nodiscard]] physics::GrainResponse sum_at(const std::vector<Numbers>& sums, std::size_t cell) const;
    [[nodiscard]] std::vector<Numbers> sums(const std::vector<physics::GrainResponse>& responses) const;
    [[nodiscard]] Pass couple(const Told& told);
    void finish(const Pass& pass, const Numbers& phi_before);
    [[nodiscard]] double momentum() const;

    ColumnScene scene_;
    double mass_ = 0.0, volume_ = 0.0, added_ = 0.0, weight_ = 0.0, area_ = 0.0, cell_ = 0.0, bottom_ = 0.0, top_ = 0.0;
    double spring_ = 0.0, damper_ = 0.0, time_ = 0.0, outside_ = 0.0, stiffness_ = 0.0, start_ = 0.0;
    int substeps_ = 1;
    Numbers place_, velocity_, owed_, drag_, share_, growth_;                  // grains
    Numbers u_, force_, ledger_, acceleration_, flux_, advected_, kept_, phi_; // cells
    std::vector<std::size_t> low_;                                             // lower cell of each grain
    Numbers high_weight_;
    Numbers filter_; // first row of the circulant filter
};

} // namespace testing
