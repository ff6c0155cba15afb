#include <fmt/format.h>

#include <cstdio>

#include "game/base/print.h"
#include "game/commands/commands.h"
#include "sim/verification/cases.h"

namespace game {
namespace {

// The error on each grid, the order between the last two, and the tolerances.
std::string told(const sim::verification::Series& series) {
    std::string errors;
    for (std::size_t i = 0; i < series.errors.size(); ++i)
        errors += fmt::format("{:>5} {:<9.2e}", series.squares[i], series.errors[i]);
    const std::string order = series.least_order > 0
                                  ? fmt::format("{:5.2f} (≥ {:.2f})", series.order(), series.least_order)
                                  : std::string(14, ' ');
    return fmt::format("  {:<21}{:<15}{:<48}{}  ≤ {:.1e}  {}\n", series.scheme, series.measure, errors, order,
                       series.most, series.holds() ? "ok" : "EXCEEDED");
}

}  // namespace

Outcome<int> verify_physics() {
    print_text(
        "The solver compared with exact solutions, in double without quanta: relative errors on finer and\n"
        "finer grids (squares, error), the order between the last two, and the tolerances of both.\n");
    int missed = 0, all = 0;
    for (const sim::verification::Case& each : sim::verification::cases()) {
        print_text(fmt::format("\n{}: {}\n", each.name, each.answer));
        std::fflush(stdout);  // a case takes seconds
        for (const sim::verification::Series& series : each.run()) {
            print_text(told(series));
            ++all;
            missed += !series.holds();
        }
    }
    print_text(fmt::format("\n{} of {} within tolerance\n", all - missed, all));
    return missed == 0 ? 0 : Failure::kBadAnswer;
}

}  // namespace game
