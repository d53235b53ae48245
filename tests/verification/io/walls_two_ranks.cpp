// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Walls that move, and what is reported of them: the same bits on one rank and two, with threads, and through a restart.
// ctest: ranks=2 timeout=120
#include "core/base/team.hpp"
#include "io/run/state_file.hpp"
#include "io/run/world_metrics.hpp"
#include "tests/support/scene_from_text.hpp"
#include "tests/support/shared_folder.hpp"

namespace {

const std::string text = R"(name: a churn
grid: { box: { size: [20 mm, 24 mm, 20 mm], cells: [4, 6, 4], blocks: [1, 2, 1] } }
gravity: { direction: -y }
particles:
  - { name: glass, count: 150, diameter: 2 mm, density: 2500 kg/m3, initial: { low: [4 mm, 5 mm, 4 mm], high: [16 mm, 20 mm, 16 mm] } }
contact: { stiffness: 500 N/m, restitution: 0.6, friction: 0.4, walls: primitive }
walls:
  - name: drum
    cylinder: { point: [10 mm, 0 mm, 10 mm], axis: y, radius: 9.5 mm }
    motion: { rotation: { point: [10 mm, 0 mm, 10 mm], axis: y, rate: 120 rpm } }
  - name: plate
    disc: { point: [10 mm, 3 mm, 10 mm], normal: y, radius: 9 mm }
    motion: { oscillation: { amplitude: [0 mm, 1 mm, 0 mm], frequency: 30 Hz }, start: 10 ms }
run: { until: 1 s }
)";

struct Course {
    std::vector<double> row;  ///< of metrics, at the end
    std::vector<double> said; ///< sums of forces over all rows
};

/// Steps of a run; it is saved and read again after `pause` of them.
Course run_of(const core::Communicator& ranks, const tasks::ExecutorOptions& options, const std::string& folder, int pause)
{
    auto world = std::make_unique<io::World>(test::scene_from_text(text), ranks);
    auto executor = tasks::make_executor(options, world->compile());
    auto metrics = std::make_unique<io::WorldMetrics>(*world, folder + "/metrics.csv");
    Course course;
    for (int step = 0; step < 30; ++step) {
        if (step == pause) {
            const std::string file = io::save_state(*world, folder, 2);
            world = std::make_unique<io::World>(test::scene_from_text(text), ranks);
            io::load_state(io::CheckpointReader(file, ranks), *world);
            executor = tasks::make_executor(options, world->compile());
            metrics = std::make_unique<io::WorldMetrics>(*world, folder + "/metrics.csv", world->time());
        }
        world->step(*executor);
        metrics->after_step();
        course.row = metrics->row();
        course.said.insert(course.said.end(), course.row.begin(), course.row.end());
    }
    return course;
}

} // namespace

TEST_CASE("moving walls and their forces have the same bits on one rank and two, with threads, and after a restart")
{
    const auto world = core::Communicator::world(), self = core::Communicator::self();
    const support::SharedFolder shared(world);
    const std::string own = shared.path() + "/" + std::to_string(world.rank());
    std::filesystem::create_directories(own);
    const Course alone = run_of(self, {"serial"}, own, -1);
    const auto& row = alone.row;
    double greatest = 0;
    for (const double x : row) greatest = std::max(greatest, std::abs(x));
    CHECK(greatest > 0);
    CHECK(run_of(world, {"serial"}, shared.path(), -1).said == alone.said);
    CHECK(run_of(world, {"serial"}, shared.path(), 17).said == alone.said);
    tasks::ExecutorOptions threads{"tbb"};
    threads.threads = 2;
    CHECK(run_of(self, threads, own, 11).said == alone.said);
}
