// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a command of the program is: its name, its options, and the function that runs it. Each command is one file with
// one function that makes it, declared here and listed in commands.cpp.
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace io {

/// The exit codes of the program.
enum ExitCode { exit_success = 0, exit_failure = 1, exit_user_error = 2, exit_stopped_with_checkpoint = 75 };

/// One option. Flags are written as on the command line, "-o,--output"; a name without dashes is positional.
struct Option {
    using Place = std::variant<bool*, std::optional<int>*, std::string*, std::vector<std::string>*>;
    std::string flags;
    std::string help;
    Place place;
    bool required = false;
};

/// The words that the program was started with.
struct Invocation {
    int argc;
    char** argv;
};

struct Command {
    std::string name;
    std::string help;
    std::vector<Option> options;
    std::function<int(const Invocation&)> run; ///< Returns the exit code. Errors that it throws are printed by main.
};

[[nodiscard]] Command run_command();
[[nodiscard]] Command check_command();
[[nodiscard]] Command plan_command();
[[nodiscard]] Command study_command();
[[nodiscard]] Command stress_command();
[[nodiscard]] Command digest_command();
[[nodiscard]] Command view_command();
[[nodiscard]] Command schema_command();
[[nodiscard]] Command explain_command();

/// All commands, in the order of the help text.
[[nodiscard]] std::vector<Command> all_commands();

} // namespace io
