#include "render/frame_writer.h"

#include <exception>
#include <utility>

#include "sim/core/check.h"

namespace render {

FrameWriter::FrameWriter(std::size_t capacity) : capacity_(capacity), worker_([this] { write_all(); }) {
    CHECK(capacity >= 1);
}

FrameWriter::~FrameWriter() {
    static_cast<void>(finish());
}

void FrameWriter::submit(Picture picture, std::filesystem::path path) {
    std::unique_lock lock(mutex_);
    CHECK(!closing_);
    changed_.wait(lock, [this] { return waiting_.size() < capacity_; });
    if (error_) return;
    waiting_.push_back({std::move(picture), std::move(path)});
    changed_.notify_all();
}

tl::expected<void, std::string> FrameWriter::finish() {
    {
        const std::scoped_lock lock(mutex_);
        closing_ = true;
        changed_.notify_all();
    }
    if (worker_.joinable()) worker_.join();
    if (error_) return tl::unexpected(*error_);
    return {};
}

// Catches exceptions, because none may leave the thread.
tl::expected<void, std::string> FrameWriter::write(const Job& job) {
    try {
        return write_png(job.picture, job.path);
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
        if (error_) continue;
        lock.unlock();
        const auto written = write(job);
        lock.lock();
        if (!written) error_ = written.error();
    }
}

}  // namespace render
