#include <cstdio>
#include <exception>

#include "game/base/one_line.h"
#include "game/base/process.h"
#include "game/command_line.h"

namespace {

// The only catch of what nobody foresaw.
game::Outcome<int> run(int argc, char** argv) try {
    if (auto prepared = game::prepare_process(); !prepared) return tl::unexpected(prepared.error());
    return game::run_command_line(argc, argv);
} catch (const std::exception& thrown) {
    return tl::unexpected(game::failure_of(thrown));
}

}  // namespace

// The only place that turns failures into exit statuses.
int main(int argc, char** argv) {
    const auto status = run(argc, argv);
    const auto printed = game::finish_standard_output();
    if (!status) std::fprintf(stderr, "couloir: %s\n", game::one_line(status.error().sentence).c_str());
    if (!printed) std::fprintf(stderr, "couloir: %s\n", game::one_line(printed.error().sentence).c_str());
    return !status ? status.error().status : !printed ? printed.error().status : *status;
}
