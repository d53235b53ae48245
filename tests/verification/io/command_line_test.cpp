// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=120
// The program as users meet it: exit codes and output of its commands.
#include "tests/support/source_root.hpp"
#include "tests/unit/io/temporary_folder.hpp"
#include <cstdlib>
#include <doctest/doctest.h>
#include <sys/wait.h>

namespace fs = std::filesystem;

namespace {

const fs::path isago = fs::read_symlink("/proc/self/exe").parent_path().parent_path() / "io" / "isago";

struct Outcome {
    int code;
    std::string output;
};

/// Runs a shell command with `isago` standing for the program.
Outcome run(const std::string& arguments)
{
    const TemporaryFolder folder;
    const fs::path output = folder.path() / "output";
    const int status = std::system((isago.string() + " " + arguments + " > " + output.string() + " 2>&1").c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of_file(output)};
}

const std::string bed = (test::source_root() / "configs" / "settling_bed").string();

} // namespace

TEST_CASE("check accepts a good scene and shows all mistakes of a bad one with exit code 2")
{
    CHECK(run("check " + bed).code == 0);
    const TemporaryFolder folder;
    const std::string file = (folder.path() / "bad.yaml").string();
    write_file(file, "name: bad\nrun: { until: 3 }\ngird: {}\n");
    const Outcome bad = run("check " + file);
    CHECK(bad.code == 2);
    CHECK(bad.output.find(file + ":2:15: error: '3' has no unit") != std::string::npos);
    CHECK(bad.output.find(file + ":3:1: error: unknown key 'gird'") != std::string::npos);
    CHECK(run("check " + bed + " --set run.until=2").code == 2);
    CHECK(run("check " + bed + " --set 'run.until=2 s' --set particles.glass.count=3").code == 0);
    CHECK(run("check /no/such/scene").code == 2);
}

TEST_CASE("mistakes of the command line have exit code 2 and a suggestion")
{
    CHECK(run("chekc x").code == 2);
    CHECK(run("chekc x").output.find("did you mean 'check'?") != std::string::npos);
    CHECK(run("check").code == 2);
    CHECK(run("check " + bed + " --color").code == 2);
    CHECK(run("").code == 2);
    CHECK(run("explain stifness").code == 2);
}

TEST_CASE("help and version succeed, and the version names commit and libraries")
{
    CHECK(run("--help").code == 0);
    const Outcome version = run("--version");
    CHECK(version.code == 0);
    CHECK(version.output.starts_with("isago " ISAGO_VERSION " ("));
    CHECK(version.output.find("yaml-cpp") != std::string::npos);
    CHECK(run("explain coupling.filter").output.find("default 2 d") != std::string::npos);
}

TEST_CASE("the printed JSON Schema is valid and accepts every scene in configs/, and refuses a bad one")
{
    if (std::system("python3 -c 'import jsonschema, yaml' 2> /dev/null") != 0) {
        MESSAGE("python3-jsonschema and python3-yaml are not installed: not compared");
        return;
    }
    const TemporaryFolder folder;
    write_file(folder.path() / "schema.json", run("schema").output);
    write_file(folder.path() / "compare.py", R"(
import glob, json, sys, jsonschema, yaml
schema = json.load(open(sys.argv[1] + "/schema.json"))
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)
scenes = [yaml.safe_load(open(name)) for name in glob.glob(sys.argv[2] + "/configs/*/scene.yaml")]
assert len(scenes) >= 3
for scene in scenes:
    validator.validate(scene)
    assert not validator.is_valid({**scene, "gird": {}})
    assert not validator.is_valid({**scene, "run": {"until": 1}})
    assert not validator.is_valid({**scene, "grid": {}})
)");
    const std::string command =
        "python3 " + (folder.path() / "compare.py").string() + " " + folder.path().string() + " " + test::source_root().string();
    CHECK(std::system(command.c_str()) == 0);
}
