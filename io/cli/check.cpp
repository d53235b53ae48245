// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// isago check: every mistake of a scene at once.
#include "io/cli/command.hpp"
#include "io/scene/scene_reader.hpp"
#include <fmt/core.h>
#include <memory>

namespace io {

Command check_command()
{
    struct Arguments {
        std::string scene;
        std::vector<std::string> overrides;
    };
    auto arguments = std::make_shared<Arguments>(); // shared: the options and run() both need it
    return {"check",
            "Check a scene and show all its mistakes with their places",
            {{"scene", "A scene.yaml or its folder", &arguments->scene, true},
             {"--set", "Override one key: key.path=value", &arguments->overrides}},
            [arguments](const Invocation&) {
                const Scene scene = read_scene(arguments->scene, arguments->overrides);
                fmt::print("{}: no mistakes\n", scene_file(arguments->scene).string());
                return int(exit_success);
            }};
}

} // namespace io
