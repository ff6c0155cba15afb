#include "game/recording/chain.h"

#include <iterator>

#include <fmt/format.h>
#define XXH_STATIC_LINKING_ONLY  // for a digest on the stack
#include <xxhash.h>

namespace game {
namespace {

constexpr std::string_view kKey = ",\"chain\":\"";
constexpr std::size_t kLength = kKey.size() + 16 + 2;  // key, digits, quote and brace

}  // namespace

std::uint64_t Chain::link(std::string_view body) const {
    return XXH3_64bits_withSeed(body.data(), body.size(), last_);
}

void Chain::close(std::string& line) {
    line.pop_back();
    last_ = link(line);
    fmt::format_to(std::back_inserter(line), "{}{:016x}\"}}", kKey, last_);
}

tl::expected<void, std::string> Chain::read(std::string_view line) {
    const auto damaged = [] {
        return tl::unexpected(std::string("damaged: its chained hash does not match its content"));
    };
    if (line.size() <= kLength || line.substr(line.size() - kLength, kKey.size()) != kKey) return damaged();
    const std::uint64_t expected = link(line.substr(0, line.size() - kLength));
    if (line.substr(line.size() - kLength + kKey.size()) != fmt::format("{:016x}\"}}", expected))
        return damaged();
    last_ = expected;
    return {};
}

}  // namespace game
