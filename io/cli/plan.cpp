// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// isago plan: what would run, what is left out and why, and what it costs in memory.
#include "io/build/grid_report.hpp"
#include "io/cli/command.hpp"
#include "io/run/force_report.hpp"
#include "io/run/world.hpp"
#include "io/scene/scene_reader.hpp"
#include "tasks/overlap.hpp"
#include <fmt/format.h>
#include <iostream>
#include <memory>

namespace io {
namespace {

/// Without what only carries halos and sets walls.
std::string work_beside_grains(const tasks::Plan& plan)
{
    std::string text;
    for (const std::string& stage : tasks::stages_beside(plan, "move grains"))
        if (!stage.starts_with("halo of") && !stage.starts_with("walls of")) text += (text.empty() ? "" : ", ") + stage;
    return text;
}

int plan(const std::string& scene_path, const std::vector<std::string>& overrides, Invocation invocation)
{
    const Scene scene = read_scene(scene_path, overrides);
    const core::MpiSession session(invocation.argc, invocation.argv);
    World world(scene, core::Communicator::world());
    const tasks::PlanReport report = world.compile().describe();
    fmt::print("{}\n{} cells in {} blocks", scene.name, world.mesh().total_cells(), world.mesh().blocks());
    if (world.grains()) fmt::print(", {} particles, sub-step {:.3g} s", world.grains()->particles.owned, world.grains()->step());
    const double first = world.next_step();
    fmt::print("\nfirst step {:.3g} s, ruled by: {}", first, world.step_limit());
    if (world.grains()) fmt::print("; {} sub-steps", world.sub_steps());
    fmt::print("\n");
    fmt::print("{}", size_report(scene));
    if (!world.fluid()) fmt::print("no fluid: no fluid stage, no fluid field\n");
    else if (world.fluid()->is_straight())
        fmt::print("faces lie straight between cells: no gradients in cells for viscosity, seven points for pressure\n");
    if (!world.grains()) fmt::print("no particles: no particle stage, no fluid fraction\n");
    if (world.coupling())
        fmt::print("coupling {}\nwhile the grains move, the fluid lane may: {}\n{}", world.mode_reason(), work_beside_grains(*world.plan()),
                   force_report(scene));
    if (world.one_way())
        fmt::print("coupling one way: the fluid does not feel the particles, nothing is deposited\n"
                   "while the grains move, the fluid lane may: {}\n{}",
                   work_beside_grains(*world.plan()), force_report(scene));
    fmt::print("\n{}\n", grid_report(world.mesh()));
    std::cout << report;
    return exit_success;
}

} // namespace

Command plan_command()
{
    struct Arguments {
        std::string scene;
        std::vector<std::string> overrides;
    };
    auto a = std::make_shared<Arguments>(); // shared: the options and run() both need it
    return {"plan",
            "Show what a scene will run, what is left out and why, and its memory",
            {{"scene", "A scene.yaml or its folder", &a->scene, true}, {"--set", "Override one key: key.path=value", &a->overrides}},
            [a](const Invocation& invocation) { return plan(a->scene, a->overrides, invocation); }};
}

} // namespace io
