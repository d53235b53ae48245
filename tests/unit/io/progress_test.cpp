// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/progress.hpp"
#include "tests/support/relative.hpp"
#include "tests/unit/io/temporary_folder.hpp"
#include <algorithm>
#include <doctest/doctest.h>
#include <sstream>

TEST_CASE("durations are written with the two units that matter")
{
    CHECK(io::duration_text(0.04) == "0.0 s");
    CHECK(io::duration_text(9.94) == "9.9 s");
    CHECK(io::duration_text(42.4) == "42 s");
    CHECK(io::duration_text(200.0) == "3 min 20 s");
    CHECK(io::duration_text(7500.0) == "2 h 05 min");
    CHECK(io::duration_text(90000.0) == "1 days 01 h");
}

TEST_CASE("a plain console gets whole lines, a terminal one that changes, the others nothing")
{
    std::ostringstream plain, terminal, silent;
    for (auto [stream, kind] : {std::pair{&plain, io::Console::Kind::plain}, std::pair{&terminal, io::Console::Kind::terminal},
                                std::pair{&silent, io::Console::Kind::silent}}) {
        io::Console console(*stream, kind);
        console.status("a");
        console.status("b");
        console.line("c");
    }
    CHECK(plain.str() == "a\nb\nc\n");
    CHECK(terminal.str() == "a\r\033[Kb\r\033[Kc\n");
    CHECK(silent.str().empty());
}

TEST_CASE("the time left follows from the recent rate")
{
    std::ostringstream stream;
    io::Console console(stream, io::Console::Kind::plain);
    io::Log log("", console);
    io::Progress progress(0.0, 1.0, console, log);
    // 0.001 s of simulated time in 0.5 s of real time: 500 s for the whole, 400 s after a fifth.
    for (int n = 1; n <= 200; ++n) progress.step({n, 0.001 * n, 0.001, {}, {}, {}}, 0.5 * n);
    CHECK(progress.seconds_left().value() == test::relative(400.0));
    // Twice as slow from here on: after much more than the 20 s of memory, 1 s for each 0.001 s, 600 s left.
    for (int n = 1; n <= 200; ++n) progress.step({200 + n, 0.2 + 0.001 * n, 0.001, {}, {}, {}}, 100.0 + n);
    CHECK(progress.seconds_left().value() == test::relative(600.0).epsilon(1e-3)); // e^-10 of the old rate remains
}

TEST_CASE("without a terminal the progress is a line every ten seconds, and the last step")
{
    std::ostringstream stream;
    io::Console console(stream, io::Console::Kind::plain);
    io::Log log("", console);
    io::Progress progress(0.0, 1.0, console, log);
    for (int n = 1; n <= 25; ++n) progress.step({n, 0.04 * n, 0.04, 0.8, 3e-9, 1600}, n);
    progress.finish();
    const std::string text = stream.str();
    CHECK(std::count(text.begin(), text.end(), '\n') == 4); // steps 1, 11, 21, 25
    CHECK(text.find("step 25  t 1 s  dt 0.04 s  CFL 0.80  residual 3.0e-09  particles 1600  100 %") != std::string::npos);
}

TEST_CASE("the log file keeps every line with its time")
{
    const TemporaryFolder folder;
    std::ostringstream stream;
    io::Console console(stream, io::Console::Kind::plain);
    {
        io::Log log(folder.path() / "log.txt", console);
        log.info("begins");
        log.warning("careful");
    }
    {
        io::Log again(folder.path() / "log.txt", console);
        again.error("ends");
    }
    CHECK(stream.str() == "begins\nwarning: careful\nerror: ends\n");
    const std::string text = text_of_file(folder.path() / "log.txt");
    CHECK(text.find(" s] begins\n") != std::string::npos);
    CHECK(text.find(" s] error: ends\n") != std::string::npos);
}
