#include <cstdio>
#include <exception>

#include "game/command_line.h"

// The only place that turns failures into exit statuses, and the only catch of what nobody foresaw.
int main(int argc, char** argv) try {
    const auto status = game::run_command_line(argc, argv);
    if (status) return *status;
    std::fprintf(stderr, "couloir: %s\n", status.error().sentence.c_str());
    return status.error().status;
} catch (const std::exception& unforeseen) {
    std::fprintf(stderr, "couloir: %s\n", unforeseen.what());
    return game::Failure::kMachine;
}
