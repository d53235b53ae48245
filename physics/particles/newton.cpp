// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/newton.hpp"

#include <cmath>
#include <limits>

namespace physics {
namespace {

/// (1 - exp(-z)) / z, also for z = 0.
double mean_decay(double z) { return z > 0.0 ? -std::expm1(-z) / z : 1.0; }

/// Drifts particles [begin, end) and returns their greatest square of speed; infinite if one has no finite speed.
double drift_chunk(core::ParticleSet& p, int begin, int end, const DriftTimes& times)
{
    double *x = p.position[0].data(), *y = p.position[1].data(), *z = p.position[2].data();
    const double *vx = p.velocity[0].data(), *vy = p.velocity[1].data(), *vz = p.velocity[2].data();
    const double first = times.first_half, second = times.second_half;
    double greatest = 0.0;
    int lost = 0;
#pragma omp simd reduction(max : greatest) reduction(| : lost)
    for (int i = begin; i < end; ++i) {
        x[i] = x[i] + first * vx[i] + second * vx[i];
        y[i] = y[i] + first * vy[i] + second * vy[i];
        z[i] = z[i] + first * vz[i] + second * vz[i];
        const double speed2 = vx[i] * vx[i] + vy[i] * vy[i] + vz[i] * vz[i];
        greatest = std::max(greatest, speed2);
        lost |= int(!(speed2 < 1e300));
    }
    return lost ? std::numeric_limits<double>::infinity() : greatest;
}

} // namespace

WetColumns add_wet_columns(core::ParticleSet& particles)
{
    const auto three = [&] {
        const int first = particles.add_column();
        particles.add_column();
        particles.add_column();
        return first;
    };
    WetColumns c{};
    c.keep = particles.add_column();
    c.gain = particles.add_column();
    c.drift = three();
    c.spin_keep = particles.add_column();
    c.spin_gain = particles.add_column();
    c.spin_drift = three();
    c.impulse = three();
    c.twist = three();
    return c;
}

void set_wet_load(core::ParticleSet& particles, const WetColumns& c, int i, const WetLoad& load, double step)
{
    const auto k = std::size_t(i);
    const auto column = [&](int n) -> double& { return particles.columns[std::size_t(n)][k]; };
    const double mass = particles.mass[k] + load.added_mass, z = step * load.drag / mass;
    column(c.keep) = std::exp(-z);
    column(c.gain) = step / mass * mean_decay(z);
    const double turn = step * load.spin_drag / particles.inertia[k];
    column(c.spin_keep) = std::exp(-turn);
    column(c.spin_gain) = step / particles.inertia[k] * mean_decay(turn);
    for (int a = 0; a < 3; ++a) {
        column(c.drift + a) = -std::expm1(-z) * load.fluid_velocity[a] + column(c.gain) * load.force[a];
        column(c.spin_drift + a) = -std::expm1(-turn) * load.fluid_spin[a];
    }
}

void clear_impulses(core::ParticleSet& particles, const WetColumns& c)
{
    for (const int first : {c.impulse, c.twist})
        for (int a = 0; a < 3; ++a) {
            auto& column = particles.columns[std::size_t(first + a)];
            std::fill(column.begin(), column.end(), 0.0);
        }
}

double move_chunk(core::ParticleSet& p, const ForceSums& sums, const DryMotion& motion, const DriftTimes& times)
{
    const double h = times.step;
    const double *mass = p.mass.data() + sums.begin, *inertia = p.inertia.data() + sums.begin;
    const int n = sums.end - sums.begin;
    for (std::size_t a = 0; a < 3; ++a) {
        double *v = p.velocity[a].data() + sums.begin, *w = p.spin[a].data() + sums.begin;
        const double g = motion.gravity[int(a)];
        const double *force = sums.force[a].data(), *torque = sums.torque[a].data();
#pragma omp simd
        for (int k = 0; k < n; ++k) {
            v[k] += h * (force[k] / mass[k] + g);
            w[k] += h * (torque[k] / inertia[k]);
        }
    }
    return drift_chunk(p, sums.begin, sums.end, times);
}

double move_chunk(core::ParticleSet& p, const ForceSums& sums, const WetMotion& motion, const DriftTimes& times)
{
    const auto& c = motion.columns;
    const auto column = [&](int n) { return p.columns[std::size_t(n)].data() + sums.begin; };
    const double *keep = column(c.keep), *gain = column(c.gain);
    const double *spin_keep = column(c.spin_keep), *spin_gain = column(c.spin_gain);
    const int n = sums.end - sums.begin;
    for (int a = 0; a < 3; ++a) {
        double *v = p.velocity[std::size_t(a)].data() + sums.begin, *w = p.spin[std::size_t(a)].data() + sums.begin;
        const double *drift = column(c.drift + a), *spin_drift = column(c.spin_drift + a);
        double *impulse = column(c.impulse + a), *twist = column(c.twist + a);
        const double *force = sums.force[std::size_t(a)].data(), *torque = sums.torque[std::size_t(a)].data();
        const double h = times.step;
#pragma omp simd
        for (int k = 0; k < n; ++k) {
            v[k] = keep[k] * v[k] + drift[k] + gain[k] * force[k];
            w[k] = spin_keep[k] * w[k] + spin_drift[k] + spin_gain[k] * torque[k];
            impulse[k] += h * force[k];
            twist[k] += h * torque[k];
        }
    }
    return drift_chunk(p, sums.begin, sums.end, times);
}

double drift_all(core::ParticleSet& particles, double half_step, const core::Team& team)
{
    const int chunks = (particles.owned + core::particles_per_chunk - 1) / core::particles_per_chunk;
    std::vector<double> greatest(std::size_t(chunks), 0.0);
    team.run(chunks, [&](int c) {
        const int begin = c * core::particles_per_chunk;
        const int end = std::min(particles.owned, begin + core::particles_per_chunk);
        greatest[std::size_t(c)] = drift_chunk(particles, begin, end, {2.0 * half_step, half_step, 0.0});
    });
    return chunks == 0 ? 0.0 : *std::max_element(greatest.begin(), greatest.end());
}

} // namespace physics
