// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The .series file that tells ParaView which result file belongs to which time.
#include <string>
#include <vector>

namespace io {

/// A list of result files in time order, kept in `path`. For one rank only.
class Series {
public:
    /// Goes on with the list in `path`, if there is one that can be read.
    explicit Series(std::string path);
    /// Forgets what is not earlier than `time` [s] (left over from before a restart), adds the file, and saves.
    void add(const std::string& file, double time);

private:
    struct Entry {
        std::string file;
        double time = 0.0;
    };
    std::string path_;
    std::vector<Entry> entries_;
};

} // namespace io
