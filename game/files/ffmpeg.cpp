#include "game/files/ffmpeg.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <sstream>
#include <utility>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "game/base/one_line.h"

namespace game {
namespace {

constexpr const char* kInstall =
    "no program ffmpeg is found, which writes films; install the package ffmpeg (sudo apt install ffmpeg)";

// What is in such a file of memory, at most its last 64 KiB.
std::string text_in(const files::Descriptor& file) {
    constexpr off_t kMost = 1 << 16;
    const off_t size = lseek(file.number(), 0, SEEK_END), from = size > kMost ? size - kMost : 0;
    std::string text(static_cast<std::size_t>(size > 0 ? size - from : 0), '\0');
    const ssize_t got = pread(file.number(), text.data(), text.size(), from);
    text.resize(static_cast<std::size_t>(got > 0 ? got : 0));
    return text;
}

// The last line that gives a reason: ffmpeg closes with one that does not, and an encoder greets on standard error.
std::string last_reason(const std::string& errors) {
    std::istringstream lines(errors);
    std::string reason;
    for (std::string line; std::getline(lines, line);)
        if (!line.empty() && line != "Conversion failed!" && !line.starts_with("Svt[info]"))
            reason = std::move(line);
    return one_line(reason);
}

tl::unexpected<Failure> not_started(int number) {
    if (number == ENOENT) return machine_fails(kInstall);
    return machine_fails(fmt::format("ffmpeg cannot be started: {}", std::strerror(number)));
}

}  // namespace

Outcome<Ffmpeg> Ffmpeg::start(std::vector<std::string> arguments) {
    // A socket, because a write to a closed one is an error and no signal.
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return not_started(errno);
    Ffmpeg ffmpeg;
    ffmpeg.socket_ = files::Descriptor(ends[0]);
    const files::Descriptor its_end(ends[1]);
    ffmpeg.errors_ = files::Descriptor(memfd_create("errors", MFD_CLOEXEC));
    if (!ffmpeg.errors_) return not_started(errno);
    if (auto begun = ffmpeg.begin(arguments, its_end); !begun) return tl::unexpected(begun.error());
    return ffmpeg;
}

Outcome<void> Ffmpeg::begin(std::vector<std::string>& arguments, const files::Descriptor& its_end) {
    std::string program = "ffmpeg";
    std::vector<char*> words{program.data()};
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    posix_spawn_file_actions_t descriptors;
    posix_spawnattr_t attributes;
    posix_spawn_file_actions_init(&descriptors);
    posix_spawnattr_init(&attributes);
    posix_spawn_file_actions_adddup2(&descriptors, its_end.number(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&descriptors, its_end.number(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&descriptors, errors_.number(), STDERR_FILENO);
    sigset_t none;
    sigemptyset(&none);  // a thread that starts it may block some
    posix_spawnattr_setsigmask(&attributes, &none);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK);
    const int error =
        posix_spawnp(&process_, program.c_str(), &descriptors, &attributes, words.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&descriptors);
    if (error == 0) return {};
    process_ = 0;
    return not_started(error);
}

Ffmpeg::Ffmpeg(Ffmpeg&& other) noexcept
    : process_(std::exchange(other.process_, 0)),
      ended_(other.ended_),
      socket_(std::move(other.socket_)),
      errors_(std::move(other.errors_)) {}

Ffmpeg::~Ffmpeg() {
    if (process_ == 0) return;
    stop();
    wait();
}

void Ffmpeg::stop() const {
    if (process_ != 0) kill(process_, SIGKILL);
}

bool Ffmpeg::write(std::span<const std::uint8_t> bytes) const {
    while (!bytes.empty()) {
        const ssize_t sent = send(socket_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
    return true;
}

void Ffmpeg::wait() {
    while (waitpid(process_, &ended_, 0) < 0)
        if (errno != EINTR) {  // whoever started this program ignores the end of its children
            ended_ = 0;
            break;
        }
    process_ = 0;
}

Outcome<void> Ffmpeg::finish() {
    socket_.close();
    if (process_ != 0) wait();
    if (WIFEXITED(ended_) && WEXITSTATUS(ended_) == 0) return {};
    const std::string reason = last_reason(text_in(errors_));
    if (!reason.empty()) return machine_fails("ffmpeg: " + reason);
    return machine_fails(WIFSIGNALED(ended_)
                             ? fmt::format("ffmpeg was ended by signal {}", WTERMSIG(ended_))
                             : fmt::format("ffmpeg ended with status {}", WEXITSTATUS(ended_)));
}

std::string Ffmpeg::printed() const {
    std::string text;
    std::array<char, 4096> piece{};
    while (true) {
        const ssize_t got = recv(socket_.number(), piece.data(), piece.size(), 0);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return text;
        text.append(piece.data(), static_cast<std::size_t>(got));
    }
}

Outcome<std::vector<std::string>> encoders_of_ffmpeg() {
    auto ffmpeg = Ffmpeg::start({"-hide_banner", "-loglevel", "error", "-encoders"});
    if (!ffmpeg) return tl::unexpected(ffmpeg.error());
    std::istringstream lines(ffmpeg->printed());
    if (auto finished = ffmpeg->finish(); !finished) return tl::unexpected(finished.error());
    std::vector<std::string> names;
    for (std::string line, flags, name; std::getline(lines, line);)
        if (std::istringstream(line) >> flags >> name) names.push_back(name);
    return names;
}

}  // namespace game
