// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A thread that draws and writes pictures beside the computation.
#include "io/picture/picture.hpp"
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

namespace io {

class PictureWorker {
public:
    /// @param waiting  scenes that may wait; submit() itself waits only when there are as many
    PictureWorker(int width, int height, std::size_t waiting = 2);
    /// Finishes what was submitted.
    ~PictureWorker();

    /// Takes a scene to be drawn into a PNG file. After the first error scenes are accepted and dropped.
    void submit(PictureScene scene, std::string path);
    /// Waits until everything is written.
    void finish();
    /// What went wrong, once: empty if nothing did since the last call.
    [[nodiscard]] std::string take_error();
    [[nodiscard]] int written() const;

private:
    struct Job {
        PictureScene scene;
        std::string path;
    };
    void run(int width, int height);
    void work(int width, int height);
    [[nodiscard]] bool next(Job& job);
    void done();

    std::size_t waiting_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Job> jobs_;
    std::string error_;
    bool failed_ = false, stopping_ = false, busy_ = false;
    int written_ = 0;
    std::thread thread_; // last: starts when everything else is there
};

} // namespace io
