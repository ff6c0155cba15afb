#include "sim/front/detector.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include <glm/geometric.hpp>

#include "sim/check.h"

namespace sim::front {
namespace {

float square(float x) {
    return x * x;
}
float square(const glm::vec2& v) {
    return v.x * v.x + v.y * v.y;
}

// Squares are compared, because a root for each edge would cost more than all the rest.
struct Gradient {
    const Rule& rule;
    // `held`: the edge is cut already. Times share².
    bool operator()(const glm::vec2& a, const glm::vec2& b, float length, float share) const {
        return square(b - a) >= square(std::max(rule.threshold * length, rule.jump)) * share;
    }
};

struct Relative {
    const Rule& rule;
    bool operator()(const glm::vec2& a, const glm::vec2& b, float, float share) const {
        const float jump = square(b - a);
        if (jump < square(rule.jump) * share) return false;
        return jump >= square(rule.ratio * (glm::length(a) + glm::length(b))) * share;
    }
};

}  // namespace

Rule gradient_rule(float jump, float cell) {
    return {.threshold = jump / (1.5f * cell), .jump = jump};
}

Rule avalanche_rule() {
    return {.kind = Rule::Kind::kRelative, .jump = 0.3f, .ratio = 0.7f, .hold = 0.55f / 0.7f};
}

Detector::Detector(const Mesh& mesh, const Rule& rule)
    : mesh_(mesh),
      rule_(rule),
      on_(mesh.edge.size()),
      was_on_(mesh.edge.size()),
      velocity_(mesh.position.size()),
      above_(mesh.position.size()),
      slot_(mesh.edge.size(), -1) {}

void Detector::update(const Flow& flow) {
    CHECK(flow.velocity.size() == mesh_.position.size());
    CHECK(rule_.kind != Rule::Kind::kLevel || flow.scalar.size() == mesh_.position.size());
    on_.swap(was_on_);
    find_flips(flow);  // compares with the step before, and keeps this one
    find_jumps(flow);
    list_changes();
    first_ = false;
}

void Detector::find_jumps(const Flow& flow) {
    const auto by = [&](const auto& test) {
        const float shares[] = {1, square(rule_.hold)};
        for (std::size_t e = 0; e < on_.size(); ++e) {
            const auto [a, b] = mesh_.edge[e];
            on_[e] = test(flow.velocity[a], flow.velocity[b], mesh_.length[e], shares[was_on_[e]]);
        }
    };
    if (rule_.kind == Rule::Kind::kGradient) return by(Gradient{rule_});
    if (rule_.kind == Rule::Kind::kRelative) return by(Relative{rule_});
    for (std::size_t e = 0; e < on_.size(); ++e) on_[e] = above_[mesh_.edge[e].a] ^ above_[mesh_.edge[e].b];
}

void Detector::find_flips(const Flow& flow) {
    flipped_.clear();
    const auto where = [&](const auto& flips) {
        for (int v = 0; v < mesh_.vertices(); ++v)
            if (flips(v) && !first_) flipped_.push_back(v);
    };
    if (rule_.kind == Rule::Kind::kLevel) {
        where([&](int v) {
            const std::uint8_t above = flow.scalar[v] > rule_.level;
            return std::exchange(above_[v], above) != above;
        });
    } else if (rule_.kind == Rule::Kind::kGradient) {
        where([&](int v) { return Gradient{rule_}(velocity_[v], flow.velocity[v], mesh_.cell[v] / 2, 1); });
    } else {
        where([&](int v) { return Relative{rule_}(velocity_[v], flow.velocity[v], 0, 1); });
    }
    std::copy(flow.velocity.begin(), flow.velocity.end(), velocity_.begin());
}

// Both lists of edges ascend, so that one pass over each tells what was born and what vanished.
void Detector::list_changes() {
    previous_.swap(cut_);
    cut_.clear(), before_.clear(), vanished_.clear();
    constexpr std::size_t kWord = 8;
    for (std::size_t e = 0; e < on_.size();) {
        std::uint64_t word = 1;
        if (e + kWord <= on_.size()) std::memcpy(&word, &on_[e], kWord);
        if (!word) {
            e += kWord;
            continue;
        }
        const std::size_t end = std::min(e + kWord, on_.size());
        for (; e < end; ++e)
            if (on_[e]) cut_.push_back(static_cast<int>(e));
    }
    for (std::size_t i = 0; i < previous_.size(); ++i) {
        const int e = previous_[i];
        if (!on_[e]) vanished_.push_back({e, std::exchange(slot_[e], -1)});
    }
    for (std::size_t i = 0; i < cut_.size(); ++i) {
        before_.push_back(slot_[cut_[i]]);
        slot_[cut_[i]] = static_cast<int>(i);
    }
}

}  // namespace sim::front
