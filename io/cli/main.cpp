// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// The program: reads the command line, runs one command, and turns what went wrong into a message and an exit code.
#include "core/base/error.hpp"
#include "io/cli/command.hpp"
#include "io/run/version.hpp"
#include "io/scene/problems.hpp"
#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

namespace {

void add_option(CLI::App& app, const io::Option& option)
{
    CLI::Option* added = std::visit(
        [&](auto* place) {
            using Place = std::remove_pointer_t<decltype(place)>;
            if constexpr (std::is_same_v<Place, bool>) {
                return app.add_flag(option.flags, *place, option.help);
            } else {
                return app.add_option(option.flags, *place, option.help);
            }
        },
        option.place);
    added->required(option.required);
    const bool positional = !option.flags.starts_with('-');
    if (std::holds_alternative<std::vector<std::string>*>(option.place) && !positional) added->take_all()->allow_extra_args(false);
}

/// A word in the place of a command that is none.
[[nodiscard]] bool is_unknown_command(int argc, char** argv, const std::vector<io::Command>& commands)
{
    if (argc < 2 || argv[1][0] == '-') return false;
    return std::none_of(commands.begin(), commands.end(), [&](const auto& command) { return command.name == argv[1]; });
}

int run(int argc, char** argv)
{
    CLI::App app("Isago: particles in flowing water and air", "isago");
    app.require_subcommand(1);
    app.set_version_flag("--version", io::version_text());
    const auto commands = io::all_commands();
    if (is_unknown_command(argc, argv, commands)) {
        std::vector<std::string> names;
        for (const auto& command : commands) names.push_back(command.name);
        std::cerr << "isago: unknown command '" << argv[1] << "'; " << io::suggestion(argv[1], names) << '\n';
        return io::exit_user_error;
    }
    int exit_code = io::exit_success;
    for (const auto& command : commands) {
        CLI::App* sub = app.add_subcommand(command.name, command.help);
        for (const auto& option : command.options) add_option(*sub, option);
        sub->callback([&exit_code, &command, argc, argv] { exit_code = command.run({argc, argv}); });
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? io::exit_success : io::exit_user_error;
    }
    return exit_code;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (const core::ConfigError& error) {
        const std::string message = error.what();
        std::cerr << message << (message.ends_with('\n') ? "" : "\n");
        return io::exit_user_error;
    } catch (const std::exception& error) {
        std::cerr << "isago: " << error.what() << '\n';
        return io::exit_failure;
    }
}
