// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// One cell of fluid and a few kinds of grains that exchange momentum exactly as physics/coupling/response.hpp says.
#include "physics/coupling/mode.hpp"
#include "physics/coupling/response.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace testing {

enum class Contact { none, locked, stick_slip, half_locked, random_clamps, spring };

/// confined: phi u + sum V v is given (compression); transverse: the fluid is driven, nothing confines it (shear).
enum class Motion { transverse, confined };

struct CellScene {
    double stiffness = 0.1;     ///< b = K dt / m
    double loading = 1.0;       ///< M = solid mass / fluid mass; phi = s / (s + M)
    double density_ratio = 2.0; ///< s; the fluid's density is 1
    double added_mass = 0.5;    ///< C_m
    double gravity = 9.81;      ///< along -v, confined only
    double friction = 9.81;     ///< stick-slip: largest contact force per grain mass [m/s2]
    double softness = 1.0;      ///< springs: K / (k dt), k their stiffness
    double dt = 1e-3;
    int substeps = 20;
    std::uint64_t seed = 1; ///< of the random clamps
    Contact contact = Contact::none;
    Motion motion = Motion::confined;
    physics::Mode mode = physics::Mode::pipelined;
    std::function<double(double)> flow = [](double) { return 0.0; }; ///< confined: volume flux(t); transverse: fluid speed without grains
};

class OneCell {
public:
    explicit OneCell(const CellScene& scene);
    void step();

    [[nodiscard]] double fluid_velocity() const { return u_; }
    [[nodiscard]] double grain_velocity(std::size_t kind) const { return grains_[kind].velocity; }
    [[nodiscard]] double force() const { return force_; }
    [[nodiscard]] double phi() const { return phi_; }
    [[nodiscard]] double fastest() const;
    /// Momentum of fluid, grains, owed impulses and ledger less all that came from outside, over the momentum exchanged.
    [[nodiscard]] double closure() const;

private:
    struct Grain {
        physics::GrainCoupling coupling;
        double velocity = 0.0, owed = 0.0, share = 0.0, place = 0.0, told = 0.0;
        bool clamped = false;
    };
    struct Told {
        double velocity = 0.0, acceleration = 0.0, force = 0.0;
        bool repeated = false; ///< the pass: held grains are told all
    };
    struct Lane {
        double velocity = 0.0, exchanged = 0.0, contact = 0.0, share = 0.0, applied = 0.0, place = 0.0;
    };

    enum class Hold { scene, free, fixed };

    [[nodiscard]] Lane advance(const Grain& grain, const Told& told, int substeps, Hold hold) const;
    [[nodiscard]] double told_to(const Grain& grain, const Told& told) const;
    [[nodiscard]] Lane predict(const Grain& grain, const Told& told, const Lane& real) const;
    [[nodiscard]] double contact_impulse(const Grain& grain, Hold hold, const Lane& lane, double free, double give, double h) const;
    [[nodiscard]] double body_force(const Grain& grain) const;
    struct Pass;
    [[nodiscard]] Pass couple(const Told& told, double drive, const Pass* before) const;
    void clamp_at_random();

    CellScene scene_;
    std::vector<Grain> grains_;
    double phi_ = 0.0, u_ = 0.0, force_ = 0.0, acceleration_ = 0.0, ledger_ = 0.0, time_ = 0.0;
    double outside_ = 0.0, moved_ = 0.0;
    std::uint64_t random_ = 0;
};

} // namespace testing
