// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/manifest.hpp"

#include "io/run/version.hpp"
#include <chrono>
#include <ctime>
#include <fmt/chrono.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sched.h>
#include <sys/utsname.h>
#include <unistd.h>

namespace io {

namespace {

/// The name of the processor, or empty where the system does not tell.
[[nodiscard]] std::string processor_name()
{
    std::ifstream stream("/proc/cpuinfo");
    for (std::string line; std::getline(stream, line);)
        if (line.starts_with("model name"))
            if (const auto colon = line.find(": "); colon != std::string::npos) return line.substr(colon + 2);
    return "";
}

[[nodiscard]] double memory_in_gigabytes()
{
    return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE)) / 1e9;
}

} // namespace

int available_cores()
{
    cpu_set_t cores;
    CPU_ZERO(&cores);
    return sched_getaffinity(0, sizeof cores, &cores) == 0 ? CPU_COUNT(&cores) : 1;
}

std::string manifest_text(const RunFacts& facts)
{
    utsname system{};
    uname(&system);
    nlohmann::ordered_json libraries;
    for (const auto& [name, version] : library_versions()) libraries[name] = version;
    const nlohmann::ordered_json json{
        {"program", "isago"},
        {"version", ISAGO_VERSION},
        {"commit", git_commit()},
        {"libraries", libraries},
        {"started", fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))},
        {"command", facts.command},
        {"ranks", facts.ranks},
        {"threads", facts.threads},
        {"executor", facts.executor},
        {"machine",
         {{"host", system.nodename},
          {"system", fmt::format("{} {} {}", system.sysname, system.release, system.machine)},
          {"processor", processor_name()},
          {"cores", available_cores()},
          {"memory_gigabytes", memory_in_gigabytes()}}},
    };
    return json.dump(2) + "\n";
}

} // namespace io
