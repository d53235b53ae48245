// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "tests/support/sample_state.hpp"

#include <doctest/doctest.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sys/resource.h>
#include <sys/wait.h>

using support::Folder, support::State, support::whole_state;
namespace fs = std::filesystem;

namespace {

const auto alone = [] { return core::Communicator::self(); };

std::string bytes_of(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void set_bytes(const std::string& path, const std::string& bytes) { std::ofstream(path, std::ios::binary) << bytes; }

/// Position in the file of a part of a dataset, found by its bits.
std::size_t place_of(const std::string& bytes, double value)
{
    const std::string bits(reinterpret_cast<const char*>(&value), sizeof value);
    return bytes.find(bits);
}

} // namespace

TEST_CASE("a checkpoint gives back every bit of fields, columns, scalars and notes")
{
    const Folder folder;
    const State written = whole_state(1.0);
    const std::string path = written.write(folder.path(), 12, alone());
    State read({{0, 1, 2, 3, 4}, support::block_total});
    read.read(path, alone());
    CHECK(read.digest(12, alone()) == written.digest(12, alone()));
    for (int b = 0; b < 5; ++b) { // local block b of `read` is global block b, which `written` has elsewhere
        const int other = (std::array{1, 3, 4, 0, 2})[std::size_t(b)];
        CHECK(read.flux.data(b, 1) == written.flux.data(other, 1));
        CHECK(io::interior(io::views(std::as_const(read.velocity)).blocks[std::size_t(b)]) ==
              io::interior(io::views(written.velocity).blocks[std::size_t(other)]));
    }
    CHECK(read.ids[4321] == 4321);
    CHECK(read.position[3 * 4321 + 1] == std::cos(1.0 + 4321 + 0.1));
    const io::CheckpointReader reader(path, alone());
    CHECK(reader.scalar("time") == 1.5);
    CHECK(reader.note("scene") == "00ff");
    CHECK(reader.note("absent").empty());
    CHECK(reader.row_count("contacts/history") == 0);
    CHECK_THROWS_AS((void)reader.scalar("absent"), core::FileError);
}

TEST_CASE("the digest of a checkpoint is that of the state in memory, and differs when one bit differs")
{
    const Folder folder;
    State state = whole_state(1.0);
    const io::CheckpointReader reader(state.write(folder.path(), 3, alone()), alone());
    CHECK(reader.digest().size() == 16);
    CHECK(reader.digest() == state.digest(3, alone()));
    double& value = state.position[5];
    value = std::nextafter(value, 2.0);
    CHECK(reader.digest() != state.digest(3, alone()));
}

TEST_CASE("only the newest two checkpoints stay")
{
    const Folder folder;
    const State state = whole_state(1.0);
    for (const int step : {1, 2, 3, 10}) (void)state.write(folder.path(), step, alone());
    const auto left = io::list_checkpoints(folder.path());
    REQUIRE(left.size() == 2);
    CHECK(left[0].ends_with("checkpoint_0000000010.h5"));
    CHECK(left[1].ends_with("checkpoint_0000000003.h5"));
}

TEST_CASE("one changed byte in any dataset is refused by name, and the checkpoint before it is used")
{
    const Folder folder;
    const State state = whole_state(1.0);
    const std::string good = state.write(folder.path(), 1, alone()), path = state.write(folder.path(), 2, alone());
    const std::string bytes = bytes_of(path);
    const std::pair<double, std::string> parts[] = {{support::value_of(1.0, 2, 0, {1, 1, 1}), "fields/pressure"},
                                                    {support::value_of(11.0, 4, 2, {1, 1, 1}), "fields/velocity"},
                                                    {support::value_of(21.0, 0, 1, {1, 4, 1}), "fields/flux"},
                                                    {std::cos(1.0 + 8999 + 0.2), "rows/particles/position"}};
    for (const auto& [value, name] : parts) {
        std::string changed = bytes;
        REQUIRE(place_of(bytes, value) != std::string::npos);
        changed[place_of(bytes, value)] ^= 1;
        set_bytes(path, changed);
        const auto choice = io::newest_good_checkpoint(folder.path(), alone());
        CHECK(choice.path == good);
        REQUIRE(choice.refused.size() == 1);
        CHECK(choice.refused[0].find(name) != std::string::npos);
    }
}

TEST_CASE("a changed byte anywhere is refused or without effect")
{
    const Folder folder;
    const std::string path = whole_state(1.0).write(folder.path(), 1, alone());
    const std::string bytes = bytes_of(path), digest = io::CheckpointReader(path, alone()).digest();
    int refused = 0, harmless = 0;
    for (std::size_t place = 0; place < bytes.size(); place += 397) {
        std::string changed = bytes;
        changed[place] ^= 0x10;
        set_bytes(path, changed);
        if (io::newest_good_checkpoint(folder.path(), alone()).path.empty()) ++refused;
        else if (io::CheckpointReader(path, alone()).digest() == digest) ++harmless;
        else FAIL("an unnoticed change at byte ", place);
    }
    MESSAGE(refused, " changes refused, ", harmless, " without effect");
    CHECK(refused > 20 * harmless); // what is left over are unused places between datasets
}

TEST_CASE("a cut file is refused at any length")
{
    const Folder folder;
    const State state = whole_state(1.0);
    const std::string good = state.write(folder.path(), 1, alone()), path = state.write(folder.path(), 2, alone());
    const std::string bytes = bytes_of(path);
    for (const double part : {0.0, 0.001, 0.2, 0.5, 0.9, 0.99, 0.9999}) {
        set_bytes(path, bytes.substr(0, std::size_t(part * double(bytes.size()))));
        CHECK(io::newest_good_checkpoint(folder.path(), alone()).path == good);
    }
}

TEST_CASE("a folder without a good checkpoint gives none, and one that cannot be made is an error")
{
    const Folder folder;
    CHECK(io::newest_good_checkpoint(folder.path() + "/absent", alone()).path.empty());
    set_bytes(folder.path() + "/file", "x");
    CHECK_THROWS_AS(io::CheckpointWriter(folder.path() + "/file/below", 1, alone()), core::FileError);
}

TEST_CASE("a full disk is an error that leaves the checkpoint before it alone")
{
    const Folder folder;
    const State state = whole_state(1.0);
    const std::string good = state.write(folder.path(), 1, alone());
    rlimit old{};
    ::getrlimit(RLIMIT_FSIZE, &old);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    for (const rlim_t bytes : {1'000, 100'000, 300'000}) { // a limit on the size of files acts like a full disk
        const rlimit small{bytes, old.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &small);
        CHECK_THROWS_AS((void)state.write(folder.path(), 2, alone()), core::FileError);
        ::setrlimit(RLIMIT_FSIZE, &old);
        CHECK(io::newest_good_checkpoint(folder.path(), alone()).path == good);
        CHECK(std::distance(fs::directory_iterator(folder.path()), {}) == 1);
    }
    std::signal(SIGXFSZ, handler);
    CHECK_NOTHROW((void)state.write(folder.path(), 3, alone()));
}

TEST_CASE("helper: write checkpoints until killed" * doctest::skip())
{
    const char* directory = std::getenv("ISAGO_TEST_FOLDER");
    if (!directory) return;
    for (int step = 1;; ++step) (void)whole_state(step).write(directory, step, alone());
}

TEST_CASE("after kill -9 at any moment there is a good checkpoint")
{
    const Folder folder;
    (void)whole_state(0.0).write(folder.path(), 0, alone());
    for (int trial = 0; trial < 6; ++trial) {
        const pid_t child = ::fork();
        if (child == 0) {
            const std::string target = "ISAGO_TEST_FOLDER=" + folder.path();
            const char* arguments[] = {"unit_io", "--test-case=helper: write checkpoints until killed", "--no-skip", nullptr};
            const char* environment[] = {target.c_str(), "OMPI_MCA_ess_singleton_isolated=1", "PATH=/usr/bin:/bin", nullptr};
            ::execve("/proc/self/exe", const_cast<char**>(arguments), const_cast<char**>(environment));
            ::_exit(1);
        }
        ::usleep(700'000 + 37'000 * unsigned(trial));
        ::kill(child, SIGKILL);
        ::waitpid(child, nullptr, 0);
        const auto choice = io::newest_good_checkpoint(folder.path(), alone());
        REQUIRE(!choice.path.empty());
        CHECK(choice.refused.empty());
        const io::CheckpointReader reader(choice.path, alone());
        const int step = int(8 * reader.scalar("time"));
        CHECK(reader.digest() == whole_state(step).digest(step, alone()));
    }
    CHECK(io::list_checkpoints(folder.path()).front() > folder.path() + "/checkpoint_0000000002.h5");
}
