// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// isago view: a run on one page.
#include "core/base/error.hpp"
#include "io/cli/command.hpp"
#include "io/study/report.hpp"
#include <fmt/core.h>
#include <fstream>
#include <memory>

namespace io {

Command view_command()
{
    auto directory = std::make_shared<std::string>(); // shared: the option and run() both need it
    return {"view",
            "Write report.html of a run: scene, curves and pictures on one page",
            {{"run_directory", "The folder of a run", directory.get(), true}},
            [directory](const Invocation&) {
                const RunDirectory run(*directory);
                const std::string page = report_html(run);
                std::ofstream file(run.report(), std::ios::binary);
                file << page;
                file.close();
                if (!file) throw core::FileError("cannot write " + run.report().string());
                fmt::print("{}\n", run.report().string());
                return int(exit_success);
            }};
}

} // namespace io
