// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/picture/picture_worker.hpp"
#include "io/picture/picture_renderer.hpp"

#include <exception>
#include <utility>

namespace io {

PictureWorker::PictureWorker(int width, int height, std::size_t waiting)
    : waiting_(waiting), thread_([this, width, height] { run(width, height); })
{
}

PictureWorker::~PictureWorker()
{
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void PictureWorker::submit(PictureScene scene, std::string path)
{
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return failed_ || jobs_.size() < waiting_; });
    if (failed_) return;
    jobs_.push_back({std::move(scene), std::move(path)});
    changed_.notify_all();
}

void PictureWorker::finish()
{
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return failed_ || (jobs_.empty() && !busy_); });
}

std::string PictureWorker::take_error()
{
    const std::lock_guard lock(mutex_);
    return std::exchange(error_, {});
}

int PictureWorker::written() const
{
    const std::lock_guard lock(mutex_);
    return written_;
}

bool PictureWorker::next(Job& job)
{
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return stopping_ || !jobs_.empty(); });
    if (jobs_.empty()) return false;
    job = std::move(jobs_.front());
    jobs_.pop_front();
    busy_ = true;
    changed_.notify_all();
    return true;
}

void PictureWorker::done()
{
    const std::lock_guard lock(mutex_);
    busy_ = false;
    ++written_;
    changed_.notify_all();
}

void PictureWorker::work(int width, int height)
{
    std::unique_ptr<Renderer> renderer; // made at the first picture, by the thread that uses it
    for (Job job; next(job); done()) {
        if (!renderer) renderer = std::make_unique<Renderer>(width, height);
        write_png(renderer->draw(job.scene), job.path);
    }
}

void PictureWorker::run(int width, int height)
{
    try {
        work(width, height);
    } catch (const std::exception& error) {
        const std::lock_guard lock(mutex_);
        error_ = error.what();
        failed_ = true;
        jobs_.clear();
        changed_.notify_all();
    }
}

} // namespace io
