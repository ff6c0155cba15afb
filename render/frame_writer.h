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

// Writes PNGs on a thread of its own, in the order in which they were given, because a picture takes longer
// to write than to draw. Used from one thread.
class FrameWriter {
  public:
    // `capacity`: pictures that may wait, ≥ 1; a 1280×720 picture takes 2.8 MB.
    explicit FrameWriter(std::size_t capacity = 4);
    ~FrameWriter();  // writes what waits; call finish() to hear of errors
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    // Waits while the queue is full. After an error, pictures are dropped: finish() says why.
    void submit(Picture picture, std::filesystem::path path);

    // Waits until all is written. The first error, a sentence that names the file. Nothing may be submitted
    // afterwards.
    tl::expected<void, std::string> finish();

  private:
    struct Job {
        Picture picture;
        std::filesystem::path path;
    };

    static tl::expected<void, std::string> write(const Job& job);
    void write_all();

    std::size_t capacity_;
    std::mutex mutex_;  // guards the four below
    std::condition_variable changed_;
    std::deque<Job> waiting_;
    bool closing_ = false;
    std::optional<std::string> error_;
    std::thread worker_;
};

}  // namespace render
