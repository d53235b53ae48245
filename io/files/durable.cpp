// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/files/durable.hpp"
#include "core/base/error.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace io {
namespace {

[[noreturn]] void fail(const std::string& action, const std::string& path)
{
    throw core::FileError(core::text(path, ": cannot ", action, ": ", std::strerror(errno)));
}

void send_to_disk(const std::string& path)
{
    const int file = ::open(path.c_str(), O_RDONLY);
    if (file < 0) fail("open", path);
    const bool sent = ::fsync(file) == 0;
    const int reason = errno;
    ::close(file);
    errno = reason;
    if (!sent) fail("send it to the disk", path);
}

} // namespace

void make_directory(const std::string& path)
{
    std::error_code error;
    std::filesystem::create_directories(path, error);
    if (error) throw core::FileError(core::text(path, ": cannot make this folder: ", error.message()));
}

void make_empty_file(const std::string& path)
{
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (file < 0) fail("write", path);
    ::close(file);
}

void reserve_room(const std::string& path, std::size_t size)
{
    const int file = ::open(path.c_str(), O_WRONLY);
    if (file < 0) fail("open", path);
    const bool failed = ::fallocate(file, 0, 0, off_t(size)) != 0;
    const int reason = errno;
    ::close(file);
    errno = reason;
    if (failed && (reason == ENOSPC || reason == EFBIG || reason == EDQUOT)) fail("find room for it", path);
}

void cut_file(const std::string& path, std::size_t size)
{
    if (::truncate(path.c_str(), off_t(size)) != 0) fail("cut", path);
}

void rename_durably(const std::string& from, const std::string& to)
{
    send_to_disk(from);
    if (std::rename(from.c_str(), to.c_str()) != 0) fail("rename it to " + to, from);
    const auto folder = std::filesystem::path(to).parent_path().string();
    send_to_disk(folder.empty() ? "." : folder);
}

void write_durably(const std::string& path, const std::string& text)
{
    const std::string temporary = path + ".part";
    std::ofstream file(temporary, std::ios::binary);
    file << text;
    file.close();
    if (!file) fail("write", temporary);
    rename_durably(temporary, path);
}

} // namespace io
