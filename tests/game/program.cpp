#include "tests/game/program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "tests/support/places.h"

namespace game::test {
namespace {

void redirect(const std::filesystem::path& path, int flags, int descriptor) {
    const int file = open(path.c_str(), flags | O_CLOEXEC, 0600);
    if (file < 0 || dup2(file, descriptor) < 0) std::_Exit(127);
    if (file == descriptor) fcntl(file, F_SETFD, 0);  // dup2() would clear it
}

pid_t start(const std::vector<std::string>& arguments, const std::filesystem::path& out,
            const std::filesystem::path& err, const Surroundings& around = {}) {
    const std::string program = support::program().string();
    std::vector<char*> argv{const_cast<char*>(program.c_str())};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no child process");
    if (child > 0) return child;
    redirect("/dev/null", O_RDONLY, STDIN_FILENO);
    redirect(out, O_WRONLY | O_CREAT | O_TRUNC, STDOUT_FILENO);
    redirect(err, O_WRONLY | O_CREAT | O_TRUNC, STDERR_FILENO);
    for (const auto& [descriptor, path] : around.opened) redirect(path, O_RDWR | O_CREAT, descriptor);
    for (const int descriptor : around.closed) close(descriptor);
    for (const auto& [variable, value] : around.environment) setenv(variable.c_str(), value.c_str(), 1);
    for (const auto& [resource, most] : around.limits) {
        const rlimit limit{most, most};
        setrlimit(static_cast<__rlimit_resource>(resource), &limit);
    }
    execv(program.c_str(), argv.data());
    std::_Exit(127);
}

}  // namespace

Finished couloir(const std::vector<std::string>& arguments, const Surroundings& around) {
    const support::TemporaryFolder folder;
    const auto out = around.out.empty() ? folder.path() / "out" : around.out, err = folder.path() / "err";
    int options = 0;
    if (waitpid(start(arguments, out, err, around), &options, 0) < 0)
        throw std::runtime_error("a child process was lost");
    const int status = WIFEXITED(options) ? WEXITSTATUS(options) : 128 + WTERMSIG(options);
    return {status, around.out.empty() ? read_bytes(out) : "", read_bytes(err)};
}

pid_t start_couloir(const std::vector<std::string>& arguments) {
    return start(arguments, "/dev/null", "/dev/null");
}

Peak peak_of(const std::vector<std::string>& arguments) {
    const pid_t child = start_couloir(arguments);
    int status = 0;
    rusage usage{};
    if (wait4(child, &status, 0, &usage) != child) return {};
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, static_cast<std::uint64_t>(usage.ru_maxrss) * 1024};
}

std::string read_bytes(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream stream(path, std::ios::binary);
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace game::test
