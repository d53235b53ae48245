// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Speed of dry particles, and the state they come to, beside other codes:
//   dem_bench CASE.txt pipe|bed STEPS [threads=N] [wall=primitive|faces] [shift=SEED] [skin=M] [near_skin=M]
// The file holds a header line with the box (three pairs low high), then x y z r vx vy vz of each particle [SI].
#include "core/base/error.hpp"
#include "core/base/random.hpp"
#include "physics/particles/advance.hpp"
#include "physics/particles/restitution.hpp"
#include "physics/particles/time_step.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>

namespace {

using core::Vec3;

constexpr double stiffness = 1000.0, density = 2000.0, friction = 0.5, time_step = 1e-5, gravity = 9.81, pipe_radius = 0.025;
constexpr double damping_rate = 4960.0; // dashpot over reduced mass, the same for all sizes [1/s]: what other codes take

struct Options {
    std::map<std::string, std::string> given;

    [[nodiscard]] std::string word(const std::string& name, const std::string& otherwise) const
    {
        const auto found = given.find(name);
        return found == given.end() ? otherwise : found->second;
    }
    [[nodiscard]] double number(const std::string& name, double otherwise) const
    {
        return given.count(name) ? std::stod(given.at(name)) : otherwise;
    }
};

struct Case {
    bool pipe;
    core::Domain domain;
    std::vector<core::Sphere> spheres;
    std::vector<double> radii; ///< Of each species [m].
};

Case read_case(const std::string& path, bool pipe)
{
    std::ifstream file(path);
    core::require<core::FileError>(file.good(), core::text("cannot read ", path));
    std::string header, mark;
    std::getline(file, header);
    std::istringstream box(header);
    Vec3 low, high;
    box >> mark;
    for (int a = 0; a < 3; ++a) box >> low[a] >> high[a];
    Case c{pipe, {}, {}, {}};
    c.domain.origin = low;
    c.domain.size = high - low;
    c.domain.periodic = pipe ? std::array<bool, 3>{false, false, true} : std::array<bool, 3>{true, true, false};
    core::Sphere s;
    s.density = density;
    while (file >> s.position[0] >> s.position[1] >> s.position[2] >> s.radius >> s.velocity[0] >> s.velocity[1] >> s.velocity[2]) {
        s.position -= low;
        const auto species = std::find(c.radii.begin(), c.radii.end(), s.radius);
        s.species = std::int32_t(species - c.radii.begin());
        if (species == c.radii.end()) c.radii.push_back(s.radius);
        c.spheres.push_back(s);
        ++s.id;
    }
    return c;
}

/// Moves every start by up to a nanometre: grains in motion forget it, so that runs tell their noise.
void shift_starts(Case& scene, std::uint64_t seed)
{
    for (auto& sphere : scene.spheres) {
        const auto u = core::random_uniform(seed, sphere.id, 0), v = core::random_uniform(seed, sphere.id, 1);
        sphere.position += 2e-9 * (Vec3(u[0], u[1], v[0]) - Vec3::Constant(0.5));
    }
}

/// A dashpot of `damping_rate` for each two sizes, and for each size and the wall, which does not move.
physics::ParticleParameters parameters_of(const Case& scene, const Options& options)
{
    const auto mass = [](double r) { return 4.0 / 3.0 * std::numbers::pi * r * r * r * density; };
    const auto contact = [](double reduced_mass) {
        const double damping = 0.5 * damping_rate * std::sqrt(reduced_mass / stiffness);
        return physics::ContactParameters{stiffness, 2.0 / 7.0, physics::restitution_of(damping), friction};
    };
    physics::ParticleParameters p;
    p.species = int(scene.radii.size());
    p.pairs.clear();
    p.walls.clear();
    for (const double a : scene.radii) {
        for (const double b : scene.radii) p.pairs.push_back(contact(mass(a) * mass(b) / (mass(a) + mass(b))));
        p.walls.push_back(contact(mass(a)));
    }
    p.skin = options.number("skin", 0.0);
    p.near_skin = options.number("near_skin", 0.0);
    return p;
}

/// A pipe of 48 x 24 faces for each 90 mm, as the boundary of a grid has them.
physics::WallSurface pipe_of_faces(const Case& scene, const Vec3& axis)
{
    const double length = scene.domain.size[2];
    const int around = 48, along = int(std::lround(24 * length / 0.09));
    std::vector<Vec3> vertices;
    std::vector<std::array<int, 4>> quads;
    for (int k = 0; k <= along; ++k)
        for (int n = 0; n < around; ++n) {
            const double angle = 2.0 * std::numbers::pi * n / around;
            vertices.push_back(axis + Vec3(pipe_radius * std::cos(angle), pipe_radius * std::sin(angle), length * k / along));
        }
    for (int k = 0; k < along; ++k)
        for (int n = 0; n < around; ++n) {
            const int a = k * around + n, b = k * around + (n + 1) % around;
            quads.push_back({a, a + around, b + around, b});
        }
    return {vertices, quads};
}

physics::ParticleDynamics dynamics_of(const Case& scene, const Options& options)
{
    const bool faces = options.word("wall", "primitive") == "faces";
    core::require<core::ConfigError>(!faces || scene.pipe, "only the pipe is made of faces");
    const Vec3 axis = Vec3(0, 0, 0) - scene.domain.origin;
    std::vector<physics::Wall> walls;
    if (!scene.pipe) walls.push_back(physics::PlaneWall{Vec3::Zero(), Vec3::UnitZ()});
    else if (!faces) walls.push_back(physics::CylinderWall{axis, Vec3::UnitZ(), pipe_radius});
    physics::ParticleDynamics dynamics(scene.domain, parameters_of(scene, options), walls, time_step);
    if (faces) dynamics.add_surface(pipe_of_faces(scene, axis));
    for (const auto& sphere : scene.spheres) dynamics.particles.add(sphere);
    return dynamics;
}

/// Pairs of grains that overlap, counted for each of the two, over the number of grains.
double contacts_per_grain(const physics::ParticleDynamics& dynamics)
{
    const auto& p = dynamics.particles;
    const auto& pairs = dynamics.pairs();
    const core::Domain& domain = dynamics.domain();
    int touching = 0;
    for (std::size_t m = 0; m < pairs.first.size(); ++m) {
        const int i = pairs.first[m], j = pairs.second[m];
        Vec3 d = p.position_of(i) - p.position_of(j);
        for (int a = 0; a < 3; ++a)
            if (domain.periodic[std::size_t(a)]) d[a] -= domain.size[a] * std::round(d[a] / domain.size[a]);
        touching += int(d.norm() < p.radius[std::size_t(i)] + p.radius[std::size_t(j)]);
    }
    return 2.0 * touching / p.owned;
}

void print_state(const Case& scene, const physics::ParticleDynamics& dynamics)
{
    const auto& p = dynamics.particles;
    const int up = scene.pipe ? 1 : 2;
    double height = 0.0, energy = 0.0;
    for (int i = 0; i < p.owned; ++i) {
        height += p.position[std::size_t(up)][std::size_t(i)];
        energy += 0.5 * p.mass[std::size_t(i)] * p.velocity_of(i).squaredNorm();
    }
    std::printf("state: mean height %.6f mm; contacts per grain %.4f; kinetic energy %.6g J; %.0f bytes for each\n",
                1e3 * (height / p.owned + scene.domain.origin[up]), contacts_per_grain(dynamics), energy,
                double(dynamics.bytes()) / p.owned);
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 4) {
        std::puts("usage: dem_bench CASE.txt pipe|bed STEPS [threads=N] [wall=primitive|faces] [shift=SEED] [skin=M] [near_skin=M]");
        return 1;
    }
    core::MpiSession session(argc, argv);
    Options options;
    for (int k = 4; k < argc; ++k) {
        const std::string word = argv[k];
        options.given[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
    }
    const int steps = std::stoi(argv[3]), threads = int(options.number("threads", 1));
    Case scene = read_case(argv[1], std::string(argv[2]) == "pipe");
    if (options.given.count("shift")) shift_starts(scene, std::uint64_t(options.number("shift", 0)));
    physics::ParticleDynamics dynamics = dynamics_of(scene, options);
    const physics::DryMotion motion{scene.pipe ? Vec3(0, -gravity, 0) : Vec3(0, 0, -gravity)};
    const auto team = core::make_openmp_team(threads);
    physics::settle(dynamics, motion, 1, *team);
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpu_start = std::clock();
    physics::settle(dynamics, motion, steps - 1, *team);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double cpu = double(std::clock() - cpu_start) / CLOCKS_PER_SEC;
    const double work = 1e-6 * double(steps - 1) * dynamics.particles.owned;
    std::printf("%s %d threads: %.4f s, CPU %.4f s; M particle-steps/s: %.2f wall, %.2f CPU\n", argv[1], threads, seconds, cpu,
                work / seconds, work / cpu);
    print_state(scene, dynamics);
    return 0;
}
