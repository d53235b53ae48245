// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// One folder for all ranks of a test.
#include "core/comm/communicator.hpp"
#include <filesystem>
#include <string>
#include <unistd.h>

namespace support {

/// Under the system's temporary folder; rank 0 removes it at the end.
class SharedFolder {
public:
    explicit SharedFolder(const core::Communicator& ranks) : ranks_(ranks)
    {
        path_ = (std::filesystem::temp_directory_path() / ("isago_ranks_" + std::to_string(::getpid()))).string();
        const auto view = std::as_bytes(std::span(path_));
        std::vector<std::byte> bytes(view.begin(), view.end());
        ranks_.broadcast(bytes, 0);
        path_.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        std::filesystem::create_directories(path_);
        ranks_.barrier();
    }
    ~SharedFolder()
    {
        ranks_.barrier();
        std::error_code ignored;
        if (ranks_.rank() == 0) std::filesystem::remove_all(path_, ignored);
    }
    SharedFolder(const SharedFolder&) = delete;
    SharedFolder& operator=(const SharedFolder&) = delete;
    [[nodiscard]] const std::string& path() const { return path_; }

private:
    core::Communicator ranks_;
    std::string path_;
};

} // namespace support
