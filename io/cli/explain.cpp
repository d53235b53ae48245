// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// isago explain: what a key of a scene means, what to write, and its default.
#include "io/cli/command.hpp"
#include "io/scene/scene_writer.hpp"
#include <fmt/core.h>
#include <memory>

namespace io {

Command explain_command()
{
    auto key = std::make_shared<std::string>(); // shared: the option and run() both need it
    return {"explain",
            "Explain a key of a scene, such as contact.stiffness or stiffness; all of them without a key",
            {{"key", "The key, whole or its end", key.get()}},
            [key](const Invocation&) {
                fmt::print("{}", explain(*key));
                return int(exit_success);
            }};
}

} // namespace io
