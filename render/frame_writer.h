#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include <tl/expected.hpp>

#include "render/picture.h"

namespace render {

// Writes PNGs on its own thread, in the order given, because an image takes longer to write than to draw. Use
// it from one thread.
class FrameWriter {
  public:
    // `capacity`: images that may wait, ≥ 1. A 1280×720 image takes 2.8 MB.
    explicit FrameWriter(std::size_t capacity = 4);
    ~FrameWriter();  // writes the queued images; call finish() to get errors
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    // Queues an image. Waits while the queue is full. After an error, images are dropped and finish() returns
    // the error.
    void submit(Picture picture, std::filesystem::path path);

    // Waits until all images are written. Returns the first error, a sentence that names the file. Submit
    // nothing afterwards.
    tl::expected<void, std::string> finish();

  private:
    struct Job {
        Picture picture;
        std::filesystem::path path;
    };

    static tl::expected<void, std::string> write(const Job& job);
    void write_all();

    std::size_t capacity_;
    std::mutex mutex_;  // guards the next four members
    std::condition_variable changed_;
    std::deque<Job> waiting_;
    bool closing_ = false;
    std::optional<std::string> error_;
    std::thread worker_;
};

}  // namespace render
