// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The books of momentum of a coupled world: what fluid and grains have, what they are still owed, and which impulses of a
// step explain the change. Every line is measured by itself, none as what the others leave: what is unexplained in the end
// is a true check of all of them.
#include "io/run/world.hpp"

namespace io {

/// Of the whole domain, at one time [N s].
struct MomentumTotals {
    core::Vec3 fluid = core::Vec3::Zero();  ///< sum of rho phi u V
    core::Vec3 ledger = core::Vec3::Zero(); ///< sum of L V: owed to the fluid
    core::Vec3 grains = core::Vec3::Zero(); ///< sum of m v
    core::Vec3 owed = core::Vec3::Zero();   ///< to the grains
    [[nodiscard]] core::Vec3 sum() const { return fluid + ledger + grains + owed; }
};

/// Of the last step [N s].
struct MomentumImpulses {
    core::Vec3 drive = core::Vec3::Zero();         ///< on fluid and grains, by volume
    core::Vec3 weight = core::Vec3::Zero();        ///< of the grains, less buoyancy
    core::Vec3 contact = core::Vec3::Zero();       ///< of walls on grains: pairs cancel
    core::Vec3 wall_pressure = core::Vec3::Zero(); ///< from the pressure beside the walls
    core::Vec3 wall_friction = core::Vec3::Zero(); ///< from the viscous fluxes through the walls
    core::Vec3 traffic = core::Vec3::Zero();       ///< of grains that came or went before the step, and of the fluid in their place
    core::Vec3 through = core::Vec3::Zero();       ///< carried in and out through open boundaries
    /// What interpolation at departure points made or lost, fluid content included; of finite volumes round-off.
    core::Vec3 advection = core::Vec3::Zero();
    core::Vec3 gradient = core::Vec3::Zero();      ///< sum of the pressure gradients in cells beyond the walls' push: 0 on uniform grids
    core::Vec3 viscous_share = core::Vec3::Zero(); ///< mean viscous stress on grains, beyond their share of the fluid's
    core::Vec3 given = core::Vec3::Zero();         ///< by the fluid to the grains
    core::Vec3 taken = core::Vec3::Zero();         ///< by the grains, and owed to them
    /// Angular impulse of the fluid's torque on the grains [N m s]: the fluid does not lose it.
    core::Vec3 couple = core::Vec3::Zero();

    /// The lines that change the sum of momentum.
    struct Line {
        const char* name;
        core::Vec3 MomentumImpulses::*impulse;
    };
    [[nodiscard]] static std::span<const Line> outer_lines();
    [[nodiscard]] core::Vec3 outer() const;
};

class MomentumLedger {
public:
    /// Takes the totals of the present state. Collective. @pre world.coupling(), compiled
    explicit MomentumLedger(World& world);
    ~MomentumLedger() { world_.watch_traffic({}); }
    MomentumLedger(const MomentumLedger&) = delete;
    MomentumLedger& operator=(const MomentumLedger&) = delete;

    /// To be called after every step. Collective.
    void update();
    [[nodiscard]] const MomentumTotals& totals() const { return totals_; }
    [[nodiscard]] const MomentumImpulses& impulses() const { return impulses_; }
    /// Change of all momentum in the last step [N s].
    [[nodiscard]] core::Vec3 change() const { return change_; }
    /// What the lines leave of it, over the largest of its terms.
    [[nodiscard]] double defect() const { return defect(impulses_.outer()); }
    /// The same for another explanation.
    [[nodiscard]] double defect(const core::Vec3& explained) const;
    /// |given - taken| in the last step over the largest of both, the weight and the contacts with walls.
    [[nodiscard]] double exchange_defect() const;

private:
    struct CellSums;
    [[nodiscard]] CellSums sum_cells(bool with_step) const;
    void sum_step(core::LocalBlock b, std::span<double> sum) const;
    void sum_walls(core::LocalBlock b, std::span<double> sum) const;
    [[nodiscard]] MomentumTotals present() const;
    void after_traffic();
    void remember_clock();

    World& world_;
    MomentumTotals totals_;
    MomentumImpulses impulses_;
    core::Vec3 change_ = core::Vec3::Zero();
    core::Vec3 brought_ = core::Vec3::Zero(); ///< by traffic since the last step [N s]
    double time_ = 0.0;                       ///< at the start of the step to come
    double implicit_ = 1.0;                   ///< its weight of the new time in the viscous term
    physics::DriveState drive_;
};

} // namespace io
