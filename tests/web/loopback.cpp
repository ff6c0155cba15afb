#include "tests/web/loopback.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <utility>

#include "tests/game/program.h"

namespace game::test {
namespace {

void send_all(int connection, const std::string& bytes) {
    for (std::size_t sent = 0; sent < bytes.size();) {
        const auto some = send(connection, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
        if (some <= 0) return;
        sent += static_cast<std::size_t>(some);
    }
}

std::string answer_of(const std::string& bytes, const std::string& type, const std::string& headers) {
    return "HTTP/1.1 200 OK\r\nContent-Type: " + type + "\r\nConnection: close\r\n" + headers +
           "Content-Length: " + std::to_string(bytes.size()) + "\r\n\r\n" + bytes;
}

std::string type_of(const std::filesystem::path& file) {
    static const std::map<std::string, std::string> kTypes{{".html", "text/html"},
                                                           {".css", "text/css"},
                                                           {".js", "text/javascript"},
                                                           {".svg", "image/svg+xml"},
                                                           {".png", "image/png"},
                                                           {".jpg", "image/jpeg"},
                                                           {".webmanifest", "application/manifest+json"}};
    return kTypes.at(file.extension().string());
}

bool ends_soon(int descriptor, int milliseconds) {
    pollfd asked{descriptor, POLLIN, 0};
    return poll(&asked, 1, milliseconds) <= 0;
}

}  // namespace

Loopback::Loopback(std::string page, const std::string& headers)
    : Loopback([answer = answer_of(page, "text/html", headers)](const std::string&) { return answer; }, 0) {}

Loopback::Loopback(const std::filesystem::path& folder, const std::string& headers, int port)
    : Loopback(
          [folder, headers](const std::string& request) {
              std::string name =
                  request.substr(5, request.find_first_of(" ?", 5) - 5);  // "GET /name HTTP/1.1"
              if (name.empty()) name = "index.html";
              const std::filesystem::path file = folder / name;
              if (!std::filesystem::exists(file))
                  return std::string("HTTP/1.1 404 Not Found\r\nContent-Length: 0\r\n\r\n");
              return answer_of(read_bytes(file), type_of(file), headers);
          },
          port) {}

Loopback::Loopback(Answer answer, int port)
    : answer_(std::move(answer)), listening_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    const int again = 1;  // another server may have had this port a moment ago
    setsockopt(listening_, SOL_SOCKET, SO_REUSEADDR, &again, sizeof again);
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(static_cast<std::uint16_t>(port));
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
            send_all(connection, answer_(request));
        }
        close(connection);
    }
}

}  // namespace game::test
