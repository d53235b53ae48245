// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Files that are either complete or not there: write under another name, send to the disk, rename.
#include <cstddef>
#include <string>

namespace io {

/// All throw core::FileError with the path and the system's reason.
void make_directory(const std::string& path);
void make_empty_file(const std::string& path);
/// Makes sure that the file can grow to `size` bytes; does nothing on file systems that cannot promise it.
void reserve_room(const std::string& path, std::size_t size);
void cut_file(const std::string& path, std::size_t size);
/// Sends `from` to the disk, renames it to `to`, and sends the folder's entry to the disk.
void rename_durably(const std::string& from, const std::string& to);
/// Writes `text` as the whole content of `path`, by way of a temporary file.
void write_durably(const std::string& path, const std::string& text);

} // namespace io
