// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// What a few large spheres among many small ones cost, beside small ones alone:
//   sizes_bench [small=100000] [large=100] [ratio=20] [fraction=0.45] [steps=300] [speed=0.1]
// Spheres of 1 mm and of `ratio` mm fill a `fraction` of a periodic box at random, fly against each other, and lose a tenth of their
// speed in a collision. Those alone fill as much of their box as beside large ones of what these leave: they meet as often.
#include "core/base/random.hpp"
#include "physics/particles/advance.hpp"
#include "physics/particles/insertion.hpp"

#include <cstdio>
#include <ctime>
#include <map>
#include <numbers>
#include <string>

namespace {

using core::Vec3;

constexpr double small_radius = 0.5e-3, density = 2500.0, stiffness = 1000.0, time_step = 2e-6;

struct Options {
    std::map<std::string, double> given{{"small", 1e5}, {"large", 100}, {"ratio", 20}, {"fraction", 0.45}, {"steps", 300}, {"speed", 0.1}};
    [[nodiscard]] int count(const std::string& name) const { return int(given.at(name)); }
};

physics::Group group_of(int count, double radius, const core::Domain& domain)
{
    physics::Group group;
    group.like.radius = radius;
    group.like.density = density;
    group.count = count;
    group.region = physics::BoxRegion{Vec3::Zero(), domain.size};
    return group;
}

/// CPU seconds per step and small sphere. @param large  How many of them.
double cost(const Options& options, int large)
{
    const int small = options.count("small");
    const double ratio = options.given.at("ratio"), each = 4.0 / 3.0 * std::numbers::pi * std::pow(small_radius, 3);
    const double of_large = each * options.count("large") * std::pow(ratio, 3);
    const double whole = (each * small + of_large) / options.given.at("fraction");
    const double edge = std::cbrt(large > 0 ? whole : whole - of_large);
    const core::Domain domain{Vec3::Zero(), Vec3::Constant(edge), {true, true, true}};
    auto spheres =
        physics::place_densely(domain, {}, {group_of(large, ratio * small_radius, domain), group_of(small, small_radius, domain)}, 1);
    for (core::Sphere& s : spheres) {
        const auto u = core::random_uniform(2, s.id, 0);
        s.velocity = options.given.at("speed") * (2.0 * Vec3(u[0], u[1], u[2]) - Vec3::Ones()) * (s.radius > small_radius ? 0.0 : 1.0);
    }
    physics::ParticleParameters parameters;
    parameters.pairs = parameters.walls = {{stiffness, 2.0 / 7.0, 0.9, 0.3}};
    physics::ParticleDynamics dynamics(domain, parameters, {}, time_step);
    for (const core::Sphere& s : spheres) dynamics.particles.add(s);
    const core::SerialTeam team;
    physics::settle(dynamics, physics::DryMotion{}, 20, team);
    const std::clock_t start = std::clock();
    physics::settle(dynamics, physics::DryMotion{}, options.count("steps"), team);
    const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC, per_small = seconds / (double(small) * options.count("steps"));
    std::printf("%d small, %d large: %.2f s, %.1f ns per small sphere and step, %.2f pairs listed and %.0f bytes for each sphere\n", small,
                large, seconds, 1e9 * per_small, double(dynamics.pairs().size()) / double(small + large),
                double(dynamics.bytes()) / double(small + large));
    return per_small;
}

} // namespace

int main(int argc, char** argv)
{
    const core::MpiSession session(argc, argv);
    Options options;
    for (int k = 1; k < argc; ++k) {
        const std::string word = argv[k];
        options.given[word.substr(0, word.find('='))] = std::stod(word.substr(word.find('=') + 1));
    }
    const double alone = cost(options, 0), mixed = cost(options, options.count("large"));
    std::printf("with large ones a small one costs %.2f times as much\n", mixed / alone);
    return 0;
}
