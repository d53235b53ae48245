// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/cli/command.hpp"

namespace io {

std::vector<Command> all_commands()
{
    return {
        run_command(),    check_command(), plan_command(),   study_command(),   stress_command(),
        digest_command(), view_command(),  schema_command(), explain_command(),
    };
}

} // namespace io
