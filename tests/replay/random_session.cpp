#include "tests/replay/random_session.h"

#include <algorithm>
#include <random>

#include <fmt/format.h>

#include "game/recording/format.h"
#include "game/recording/recording_file.h"
#include "game/session/sandbox.h"
#include "sim/world/state_hash.h"
#include "tests/support/worlds.h"

namespace game::test {
namespace {

constexpr int kLongestWait = 900;  // ticks, until a world is at rest
constexpr int kThreads[] = {1, 2, 3, 8};

// Uses only whole numbers from one generator, so that a seed gives the same session with every library.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : random_(seed) {}
    int below(int n) { return static_cast<int>(random_() % static_cast<std::uint64_t>(n)); }
    bool one_in(int n) { return below(n) == 0; }
    int between(int least, int most) { return least + below(most - least + 1); }
    double real(double least, double most) {
        return least + (most - least) * static_cast<double>(random_() >> 11) * 0x1p-53;
    }

  private:
    std::mt19937_64 random_;
};

sim::Border random_border(Dice& dice) {
    constexpr sim::Border kAll[] = {sim::Border::kWall, sim::Border::kOpen, sim::Border::kSink};
    return kAll[dice.below(3)];
}

support::Ground random_ground(Dice& dice) {
    const int squares = dice.one_in(4) ? dice.between(33, 62) : dice.between(16, 32);
    switch (dice.below(3)) {
        case 0:
            return support::rough(squares, 2, static_cast<unsigned>(dice.below(1 << 20)));
        case 1:
            return support::plane(squares, 2, dice.real(0.3, 0.68), 2);
        default:
            return support::pile(squares, 2, dice.real(0.4, 0.8), dice.real(2, 8));
    }
}

Scenario random_start(Dice& dice) {
    support::Ground ground = random_ground(dice);
    if (dice.one_in(3)) {
        const int x0 = dice.below(ground.grid.nx - 3), y0 = dice.below(ground.grid.ny - 3);
        for (int y = y0; y < y0 + 3; ++y)
            for (int x = x0; x < x0 + 3; ++x) ground.has_data[ground.at(x, y)] = 0;
    }
    Scenario scenario;
    scenario.scene = scenario.terrain = "random";
    scenario.title = "A random session";
    scenario.material = "snow-dry";
    const support::Physics physics =
        support::kPhysics[dice.below(static_cast<int>(std::size(support::kPhysics)))];
    scenario.params = support::lively(physics.model, physics.scheme);
    constexpr sim::Law kLaws[] = {sim::Law::kConstant, sim::Law::kSlope, sim::Law::kShear};
    scenario.params.law = kLaws[dice.below(3)];
    scenario.params.speed_per_slope = 7;
    scenario.params.max_speed = 8;
    for (sim::Border& border : scenario.params.borders) border = random_border(dice);
    scenario.grid = ground.grid;
    scenario.bedrock = ground.bedrock;
    scenario.depth = ground.depth;
    scenario.rolling = ground.rolling;
    scenario.has_data = ground.has_data;
    if (dice.one_in(8)) {
        sim::Params lower = scenario.params;
        lower.exchange_rate = 1;
        lower.stop_slope = 0.55f;
        std::vector<float> depth = ground.depth;
        for (float& d : depth) d *= 0.5f;
        scenario.lower = Scenario::Lower{"soil", lower, std::move(depth), 2000, {}, {}};
    }
    if (!dice.one_in(4)) scenario.density = 1500;  // with none, water is refused
    if (scenario.params.model == sim::Model::kBcreInertial && !scenario.lower && scenario.density &&
        dice.one_in(2)) {
        scenario.weather = sim::Calendar{.hours = static_cast<double>(dice.between(1, 120))};
        scenario.weather->seed = dice.below(1000);
    }
    if (dice.one_in(6)) scenario.look.flow = render::FlowLook{render::FlowPattern::kSoil};  // tracks fronts
    return scenario;
}

// A random parameter of the manifest, with a value that a user might choose for this world.
sim::Command random_command(Dice& dice, const Scenario& scenario) {
    const sim::CommandInfo& info = sim::kCommands[dice.below(std::size(sim::kCommands))];
    const double dx = static_cast<double>(scenario.grid.dx);
    sim::Command command;
    command.kind = info.kind;
    // Of an object, which must be on the grid.
    const bool stands = info.kind >= sim::CommandKind::kHouse && info.kind <= sim::CommandKind::kRemove;
    const auto place = [&](int vertices) {
        return (stands ? dice.real(0, vertices - 1) : dice.real(-4, vertices + 3)) * dx;
    };
    for (const sim::CommandNumber& number : info.numbers) {
        double& value = command.*number.value;
        if (number.name == "x") value = place(scenario.grid.nx);
        if (number.name == "y") value = place(scenario.grid.ny);
        if (number.name == "to_x") value = command.x + dice.real(-15, 15) * dx;
        if (number.name == "to_y") value = command.y + dice.real(-15, 15) * dx;
        if (number.name == "radius")
            value = dice.one_in(5) ? dice.real(0, 1) : dice.real(1, 0.4 * scenario.grid.nx * dx);
        if (number.name == "rate")
            value = info.kind == sim::CommandKind::kPour ? dice.real(0, 40) * dx * dx
                                                         : dice.real(0, std::min(number.most, 5.0));
        if (number.name == "duration") value = dice.one_in(2) ? 0 : dice.real(0, 2);
        if (number.name == "depth") value = dice.real(0, 3);
        if (number.name == "rise") value = dice.real(std::max(number.least, -4.0), 4);
        if (number.name == "level") value = scenario.datum + dice.real(-10, 10);
        if (number.name == "turn") value = dice.real(-180, 180);
        if (number.name == "length" || number.name == "width")
            value = std::clamp(dice.real(0.5, 5) * dx, number.least, number.most);
        if (number.name == "height" || number.name == "diameter")
            value = dice.real(number.least, number.most);
        if (number.name == "strength") value = dice.real(0.5, 20);
        if (number.name == "stems") value = dice.real(50, 1200);
        if (number.name == "at") value = dice.between(0, 80);
        if (number.name == "hours") value = dice.between(1, 30);
        if (number.name == "precipitation") value = dice.real(0, 12) * command.hours;
        if (number.name == "wind_from") value = dice.real(-360, 360);
        if (number.name == "wind_speed") value = dice.real(0, 25);
        if (number.name == "warmer") value = dice.real(-20, 20);
        if (number.name == "cloud") value = dice.real(0, 1);
        if (number.name == "event") value = dice.between(1, 3);
    }
    if (info.has_slope && dice.one_in(6)) {
        command.least_slope = dice.real(0, 40);
        command.most_slope = command.least_slope + dice.real(5, 40);
    }
    if (info.has_layer && dice.one_in(3)) command.layer = sim::Layer::kStanding;
    if (info.has_profile && dice.one_in(3)) command.profile = sim::Profile::kCone;
    if (info.has_part && scenario.lower && dice.one_in(2)) command.of = sim::Part::kLower;
    if (info.has_param) {
        do command.param = static_cast<std::size_t>(dice.below(std::size(sim::kParams)));
        while (sim::kParams[command.param].fixed);
        const sim::ParamInfo& param = sim::kParams[command.param];
        const double now = static_cast<double>(scenario.params.*param.value);
        command.value = std::clamp(now * dice.real(0.6, 1.5), static_cast<double>(param.least),
                                   static_cast<double>(param.most));
    }
    return command;
}

Act random_act(Dice& dice, const Scenario& scenario) {
    Act act;
    const int which = dice.below(22);
    if (which < 10) {
        act.kind = Act::kHand;
        act.command = random_command(dice, scenario);
    } else if (which < 14) {
        act.kind = Act::kTicks;
        act.ticks = dice.between(1, 90);
    } else if (which < 15) {
        act.kind = Act::kRest;
        act.ticks = dice.between(300, 400);
    } else if (which < 18) {
        act.kind = Act::kGo;
        act.where = dice.one_in(2) ? 1 : dice.real(0, 1);
    } else {
        act.kind = which < 20 ? Act::kUndo : which == 20 ? Act::kRedo : Act::kBranch;
    }
    return act;
}

// Two sandboxes with the same actions: one by the sweep,
// with a recorder and everything it shows, and a plain one.
class Lockstep {
  public:
    Lockstep(const RandomSession& session, std::filesystem::path folder, Tally& tally)
        : folder_(std::move(folder)), tally_(tally), files_{folder_ / "0.couloir"} {
        LoadedWorld loaded, plain;
        loaded.scene.scenario = plain.scene.scenario = session.scenario;
        plain.scene.scenario.look.flow.reset();
        auto recorder = record_into(files_.back(), session.scenario);
        played_.emplace(
            Sandbox::begin(std::move(loaded), {.threads = session.threads}, std::move(*recorder)).value());
        plain_.emplace(Sandbox::begin(std::move(plain), {.plain = true}, std::nullopt).value());
    }

    std::optional<std::string> play(const std::vector<Act>& acts) {
        if (auto fault = difference()) return fault;
        for (const Act& act : acts)
            if (auto fault = play(act)) return fault;
        if (const auto done = played_->finish(); !done) return done.error().sentence;
        for (const auto& file : files_) {
            if (auto fault = fault_of_recording(file, tally_.replays)) return fault;
            ++tally_.files;
        }
        return std::nullopt;
    }

  private:
    std::optional<std::string> play(const Act& act) {
        switch (act.kind) {
            case Act::kTicks:
                return pass(act.ticks);
            case Act::kRest:
                for (int i = 0; i < kLongestWait && !sim::at_rest(played_->session().state()); ++i)
                    if (auto fault = tick({})) return fault;
                return pass(act.ticks);
            case Act::kHand:
                played_->begin_action("act"), plain_->begin_action("act");
                return tick({&act.command, 1});
            case Act::kGo:
                return go(act.where);
            case Act::kUndo:
                if (played_->undo().has_value() != plain_->undo().has_value())
                    return "only one of the two refuses to undo";
                return difference();
            case Act::kRedo:
                if (played_->redo().has_value() != plain_->redo().has_value())
                    return "only one of the two refuses to redo";
                return difference();
            case Act::kBranch:
                return branch();
        }
        return std::nullopt;
    }

    std::optional<std::string> pass(int ticks) {
        for (int i = 0; i < ticks; ++i)
            if (auto fault = tick({})) return fault;
        return std::nullopt;
    }

    std::optional<std::string> tick(std::span<const sim::Command> hand) {
        // Inconsistent parameters are refused, but the tick is still done: in both, or in neither.
        const auto one = played_->tick(hand), other = plain_->tick(hand);
        if (one.has_value() != other.has_value())
            return "only one of the two refuses:  " + (one ? other : one).error().sentence;
        if (!one && one.error().status != Failure::kUnusable) return one.error().sentence;
        return difference();
    }

    // One tick at a time, to compare each.
    std::optional<std::string> go(double where) {
        const auto target =
            static_cast<std::int64_t>(where * static_cast<double>(played_->known_until()) + 0.5);
        for (bool there = false; !there;) {
            const auto toward = [&](Sandbox& sandbox) {
                bool may = true;
                return sandbox.go_toward(target, [&] { return std::exchange(may, false); });
            };
            const auto one = toward(*played_), other = toward(*plain_);
            for (const auto& gone : {one, other})
                if (!gone && gone.error().status != Failure::kUnusable) return gone.error().sentence;
            if (one.has_value() != other.has_value() || (one && *one != *other))
                return fmt::format("only one of the two reaches tick {}", target);
            if (auto fault = difference()) return fault;
            there = played_->session().state().tick == target;
        }
        return std::nullopt;
    }

    std::optional<std::string> branch() {
        files_.push_back(folder_ / fmt::format("{}.couloir", files_.size()));
        if (const auto taken = played_->take_over(into_file(files_.back())); !taken)
            return taken.error().sentence;
        if (const auto taken = plain_->take_over(into_file(std::nullopt)); !taken)
            return taken.error().sentence;
        return difference();
    }

    std::optional<std::string> difference() {
        ++tally_.ticks;
        const sim::State &a = played_->session().state(), &b = plain_->session().state();
        const auto wrong = [&](const std::string& what) { return fmt::format("tick {}: {}", a.tick, what); };
        if (a.tick != b.tick) return wrong(fmt::format("the plain kernel is at tick {}", b.tick));
        if (a.params != b.params) return wrong("other parameters");
        for (const auto& [name, field] : kFields)
            if (!support::same_bits(a.*field, b.*field)) return wrong(std::string(name) + " differs");
        if (a.mixture)
            for (const auto& [name, field] : kLowerFields)
                if (!support::same_bits((*a.mixture).*field, (*b.mixture).*field))
                    return wrong(fmt::format("{} of the lower material differs", name));
        if (a.weather)
            for (const auto& [name, field] : kWeatherFields)
                if (!support::same_bits((*a.weather).*field, (*b.weather).*field))
                    return wrong(fmt::format("{} of the weather differs", name));
        if (a.running_commands != b.running_commands) return wrong("other running commands");
        if (a.ledger != b.ledger) return wrong("another ledger");
        for (const Sandbox* each : {&*played_, &*plain_}) {
            const Session& session = each->session();
            if (session.state_line().hash != sim::state_hash(session.state()))
                return wrong(each == &*played_ ? "the hash is not the state's"
                                               : "the hash of the plain world is not its state's");
        }
        if (played_->session().state_line() != plain_->session().state_line())
            return wrong("other hashes of earlier ticks");
        return std::nullopt;
    }

    using StateField = sim::Field<float> sim::State::*;
    static constexpr std::pair<const char*, StateField> kFields[] = {
        {"bedrock", &sim::State::bedrock},       {"depth", &sim::State::depth},
        {"rolling", &sim::State::rolling},       {"velocity_x", &sim::State::velocity_x},
        {"velocity_y", &sim::State::velocity_y}, {"first_depth", &sim::State::first_depth}};
    static constexpr std::pair<const char*, sim::Field<float> sim::Mixture::*> kLowerFields[] = {
        {"rolling", &sim::Mixture::rolling},
        {"settled", &sim::Mixture::settled},
        {"untouched", &sim::Mixture::untouched}};

    static constexpr std::pair<const char*, sim::Field<float> sim::Weather::*> kWeatherFields[] = {
        {"base", &sim::Weather::base},
        {"strength", &sim::Weather::strength},
        {"water", &sim::Weather::water},
        {"surface", &sim::Weather::surface}};

    std::filesystem::path folder_;
    Tally& tally_;
    std::vector<std::filesystem::path> files_;
    std::optional<Sandbox> played_, plain_;
};

std::string to_text(const Act& act) {
    switch (act.kind) {
        case Act::kTicks:
            return fmt::format("ticks {}", act.ticks);
        case Act::kRest:
            return fmt::format("rest {}", act.ticks);
        case Act::kHand: {
            std::string line;
            write(TimedCommand{0, act.command}, line);
            return "hand " + line;
        }
        case Act::kGo:
            return fmt::format("go {}", act.where);
        case Act::kUndo:
            return "undo";
        case Act::kRedo:
            return "redo";
        case Act::kBranch:
            return "branch";
    }
    return "";
}

}  // namespace

void Tally::add(const Tally& other) {
    ticks += other.ticks, files += other.files;
    replays.count += other.replays.count, replays.states += other.replays.states;
}

RandomSession random_session(std::uint64_t seed) {
    Dice dice(seed);
    RandomSession session{seed, random_start(dice), kThreads[dice.below(3)], {}};
    const int count = dice.between(6, 14);
    for (int i = 0; i < count; ++i) session.acts.push_back(random_act(dice, session.scenario));
    // Each world comes to rest, goes back, returns and continues.
    session.acts.push_back({Act::kRest, 300, 1, {}});
    session.acts.push_back({Act::kGo, 0, dice.real(0.5, 1), {}});
    session.acts.push_back({Act::kGo, 0, 1, {}});
    session.acts.push_back({Act::kTicks, dice.between(5, 60), 1, {}});
    return session;
}

std::string to_text(const RandomSession& session) {
    const Scenario& scenario = session.scenario;
    std::string text = fmt::format(
        "seed {}: {} x {} vertices, {}, {}, {} material{}, {} threads\n", session.seed, scenario.grid.nx,
        scenario.grid.ny, sim::to_string(scenario.params.model), sim::to_string(scenario.params.scheme),
        scenario.lower ? 2 : 1, scenario.lower ? "s" : "", session.threads);
    for (const Act& act : session.acts) text += "  " + to_text(act) + "\n";
    return text;
}

std::optional<std::string> fault_of(const RandomSession& session, const std::filesystem::path& folder,
                                    Tally& tally) {
    return Lockstep(session, folder, tally).play(session.acts);
}

RandomSession shrunk(RandomSession session, const std::function<bool(const RandomSession&)>& fails) {
    const auto replace_if_fails = [&](std::vector<Act> acts) {
        RandomSession shorter = session;
        shorter.acts = std::move(acts);
        if (!fails(shorter)) return false;
        session = std::move(shorter);
        return true;
    };
    for (bool shorter = true; shorter;) {
        shorter = false;
        for (std::size_t run = session.acts.size(); run > 0; run /= 2)
            for (std::size_t first = 0; first + run <= session.acts.size();) {
                std::vector<Act> acts = session.acts;
                const auto from = acts.begin() + static_cast<std::ptrdiff_t>(first);
                acts.erase(from, from + static_cast<std::ptrdiff_t>(run));
                if (replace_if_fails(std::move(acts)))
                    shorter = true;
                else
                    ++first;
            }
        for (std::size_t i = 0; i < session.acts.size(); ++i)
            while (session.acts[i].ticks > 0) {
                std::vector<Act> acts = session.acts;
                acts[i].ticks /= 2;
                if (!replace_if_fails(std::move(acts))) break;
                shorter = true;
            }
    }
    return session;
}

}  // namespace game::test
