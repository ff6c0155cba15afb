#pragma once

#include <atomic>
#include <string>
#include <thread>

namespace game::test {

// A web server on this machine alone. It answers every request with the same page.
class Loopback {
  public:
    // `headers`: further ones, each with its line break.
    explicit Loopback(std::string page, const std::string& headers = {});
    ~Loopback();
    Loopback(const Loopback&) = delete;
    Loopback& operator=(const Loopback&) = delete;

    // "http://127.0.0.1:40123/".
    std::string address() const;
    int requests() const { return requests_; }

  private:
    void serve();

    std::string answer_;
    int listening_ = -1;  // descriptor
    int port_ = 0;
    std::atomic<bool> ends_{false};
    std::atomic<int> requests_{0};
    std::thread thread_;
};

}  // namespace game::test
