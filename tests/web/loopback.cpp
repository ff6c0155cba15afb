#include "tests/web/loopback.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <stdexcept>
#include <utility>

namespace game::test {
namespace {

void send_all(int connection, const std::string& bytes) {
    for (std::size_t sent = 0; sent < bytes.size();) {
        const auto some = send(connection, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
        if (some <= 0) return;
        sent += static_cast<std::size_t>(some);
    }
}

bool ends_soon(int descriptor, int milliseconds) {
    pollfd asked{descriptor, POLLIN, 0};
    return poll(&asked, 1, milliseconds) <= 0;
}

}  // namespace

Loopback::Loopback(std::string page, const std::string& headers)
    : answer_("HTTP/1.1 200 OK\r\nContent-Type: text/html\r\nConnection: close\r\n" + headers +
              "Content-Length: " + std::to_string(page.size()) + "\r\n\r\n" + std::move(page)),
      listening_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    auto* const general = reinterpret_cast<sockaddr*>(&place);
    socklen_t size = sizeof place;
    if (listening_ < 0 || bind(listening_, general, size) != 0 || listen(listening_, 8) != 0 ||
        getsockname(listening_, general, &size) != 0)
        throw std::runtime_error("no server on this machine");
    port_ = ntohs(place.sin_port);
    thread_ = std::thread([this] { serve(); });
}

Loopback::~Loopback() {
    ends_ = true;
    thread_.join();
    close(listening_);
}

std::string Loopback::address() const {
    return "http://127.0.0.1:" + std::to_string(port_) + "/";
}

void Loopback::serve() {
    while (!ends_) {
        if (ends_soon(listening_, 50)) continue;
        const int connection = accept4(listening_, nullptr, nullptr, SOCK_CLOEXEC);
        if (connection < 0) continue;
        // A browser may open a connection in advance and ask for nothing.
        std::string request;
        std::array<char, 4096> some{};
        while (request.find("\r\n\r\n") == std::string::npos && !ends_soon(connection, 500)) {
            const auto count = recv(connection, some.data(), some.size(), 0);
            if (count <= 0) break;
            request.append(some.data(), static_cast<std::size_t>(count));
        }
        if (request.find("\r\n\r\n") != std::string::npos) {
            ++requests_;
            send_all(connection, answer_);
        }
        close(connection);
    }
}

}  // namespace game::test
