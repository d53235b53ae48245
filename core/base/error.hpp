// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What can go wrong: the user's mistakes, numerical failures, trouble with files.
#include <concepts>
#include <sstream>
#include <stdexcept>
#include <string>

namespace core {

/// The parts, written one after the other.
template <class... Parts>
[[nodiscard]] std::string text(const Parts&... parts)
{
    std::ostringstream stream;
    (stream << ... << parts);
    return stream.str();
}

struct Error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The user asked for something impossible; the message says what, where and what to do.
struct ConfigError : Error {
    using Error::Error;
};

/// The computation failed; the message names field, block, cell and time.
struct NumericsError : Error {
    using Error::Error;
};

/// A file is missing, torn, changed or cannot be written.
struct FileError : Error {
    using Error::Error;
};

/// @throws E with `message` unless `condition` holds.
template <std::derived_from<Error> E>
void require(bool condition, const std::string& message)
{
    if (!condition) throw E(message);
}

} // namespace core
