#include "tests/fuzz/try_reader.h"

#include <fmt/format.h>

#include "game/ensemble/spec.h"

namespace game::test {
namespace {

Outcome<void> try_ensemble(const std::filesystem::path& file) {
    Overrides overrides;
    overrides.squares = kTriedSquares;
    const auto spec = read_ensemble_spec(file, overrides);
    if (!spec) return tl::unexpected(spec.error());
    for (const std::int64_t member : {std::int64_t{1}, std::int64_t{2}, spec->members})
        for (std::size_t i = 0; i < spec->variables.size(); ++i) {
            const Variable& variable = spec->variables[i];
            const double value = spec->sample(member)[i];
            const bool is_param = variable.of == Variable::Of::kParameter;
            const double least = is_param ? static_cast<double>(variable.param->least) : 0,
                         most = is_param ? static_cast<double>(variable.param->most) : 1e5;
            // Values have six digits, which may round one beyond its bound.
            if (!(value >= least - 1e-5 * most && value <= most * 1.00001))
                return broken(fmt::format("{} is {}", variable.name(), value));
        }
    if (spec->maps.thresholds.size() > Maps::kMostThresholds) return broken("too many thresholds");
    return {};
}

}  // namespace

const TriedReader kTriedEnsemble{"ensemble", "x.toml", try_ensemble};

}  // namespace game::test
