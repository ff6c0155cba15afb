#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <tl/expected.hpp>

#include "render/pictures/picture.h"

namespace render {

// Writes frames as PNGs on threads of its own (kFramePngCompression), so that drawing need not wait for them.
// Use it from one thread.
class FrameWriter {
  public:
    static constexpr std::size_t kCapacity = 4;
    static constexpr int kMostWorkers = 4;  // together 200 frames of 1280×720 per second

    // The number of threads for this machine: one per core but the one that draws, 1 to kMostWorkers.
    static int suitable_workers();

    // `capacity`: images that may wait, ≥ 1. Each worker, ≥ 1, holds one more. A 1280×720 image takes 2.8 MB.
    explicit FrameWriter(std::size_t capacity = kCapacity, int workers = suitable_workers());
    ~FrameWriter();  // writes the queued images; call finish() to get errors
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    // Queues an image. Waits while the queue is full. After an error, images are dropped and finish() returns
    // the error.
    void submit(Picture picture, std::filesystem::path path);

    // Waits until all images are written. Returns the error of the image that was submitted first, a sentence
    // that names the file. Submit nothing afterwards.
    tl::expected<void, std::string> finish();

  private:
    struct Job {
        std::int64_t number = 0;  // in order of submission
        Picture picture;
        std::filesystem::path path;
    };
    struct Error {
        std::int64_t number = 0;  // of the job
        std::string message;
    };

    static tl::expected<void, std::string> write(const Job& job);
    void write_all();
    void note(Error error);

    std::size_t capacity_;
    std::mutex mutex_;  // guards the next five members
    std::condition_variable changed_;
    std::deque<Job> waiting_;
    std::int64_t submitted_ = 0;
    bool closing_ = false;
    std::optional<Error> error_;
    std::vector<std::thread> workers_;
};

}  // namespace render
