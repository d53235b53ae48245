// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// isago digest: one line that stands for every bit of the final state of a run.
#include "core/base/error.hpp"
#include "io/cli/command.hpp"
#include "io/files/checkpoint.hpp"
#include "io/run/run_directory.hpp"
#include <fmt/format.h>
#include <memory>

namespace io {

Command digest_command()
{
    auto directory = std::make_shared<std::string>(); // shared: the option and run() both need it
    return {"digest",
            "Hash of the final state of a run: the same for any ranks, threads, executor and restart",
            {{"directory", "A run directory", directory.get(), true}},
            [directory](Invocation invocation) {
                const core::MpiSession session(invocation.argc, invocation.argv);
                const core::Communicator ranks = core::Communicator::self();
                const CheckpointChoice choice = newest_good_checkpoint(RunDirectory(*directory).checkpoints(), ranks);
                for (const std::string& refused : choice.refused) fmt::print(stderr, "{}\n", refused);
                core::require<core::FileError>(!choice.path.empty(), fmt::format("{} has no good checkpoint", *directory));
                fmt::print("{}\n", CheckpointReader(choice.path, ranks).digest());
                return int(exit_success);
            }};
}

} // namespace io
