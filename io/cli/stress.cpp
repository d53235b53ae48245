// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// isago stress: stiff and extreme cases, each with what must hold.
#include "core/comm/communicator.hpp"
#include "io/cli/command.hpp"
#include "io/study/stress_run.hpp"
#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <memory>

namespace io {
namespace {

struct Arguments {
    std::vector<std::string> names;
    std::string folder = "tests/stress/cases";
    bool list = false;
};

void print_list(const std::vector<StressCase>& cases)
{
    for (const StressCase& stress : cases)
        fmt::print("{:34} {:18} {} to run\n", stress.name, stress.source, std::max<std::size_t>(1, stress.variants.size()));
}

int run(const Arguments& a, Invocation invocation)
{
    const auto cases = read_stress_cases(a.folder, a.names);
    if (a.list) {
        print_list(cases);
        return exit_success;
    }
    const core::MpiSession session(invocation.argc, invocation.argv);
    int failed = 0;
    for (const StressCase& stress : cases) {
        const auto start = std::chrono::steady_clock::now();
        const auto verdicts = run_stress_case(stress);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        fmt::print("{}: {} ({:.1f} s)\n{}", stress.name, stress.source, seconds, table_text(verdicts));
        std::fflush(stdout);
        failed += std::any_of(verdicts.begin(), verdicts.end(), [](const StressVerdict& v) { return !v.passed; });
    }
    fmt::print("{} of {} cases pass\n", int(cases.size()) - failed, cases.size());
    return failed == 0 ? exit_success : exit_failure;
}

} // namespace

Command stress_command()
{
    auto a = std::make_shared<Arguments>(); // shared: the options and run() both need it
    return {"stress",
            "Run the stiff and extreme cases and judge them",
            {{"names", "Cases to run; all by default", &a->names},
             {"--list", "Only say which cases there are, and what they are from", &a->list},
             {"--cases", "Folder of the cases; tests/stress/cases by default", &a->folder}},
            [a](const Invocation& invocation) { return run(*a, invocation); }};
}

} // namespace io
