// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// isago schema: the JSON Schema of scene.yaml.
#include "io/cli/command.hpp"
#include "io/scene/scene_writer.hpp"
#include <fmt/core.h>

namespace io {

Command schema_command()
{
    return {"schema", "Print the JSON Schema of scene.yaml, for editors", {}, [](const Invocation&) {
                fmt::print("{}", json_schema());
                return int(exit_success);
            }};
}

} // namespace io
