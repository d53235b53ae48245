// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/column.hpp"

#include "physics/coupling/contact_share.hpp"
#include "physics/coupling/drag.hpp"
#include "physics/coupling/true_up.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace testing {

using physics::GrainCoupling;
using physics::GrainResponse;
using physics::Mode;

namespace {

constexpr int passes_of_iterated = 3;
constexpr int coarsening = 4;
constexpr double filter_width = 3.0; // diameters

double total(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

} // namespace

struct Column::Pass {
    Lane real;
    Numbers velocity, force, owed, mistaken;
};

Column::Column(const ColumnScene& scene) : scene_(scene), cell_(scene.diameter)
{
    const double d = scene.diameter;
    const auto n = static_cast<std::size_t>(scene.cells);
    const auto count = static_cast<std::size_t>(scene.layers);
    volume_ = std::numbers::pi / 6.0 * d * d * d;
    mass_ = scene.density_ratio * scene.density * volume_;
    added_ = scene.added_mass * scene.density * volume_;
    weight_ = -(scene.density_ratio - 1.0) * scene.density * volume_ * scene.gravity;
    const double height = cell_ * scene.cells;
    bottom_ = 8.0 * d;
    top_ = height - 8.0 * d;
    const bool plate = scene.bottom == Bottom::plate;
    area_ = plate ? volume_ / d / (1.0 - scene.phi) : volume_ * scene.layers / (height * (1.0 - scene.phi));
    const double log_restitution = std::log(scene.restitution);
    spring_ = 0.5 * mass_ * (std::pow(std::numbers::pi, 2) + log_restitution * log_restitution) / (scene.contact_time * scene.contact_time);
    damper_ = -mass_ * log_restitution / scene.contact_time;
    substeps_ = static_cast<int>(std::ceil(scene.dt / (plate ? scene.contact_time / 20.0 : 2e-4)));
    for (std::size_t i = 0; i < count; ++i) {
        const double layer = static_cast<double>(i);
        place_.push_back(plate ? bottom_ + d * (0.5 + 1.01 * layer) : layer * height / scene.layers);
    }
    velocity_.assign(count, 0.0);
    owed_ = drag_ = share_ = growth_ = velocity_;
    ledger_.assign(n, 0.0);
    force_ = acceleration_ = advected_ = kept_ = ledger_;
    const double diffusion = std::pow(filter_width * d / cell_, 2) / 12.0;
    for (std::size_t k = 0; k < n; ++k) {
        double sum = 0.0;
        for (std::size_t j = 0; j < n; ++j) {
            const double wave = 2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n);
            sum += std::cos(wave * static_cast<double>(k)) / std::pow(1.0 + diffusion * (2.0 - 2.0 * std::cos(wave)), 3);
        }
        filter_.push_back(sum / static_cast<double>(n));
    }
    locate(place_);
    for (std::size_t c = 0; c < n; ++c) u_.push_back(scene.flow(0.0) / phi_[c]);
    flux_.assign(n, scene.flow(0.0));
    start_ = momentum();
}

void Column::locate(const Numbers& place)
{
    const double n = static_cast<double>(scene_.cells);
    low_.clear();
    high_weight_.clear();
    for (double z : place) {
        const double x = z / cell_ - n * std::floor(z / cell_ / n);
        low_.push_back(static_cast<std::size_t>(x) % filter_.size());
        high_weight_.push_back(x - std::floor(x));
    }
    phi_ = deposited(Numbers(place.size(), volume_));
    for (double& phi : phi_) phi = 1.0 - phi;
}

Column::Numbers Column::filtered(Numbers field) const
{
    const std::size_t n = field.size();
    Numbers out(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) out[i] += filter_[i > j ? i - j : j - i] * field[j];
    }
    return out;
}

Column::Numbers Column::sampled(const Numbers& field) const
{
    const Numbers smooth = filtered(field);
    Numbers out;
    for (std::size_t i = 0; i < low_.size(); ++i) {
        const double w = high_weight_[i];
        out.push_back((1.0 - w) * smooth[low_[i]] + w * smooth[(low_[i] + 1) % smooth.size()]);
    }
    return out;
}

Column::Numbers Column::deposited(const Numbers& quantity) const
{
    Numbers rough(filter_.size(), 0.0);
    for (std::size_t i = 0; i < low_.size(); ++i) {
        const double density = quantity[i] / (area_ * cell_);
        rough[low_[i]] += (1.0 - high_weight_[i]) * density;
        rough[(low_[i] + 1) % rough.size()] += high_weight_[i] * density;
    }
    return filtered(rough);
}

/// Upwind in advective form with the fluid's volume flux of the last step (Courant numbers here are below 0.2).
void Column::advect()
{
    const std::size_t n = u_.size();
    for (std::size_t c = 0; c < n; ++c) {
        const std::size_t below = (c + n - 1) % n, above = (c + 1) % n;
        const double in = 0.5 * (flux_[below] + flux_[c]), out = 0.5 * (flux_[c] + flux_[above]);
        const double rise = std::max(in, 0.0) * (u_[c] - u_[below]) + std::min(out, 0.0) * (u_[above] - u_[c]);
        advected_[c] = u_[c] - scene_.dt / cell_ / phi_[c] * rise;
        const double carried = out * (out > 0.0 ? u_[c] : u_[above]) - in * (in > 0.0 ? u_[below] : u_[c]);
        kept_[c] = scene_.density * (phi_[c] * u_[c] - scene_.dt / cell_ * carried);
    }
}

std::vector<Column::Numbers> Column::sums(const std::vector<GrainResponse>& responses) const
{
    std::vector<Numbers> parts(5);
    for (const GrainResponse& r : responses) {
        const double values[] = {r.reaction, r.flux, r.displaced, r.added, r.added_flux};
        for (std::size_t k = 0; k < 5; ++k) parts[k].push_back(values[k]);
    }
    for (Numbers& part : parts) part = deposited(part);
    return parts;
}

GrainResponse Column::sum_at(const std::vector<Numbers>& sums, std::size_t cell) const
{
    return {sums[0][cell], sums[1][cell], sums[2][cell], sums[3][cell], sums[4][cell]};
}

Column::Lane Column::taken(const Told& told, const Lane& real) const
{
    if (scene_.mode == Mode::coarse) return advance(told, std::max(1, substeps_ / coarsening));
    return scene_.mode == Mode::concurrent ? fly(told) : real;
}

Column::Pass Column::couple(const Told& told)
{
    locate(place_);
    const Numbers used = sampled(told.force);
    Pass pass{advance(told, substeps_), {}, {}, {}, {}};
    const Lane known = taken(told, pass.real);
    if (waits_for_grains(scene_.mode)) locate(pass.real.place);
    std::vector<GrainResponse> predictor, projection;
    Numbers flux, mistaken;
    for (std::size_t i = 0; i < place_.size(); ++i) {
        const GrainCoupling grain = coupling_of(i);
        predictor.push_back(response_to_velocity(grain, physics::predictor_yield(known.share[i])));
        projection.push_back(response_to_pressure(grain, physics::projection_yield(known.share[i], grain.drag / mass_)));
        flux.push_back(volume_ * known.velocity[i]);
        mistaken.push_back(known.exchanged[i] - pass.real.exchanged[i]);
    }
    pass.mistaken = deposited(mistaken);
    const Numbers exchanged = deposited(known.exchanged), solid = deposited(flux);
    const auto predictor_sums = sums(predictor), projection_sums = sums(projection);
    Numbers du, dug, change, misses;
    for (std::size_t c = 0; c < u_.size(); ++c) {
        const double dt = scene_.dt, phi = phi_[c], fluid = scene_.density * phi;
        const double miss = told.velocity[c] - advected_[c] - dt * told.acceleration[c];
        const GrainResponse sum = sum_at(predictor_sums, c);
        du.push_back(physics::predicted_change({ledger_[c], told.force[c], exchanged[c], told.velocity[c], advected_[c], miss}, fluid, phi,
                                               sum, dt));
        const auto response = cell_response(fluid, phi, sum_at(projection_sums, c), dt);
        const double volume = phi * (told.velocity[c] + du[c]) + solid[c] + physics::predicted_solid_flux(du[c], miss, sum);
        change.push_back((scene_.flow(time_ + dt) - volume) / response.mobility);
        dug.push_back(response.velocity * change[c]);
        misses.push_back(miss);
        pass.velocity.push_back(told.velocity[c] + du[c] + dug[c]);
        pass.force.push_back(told.force[c] + change[c]);
    }
    const Numbers now = sampled(pass.force), a = sampled(change), b = sampled(du), e = sampled(dug), m = sampled(misses);
    for (std::size_t i = 0; i < place_.size(); ++i) {
        pass.owed.push_back(
            physics::owed_impulse({used[i], now[i], a[i], b[i], e[i], m[i]}, volume_, predictor[i], projection[i], scene_.dt));
    }
    return pass;
}

void Column::step()
{
    advect();
    const Numbers phi_before = phi_;
    const Numbers u = sampled(u_), phi = sampled(phi_);
    for (std::size_t i = 0; i < place_.size(); ++i) {
        drag_[i] = scene_.drag * physics::drag_gidaspow_smooth(
                                     {std::abs(u[i] - velocity_[i]), phi[i], scene_.diameter, scene_.density, scene_.viscosity});
        const double stiffness = drag_[i] * scene_.dt / mass_, loading = scene_.density_ratio * (1.0 - phi[i]) / phi[i];
        stiffness_ = std::max(stiffness_, stiffness);
        growth_[i] = physics::growth_share(stiffness * (1.0 + loading));
    }
    const Mode asked = scene_.mode;
    if (time_ == 0.0) scene_.mode = Mode::iterated;
    Told told{u_, acceleration_, force_};
    Pass pass;
    for (int k = 0; k < (scene_.mode == Mode::iterated ? passes_of_iterated : 1); ++k) {
        if (k > 0) {
            told = {pass.velocity, pass.velocity, pass.force};
            for (std::size_t c = 0; c < u_.size(); ++c) told.acceleration[c] = (pass.velocity[c] - advected_[c]) / scene_.dt;
        }
        pass = couple(told);
    }
    finish(pass, phi_before);
    scene_.mode = asked;
}

void Column::finish(const Pass& pass, const Numbers& phi_before)
{
    const double dt = scene_.dt;
    place_ = pass.real.place;
    velocity_ = pass.real.velocity;
    owed_ = pass.owed;
    share_ = pass.real.share;
    force_ = pass.force;
    locate(place_);
    for (std::size_t c = 0; c < u_.size(); ++c) {
        // Lanes that did not wait projected with the old phi: the fluid that filled the difference has the new velocity.
        const double before = scene_.density * phi_before[c], now = scene_.density * phi_[c];
        ledger_[c] = !waits_for_grains(scene_.mode)
                         ? pass.mistaken[c] + (before - now) * pass.velocity[c] + physics::conserved_ledger(kept_[c], before, advected_[c])
                         : physics::conserved_ledger(kept_[c], now, advected_[c]);
        acceleration_[c] = (pass.velocity[c] - advected_[c]) / dt;
        flux_[c] = phi_[c] * pass.velocity[c];
    }
    u_ = pass.velocity;
    outside_ += weight_ * static_cast<double>(place_.size()) * dt + pass.real.plate + area_ * cell_ * dt * total(force_);
    time_ += dt;
}

double Column::momentum() const
{
    double sum = total(owed_) + mass_ * total(velocity_);
    for (std::size_t c = 0; c < u_.size(); ++c) sum += area_ * cell_ * (scene_.density * phi_[c] * u_[c] + ledger_[c]);
    return sum;
}

double Column::closure() const
{
    const double weight = std::abs(weight_) * static_cast<double>(place_.size());
    return std::abs(momentum() - start_ - outside_) / (weight * time_);
}

double Column::mean_velocity() const { return total(velocity_) / static_cast<double>(velocity_.size()); }

double Column::rms_velocity() const
{
    const double sum = std::inner_product(velocity_.begin(), velocity_.end(), velocity_.begin(), 0.0);
    return std::sqrt(sum / static_cast<double>(velocity_.size()));
}

double Column::drop_over_weight() const { return total(force_) * area_ * cell_ / (-weight_ * static_cast<double>(place_.size())); }

} // namespace testing
