// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Speed of dry particles against other codes: dem_bench CASE.txt pipe|bed STEPS [THREADS] [SKIN] [NEAR_SKIN]
// The file holds a header line with the box (three pairs low high), then x y z r vx vy vz of each particle [SI].
#include "core/base/error.hpp"
#include "physics/particles/advance.hpp"
#include "physics/particles/time_step.hpp"

#include <chrono>
#include <ctime>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

namespace {

using core::Vec3;

struct Case {
    core::Domain domain;
    std::vector<core::Sphere> spheres;
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
    Case c;
    c.domain.origin = low;
    c.domain.size = high - low;
    c.domain.periodic = pipe ? std::array<bool, 3>{false, false, true} : std::array<bool, 3>{true, true, false};
    core::Sphere s;
    s.density = 2000.0;
    while (file >> s.position[0] >> s.position[1] >> s.position[2] >> s.radius >> s.velocity[0] >> s.velocity[1] >> s.velocity[2]) {
        s.position -= low;
        c.spheres.push_back(s);
        ++s.id;
    }
    return c;
}

} // namespace

int main(int argc, char** argv)
{
    if (argc < 4) {
        std::puts("usage: dem_bench CASE.txt pipe|bed STEPS [THREADS] [SKIN] [NEAR_SKIN]");
        return 1;
    }
    core::MpiSession session(argc, argv);
    const bool pipe = std::string(argv[2]) == "pipe";
    const int steps = std::stoi(argv[3]), threads = argc > 4 ? std::stoi(argv[4]) : 1;
    const Case scene = read_case(argv[1], pipe);
    physics::ParticleParameters parameters;
    parameters.pairs = parameters.walls = {{1000.0, 2.0 / 7.0, 0.6, 0.5}};
    parameters.skin = argc > 5 ? std::stod(argv[5]) : 0.0;
    parameters.near_skin = argc > 6 ? std::stod(argv[6]) : 0.0;
    const Vec3 axis_point = Vec3(0, 0, 0) - scene.domain.origin;
    const std::vector<physics::Wall> walls =
        pipe ? std::vector<physics::Wall>{physics::CylinderWall{axis_point, Vec3::UnitZ(), 0.025}}
             : std::vector<physics::Wall>{physics::PlaneWall{Vec3::Zero(), Vec3::UnitZ()}};
    physics::ParticleDynamics dynamics(scene.domain, parameters, walls, 1e-5);
    for (const auto& sphere : scene.spheres) dynamics.particles.add(sphere);
    const physics::DryMotion motion{pipe ? Vec3(0, -9.81, 0) : Vec3(0, 0, -9.81)};
    const auto team = core::make_openmp_team(threads);
    physics::settle(dynamics, motion, 1, *team);
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpu_start = std::clock();
    physics::settle(dynamics, motion, steps, *team);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const double cpu = double(std::clock() - cpu_start) / CLOCKS_PER_SEC;
    double height = 0.0;
    for (int i = 0; i < dynamics.particles.owned; ++i) height += dynamics.particles.position[pipe ? 1 : 2][std::size_t(i)];
    const double work = 1e-6 * double(steps) * dynamics.particles.owned;
    std::printf("%s %d threads: %.3f s, CPU %.3f s; M particle-steps/s: %.2f wall, %.2f CPU; mean height %.6f mm\n", argv[1],
                threads, seconds, cpu, work / seconds, work / cpu,
                1e3 * (height / dynamics.particles.owned + scene.domain.origin[pipe ? 1 : 2]));
    return 0;
}
