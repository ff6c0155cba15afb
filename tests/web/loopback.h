#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>

namespace game::test {

// A web server on this machine alone.
class Loopback {
  public:
    // Answers every request with the same page. `headers`: further ones, each with its line break.
    explicit Loopback(std::string page, const std::string& headers = {});
    // Answers with the files of a folder, which may change meanwhile.
    explicit Loopback(const std::filesystem::path& folder, const std::string& headers = {}, int port = 0);
    ~Loopback();
    Loopback(const Loopback&) = delete;
    Loopback& operator=(const Loopback&) = delete;

    // "http://127.0.0.1:40123/".
    std::string address() const;
    int port() const { return port_; }
    int requests() const { return requests_; }

  private:
    using Answer = std::function<std::string(const std::string& request)>;  // whole, with its headers
    Loopback(Answer answer, int port);
    void serve();

    Answer answer_;
    int listening_ = -1;  // descriptor
    int port_ = 0;
    std::atomic<bool> ends_{false};
    std::atomic<int> requests_{0};
    std::thread thread_;
};

}  // namespace game::test
