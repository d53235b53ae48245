// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/launch.hpp"
#include "io/run/stop_requests.hpp"
#include "tests/unit/io/temporary_folder.hpp"
#include <algorithm>
#include <csignal>
#include <doctest/doctest.h>

namespace {

io::StopReason agreed(const io::StopRequests& requests) { return requests.agree(core::Communicator::self()); }

} // namespace

TEST_CASE("a run is asked to stop by signals, a stop file or the clock")
{
    const TemporaryFolder folder;
    {
        const io::StopRequests requests(folder.path() / "stop");
        CHECK(agreed(requests) == io::StopReason::none);
        write_file(folder.path() / "stop", "");
        CHECK(agreed(requests) == io::StopReason::stop_file);
        CHECK(requests.here(1) == io::StopReason::none); // only rank 0 looks
        std::raise(SIGUSR1);
        CHECK(agreed(requests) == io::StopReason::user_signal);
        std::raise(SIGTERM);
        CHECK(agreed(requests) == io::StopReason::terminated);
        std::raise(SIGINT);
        CHECK(agreed(requests) == io::StopReason::interrupted);
    }
    CHECK(agreed(io::StopRequests()) == io::StopReason::none); // a new one begins afresh
    CHECK(agreed(io::StopRequests("", 0.0)) == io::StopReason::wall_clock);
    CHECK(agreed(io::StopRequests("", 3600.0)) == io::StopReason::none);
    CHECK(io::name_of(io::StopReason::terminated) == "signal TERM");
}

TEST_CASE("ranks know which signal the launcher was sent")
{
    for (const auto& [sent, reason] : {std::pair{SIGUSR1, io::StopReason::user_signal}, std::pair{SIGTERM, io::StopReason::terminated},
                                       std::pair{SIGINT, io::StopReason::interrupted}}) {
        const io::StopRequests requests;
        std::raise(io::signal_to_ranks(sent));
        CHECK(agreed(requests) == reason);
    }
}

TEST_CASE("a second Ctrl-C is not caught")
{
    const io::StopRequests requests;
    std::raise(SIGINT);
    struct sigaction now {};
    sigaction(SIGINT, nullptr, &now);
    CHECK((now.sa_handler == SIG_DFL));
}

TEST_CASE("mpirun is told not to bind, and the rest only where needed")
{
    auto has = [](const io::Launch& launch, const std::string& name) {
        return std::any_of(launch.environment.begin(), launch.environment.end(), [&](const auto& pair) { return pair.first == name; });
    };
    const auto two = io::mpirun_launch(2, {"/opt/isago", "run", "x"}, {2, false});
    CHECK(two.command == std::vector<std::string>{"mpirun", "-n", "2", "--bind-to", "none", "/opt/isago", "run", "x"});
    CHECK(!has(two, "OMPI_MCA_rmaps_base_oversubscribe"));
    CHECK(!has(two, "OMPI_ALLOW_RUN_AS_ROOT"));
    const auto four = io::mpirun_launch(4, {"isago"}, {2, true});
    CHECK(has(four, "OMPI_MCA_rmaps_base_oversubscribe"));
    CHECK(has(four, "OMPI_ALLOW_RUN_AS_ROOT"));
    CHECK(has(four, "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM"));
}

TEST_CASE("the option that starts ranks is not handed on to them")
{
    using Words = std::vector<std::string>;
    CHECK(io::without_option({"isago", "run", "--ranks", "2", "x"}, "--ranks") == Words{"isago", "run", "x"});
    CHECK(io::without_option({"isago", "--ranks=2", "x"}, "--ranks") == Words{"isago", "x"});
    CHECK(io::without_option({"isago", "x", "--ranks"}, "--ranks") == Words{"isago", "x"});
    CHECK(io::without_option({"isago", "--ranksack", "2"}, "--ranks") == Words{"isago", "--ranksack", "2"});
}
