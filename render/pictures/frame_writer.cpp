#include "render/pictures/frame_writer.h"

#include <algorithm>
#include <exception>
#include <system_error>
#include <utility>

#include "sim/core/check.h"

namespace render {

int FrameWriter::suitable_workers() {
    const int cores = static_cast<int>(std::thread::hardware_concurrency());  // 0 if unknown
    return std::clamp(cores - 1, 1, kMostWorkers);
}

FrameWriter::FrameWriter(std::size_t capacity, int workers) : capacity_(capacity) {
    CHECK(capacity >= 1 && workers >= 1);
    try {
        while (std::ssize(workers_) < workers) workers_.emplace_back([this] { write_all(); });
    } catch (const std::system_error&) {  // no more threads are allowed; fewer are only slower
        if (workers_.empty()) throw;
    }
}

FrameWriter::~FrameWriter() {
    static_cast<void>(finish());
}

void FrameWriter::submit(Picture picture, std::filesystem::path path) {
    std::unique_lock lock(mutex_);
    CHECK(!closing_);
    changed_.wait(lock, [this] { return waiting_.size() < capacity_; });
    if (error_) return;
    waiting_.push_back({submitted_++, std::move(picture), std::move(path)});
    changed_.notify_all();
}

tl::expected<void, std::string> FrameWriter::finish() {
    {
        const std::scoped_lock lock(mutex_);
        closing_ = true;
        changed_.notify_all();
    }
    for (std::thread& worker : workers_) worker.join();
    workers_.clear();
    if (error_) return tl::unexpected(error_->message);
    return {};
}

// Catches exceptions, because none may leave the thread.
tl::expected<void, std::string> FrameWriter::write(const Job& job) {
    try {
        return write_png(job.picture, job.path, kFramePngCompression);
    } catch (const std::exception& thrown) {  // such as out of memory
        return tl::unexpected(job.path.string() + ": cannot be written: " + thrown.what());
    }
}

void FrameWriter::write_all() {
    std::unique_lock lock(mutex_);
    while (true) {
        changed_.wait(lock, [this] { return closing_ || !waiting_.empty(); });
        if (waiting_.empty()) return;
        const Job job = std::move(waiting_.front());
        waiting_.pop_front();
        changed_.notify_all();
        lock.unlock();
        auto written = write(job);
        lock.lock();
        if (!written) note({job.number, std::move(written.error())});
    }
}

// Keeps the error of the earliest job, because a later one may fail sooner on another thread. Jobs leave the
// queue in order, so those that still wait are later than this one.
void FrameWriter::note(Error error) {
    if (!error_ || error.number < error_->number) error_ = std::move(error);
    waiting_.clear();
    changed_.notify_all();
}

}  // namespace render
