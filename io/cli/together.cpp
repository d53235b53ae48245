// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/cli/together.hpp"
#include "core/base/error.hpp"
#include "core/comm/ending.hpp"
#include "io/cli/command.hpp"
#include <algorithm>
#include <iostream>
#include <span>

namespace io {
namespace {

constexpr double patience = 20; // [s] for ranks that fail together but not at the same moment

void print_once(const core::Communicator& ranks, const std::string& message)
{
    std::vector<std::string> printed;
    for (const auto& bytes : ranks.gather_all(std::as_bytes(std::span(message)))) {
        const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        if (ranks.rank() != 0 || std::find(printed.begin(), printed.end(), text) != printed.end()) continue;
        std::cerr << text << std::endl;
        printed.push_back(text);
    }
}

} // namespace

int run_together(const core::Communicator& ranks, const std::function<int()>& body)
{
    const core::Communicator ending = ranks.duplicate();
    std::string message;
    int code = exit_failure;
    try {
        return body();
    } catch (const core::ConfigError& error) {
        message = error.what();
        code = exit_user_error;
    } catch (const std::exception& error) {
        message = std::string("isago: ") + error.what();
    }
    while (message.ends_with('\n')) message.pop_back();
    if (core::all_arrive_within(ending, patience)) {
        print_once(ending, message);
        return code;
    }
    std::cerr << "rank " << ranks.rank() << " alone: " << message << std::endl;
    core::abort_all_ranks(code);
}

} // namespace io
