// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/particles/overlap_relaxation.hpp"
#include "core/base/error.hpp"
#include "core/particles/pair_list.hpp"
#include "physics/particles/wall_distance.hpp"

#include <algorithm>
#include <cmath>

namespace physics {
namespace {

using core::Vec3;

constexpr int most_sweeps = 20000;
constexpr double inflation = 1e-3;   // spheres relax a little too large, so that none overlaps when that is left of it
constexpr double largest_move = 0.1; // diameters in a sweep
constexpr double skin_share = 0.4;   // of the smallest radius

/// The spheres while they move: energy of overlaps, forces, and the steps of FIRE.
class Relaxer {
public:
    Relaxer(const core::Domain& domain, const std::vector<Wall>& walls, const std::vector<Region>& regions,
            const std::vector<core::Sphere>& spheres)
        : domain_(domain), walls_(walls), regions_(regions), shifts_(core::image_shifts(domain))
    {
        core::Octaves octaves{};
        for (core::Sphere sphere : spheres) {
            sphere.radius *= 1.0 + inflation;
            sphere.density = 1.0;
            set_.add(sphere);
            double& greatest = octaves[std::size_t(core::octave_of(sphere.radius))];
            greatest = std::max(greatest, sphere.radius);
            smallest_ = std::min(smallest_, sphere.radius);
            at_.push_back(sphere.position);
        }
        for (const double r : set_.radius) inertia_.push_back(r * r / (smallest_ * smallest_)); // as many contacts fit on it
        velocity_.assign(at_.size(), Vec3::Zero());
        listed_ = at_;
        sizes_ = core::SizeLevels(octaves);
    }

    /// @returns the greatest overlap over what it may be.
    double find_forces()
    {
        if (pairs_.chunks() == 0 || moved_ >= 0.5 * skin()) list_pairs();
        force_.assign(at_.size(), Vec3::Zero());
        worst_ = 0.0;
        for (std::size_t p = 0; p < pairs_.first.size(); ++p) {
            const auto i = std::size_t(pairs_.first[p]), j = std::size_t(pairs_.second[p]);
            const Vec3 way = at_[j] + shift_of(i, j, p) - at_[i];
            push(i, j, way, set_.radius[i] + set_.radius[j]);
        }
        for (std::size_t i = 0; i < at_.size(); ++i) push_from_walls(i);
        return worst_;
    }

    void move()
    {
        double power = 0, force2 = 0, velocity2 = 0;
        for (std::size_t i = 0; i < at_.size(); ++i) {
            power += force_[i].dot(velocity_[i]);
            force2 += force_[i].squaredNorm() / inertia_[i];
            velocity2 += inertia_[i] * velocity_[i].squaredNorm();
        }
        turn(power, force2 > 0 ? std::sqrt(velocity2 / force2) : 0.0);
        for (std::size_t i = 0; i < at_.size(); ++i) {
            velocity_[i] += step_ / inertia_[i] * force_[i];
            Vec3 way = step_ * velocity_[i];
            const double most = 2.0 * largest_move * set_.radius[i];
            if (const double length = way.norm(); length > most) way *= most / length;
            at_[i] += way;
            moved_ = std::max(moved_, (at_[i] - listed_[i]).norm());
        }
    }

    [[nodiscard]] const std::vector<Vec3>& places() const { return at_; }

private:
    [[nodiscard]] double skin() const { return skin_share * smallest_; }

    /// The way from sphere j to the image that sphere i meets, between places that may have left the domain since they were listed.
    [[nodiscard]] Vec3 shift_of(std::size_t i, std::size_t j, std::size_t p) const
    {
        return shifts_[std::size_t(pairs_.image[p])] - wrap_[j] + wrap_[i];
    }

    void list_pairs()
    {
        wrap_.resize(at_.size());
        core::Bounds bounds;
        for (std::size_t i = 0; i < at_.size(); ++i) {
            for (int a = 0; a < 3; ++a) {
                const double inside = domain_.wrapped(a, at_[i][a]);
                set_.position[std::size_t(a)][i] = inside;
                wrap_[i][a] = at_[i][a] - inside;
            }
            bounds.low = bounds.low.cwiseMin(set_.position_of(int(i)));
            bounds.high = bounds.high.cwiseMax(set_.position_of(int(i)));
        }
        core::CellLists cells;
        cells.build(set_, core::make_level_bins(domain_, bounds, sizes_, skin(), std::int64_t(at_.size())));
        pairs_.build(set_, cells, skin(), core::SerialTeam());
        listed_ = at_;
        moved_ = 0.0;
    }

    void push(std::size_t i, std::size_t j, const Vec3& way, double touching)
    {
        const double distance2 = way.squaredNorm();
        if (distance2 >= touching * touching) return;
        const double distance = std::sqrt(distance2), overlap = touching - distance;
        const Vec3 normal = distance > 1e-12 * touching ? Vec3(way / distance) : Vec3(Vec3::UnitX());
        force_[i] -= overlap * normal;
        force_[j] += overlap * normal;
        worst_ = std::max(worst_, overlap / (inflation / (1.0 + inflation) * touching));
    }

    void push_from_walls(std::size_t i)
    {
        const double radius = set_.radius[i];
        for (const Wall& wall : walls_) {
            const WallDistance d = std::visit([&](const auto& w) { return distance_from(w, at_[i]); }, wall);
            if (d.distance >= radius) continue;
            force_[i] += 2.0 * (radius - d.distance) * d.inward; // a wall gives way no half of the overlap
            worst_ = std::max(worst_, (radius - d.distance) / (inflation / (1.0 + inflation) * radius));
        }
        const Vec3 back = way_back(i);
        if (const double beyond = back.norm(); beyond > 0.0) {
            force_[i] += 2.0 * back;
            worst_ = std::max(worst_, beyond / (inflation * radius));
        }
    }

    /// The shortest way into the region.
    [[nodiscard]] Vec3 way_back(std::size_t i) const
    {
        Vec3 back = nearest_point(regions_[i], at_[i]) - at_[i];
        const auto* box = std::get_if<BoxRegion>(&regions_[i]);
        for (int a = 0; box && a < 3; ++a)
            if (domain_.periodic[std::size_t(a)] && box->high[a] - box->low[a] >= domain_.size[a]) back[a] = 0.0;
        return back;
    }

    /// FIRE: velocities turn towards the forces while they go downhill, and stop where they go uphill.
    /// @param ratio  Of the norm of the velocities to that of the accelerations.
    void turn(double power, double ratio)
    {
        constexpr double longest = 0.3, start = 0.1; // in units of the contact's time; longer ones are unstable with 12 contacts
        if (power > 0) {
            for (std::size_t i = 0; i < at_.size(); ++i)
                velocity_[i] = (1.0 - mixing_) * velocity_[i] + mixing_ * ratio / inertia_[i] * force_[i];
            if (++downhill_ > 5) {
                step_ = std::min(longest, 1.1 * step_);
                mixing_ *= 0.99;
            }
            return;
        }
        downhill_ = 0;
        step_ = std::max(0.02, 0.5 * step_);
        mixing_ = start;
        velocity_.assign(at_.size(), Vec3::Zero());
    }

    const core::Domain& domain_;
    const std::vector<Wall>& walls_;
    const std::vector<Region>& regions_;
    std::array<Vec3, 27> shifts_;
    core::ParticleSet set_;
    core::PairList pairs_;
    std::vector<Vec3> at_, velocity_, force_, listed_, wrap_;
    std::vector<double> inertia_;
    core::SizeLevels sizes_;
    double smallest_ = std::numeric_limits<double>::infinity(), moved_ = 0.0, worst_ = 0.0;
    double step_ = 0.1, mixing_ = 0.1;
    int downhill_ = 0;
};

} // namespace

Relaxation relax_overlaps(const core::Domain& domain, const std::vector<Wall>& walls, const std::vector<Region>& regions,
                          std::vector<core::Sphere>& spheres)
{
    Relaxation done;
    if (spheres.empty()) return done;
    Relaxer relaxer(domain, walls, regions, spheres);
    for (double worst = relaxer.find_forces(); worst > 1.0; worst = relaxer.find_forces()) {
        core::require<core::ConfigError>(done.sweeps < most_sweeps,
                                         core::text("particles still overlap by ", 100 * inflation * (worst - 1.0),
                                                    " % of their diameter after ", most_sweeps,
                                                    " sweeps: use fewer or smaller ones, or a larger region"));
        relaxer.move();
        ++done.sweeps;
    }
    for (std::size_t i = 0; i < spheres.size(); ++i) {
        core::Vec3& x = spheres[i].position;
        done.farthest_move = std::max(done.farthest_move, (relaxer.places()[i] - x).norm());
        for (int a = 0; a < 3; ++a) x[a] = domain.wrapped(a, relaxer.places()[i][a]);
    }
    return done;
}

} // namespace physics
