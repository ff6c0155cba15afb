#include "sim/front/detector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
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

// Whether velocity jumps enough from a to b. Squares are compared, because a root for each edge would cost
// more than all the rest; speeds, which the relative rule wants, have one for each vertex.
struct Jump {
    float least;         // m/s
    float ratio;         // of both speeds
    float shares[2];     // squared, of what is not cut yet and of what is
    const float* speed;  // of each vertex, m/s; only of the relative rule

    template <bool relative>
    bool test(const glm::vec2* velocity, int a, int b, std::uint8_t is_cut) const {
        const float jump = square(velocity[b] - velocity[a]);
        float limit = least;
        if constexpr (relative) limit = std::max(limit, ratio * (speed[a] + speed[b]));
        return jump >= limit * limit * (is_cut ? shares[1] : shares[0]);
    }

    // Edges that lie side by side in a heightfield: from a, a + 1, … to b, b + 1, …; whether one of them is
    // cut.
    template <bool relative>
    bool test_row(const glm::vec2* velocity, int a, int b, int count, const std::uint8_t* __restrict was,
                  std::uint8_t* __restrict on) const {
        std::uint8_t any = 0;
        for (int i = 0; i < count; ++i) any |= on[i] = test<relative>(velocity, a + i, b + i, was[i]);
        return any;
    }
};

}  // namespace

Rule gradient_rule(float jump, float cell) {
    return {.threshold = jump / (1.5f * cell), .jump = jump};
}

Rule avalanche_rule() {
    return {.kind = Rule::Kind::kRelative, .jump = 0.3f, .ratio = 0.7f, .hold = 0.55f / 0.7f};
}

Rule uncut_rule() {
    return {.jump = std::numeric_limits<float>::max()};
}

Detector::Detector(const Mesh& mesh, const Rule& rule)
    : mesh_(mesh),
      rule_(rule),
      on_(mesh.edge.size()),
      was_on_(mesh.edge.size()),
      velocity_(mesh.position.size()),
      above_(mesh.position.size()),
      above_before_(mesh.position.size()),
      speed_(rule.kind == Rule::Kind::kRelative ? mesh.position.size() : 0),
      slot_(mesh.edge.size(), -1) {
    // Room for more than any flow has, so that fronts that grow allocate nothing.
    const std::size_t cut = mesh.edge.size() / 8;
    for (std::vector<int>* list : {&cut_, &previous_, &before_, &flipped_}) list->reserve(cut);
    vanished_.reserve(cut);
    with_cut_.reserve(mesh.position.size());
}

void Detector::update(const Flow& flow) {
    CHECK(flow.velocity.size() == mesh_.position.size());
    CHECK(rule_.kind != Rule::Kind::kLevel || flow.scalar.size() == mesh_.position.size());
    on_.swap(was_on_);
    find_flips(flow);  // compares with the step before, and keeps this one
    find_jumps(flow);
    list_changes();
    first_ = false;
}

float Detector::least_jump(float length) const {
    // Where nothing jumps nothing is cut, whatever the rule; of a speed so low the square is still a number.
    constexpr float kSomething = 1e-18f;  // m/s
    const float jump = std::max(rule_.jump, kSomething);
    return rule_.kind == Rule::Kind::kRelative ? jump : std::max(rule_.threshold * length, jump);
}

void Detector::find_jumps(const Flow& flow) {
    with_cut_.clear();
    switch (rule_.kind) {
        case Rule::Kind::kGradient:
            return find_jumps<false>(flow.velocity.data());
        case Rule::Kind::kRelative:
            for (std::size_t v = 0; v < speed_.size(); ++v) speed_[v] = std::sqrt(square(flow.velocity[v]));
            return find_jumps<true>(flow.velocity.data());
        case Rule::Kind::kLevel:
            return find_crossings();
    }
}

// Calls test(length, e, a, b, count) for each row of a heightfield's edges, those of one family side by side,
// of one length: from e on, from vertices a on to vertices b on. It tells whether one of them is cut.
template <class Test>
void Detector::test_rows(const Test& test) {
    const int nx = mesh_.columns, ny = mesh_.vertices() / nx;
    std::size_t e = 0;
    for (const auto& [columns, rows, step] :
         {std::array{nx - 1, ny, 1}, std::array{nx, ny - 1, nx}, std::array{nx - 1, ny - 1, nx + 1}}) {
        const float length = mesh_.length[e];
        for (int y = 0; y < rows; ++y, e += static_cast<std::size_t>(columns))
            if (test(length, e, y * nx, y * nx + step, columns))
                with_cut_.push_back({e, e + static_cast<std::size_t>(columns)});
    }
}

template <bool relative>
void Detector::find_jumps(const glm::vec2* velocity) {
    const Jump any{rule_.jump, rule_.ratio, {1, square(rule_.hold)}, speed_.data()};
    if (mesh_.columns > 0)
        return test_rows([&](float length, std::size_t e, int a, int b, int count) {
            Jump jump = any;  // a copy that nothing else can change: bytes written may be anybody's
            jump.least = least_jump(length);
            return jump.test_row<relative>(velocity, a, b, count, &was_on_[e], &on_[e]);
        });
    Jump jump = any;
    for (std::size_t e = 0; e < on_.size(); ++e) {
        const auto [a, b] = mesh_.edge[e];
        jump.least = least_jump(mesh_.length[e]);
        on_[e] = jump.test<relative>(velocity, a, b, was_on_[e]);
    }
    with_cut_.push_back({0, on_.size()});
}

void Detector::find_crossings() {
    const std::uint8_t* above = above_.data();
    if (mesh_.columns > 0)
        return test_rows([&](float, std::size_t first, int a, int b, int count) {
            std::uint8_t any = 0;
            std::uint8_t* __restrict on = &on_[first];
            for (int i = 0; i < count; ++i) any |= on[i] = above[a + i] ^ above[b + i];
            return any != 0;
        });
    for (std::size_t e = 0; e < on_.size(); ++e) on_[e] = above[mesh_.edge[e].a] ^ above[mesh_.edge[e].b];
    with_cut_.push_back({0, on_.size()});
}

void Detector::find_flips(const Flow& flow) {
    flipped_.clear();
    if (rule_.kind == Rule::Kind::kLevel) {
        find_rises(flow.scalar.data());
    } else {
        find_jumps_in_time(flow.velocity.data());
        std::copy(flow.velocity.begin(), flow.velocity.end(), velocity_.begin());
    }
}

// Few vertices flip: many are looked at together, and one by one only where one of them may have.
template <class Look>
void Detector::look_at_groups(const Look& look) const {
    constexpr int kTogether = 64;
    for (int first = 0; first < mesh_.vertices(); first += kTogether)
        look(first, std::min(first + kTogether, mesh_.vertices()));
}

void Detector::find_rises(const float* scalar) {
    above_.swap(above_before_);
    for (std::size_t v = 0; v < above_.size(); ++v) above_[v] = scalar[v] > rule_.level;
    if (first_) return;
    look_at_groups([&](int first, int last) {
        if (std::memcmp(&above_[first], &above_before_[first], static_cast<std::size_t>(last - first)) == 0)
            return;
        for (int v = first; v < last; ++v)
            if (above_[v] != above_before_[v]) flipped_.push_back(v);
    });
}

void Detector::find_jumps_in_time(const glm::vec2* velocity) {
    if (first_) return;
    const bool relative = rule_.kind == Rule::Kind::kRelative;
    const float jump2 = square(rule_.jump);
    look_at_groups([&](int first, int last) {
        std::uint32_t any = 0;
        for (int v = first; v < last; ++v) any |= square(velocity[v] - velocity_[v]) >= jump2;
        if (!any) return;
        for (int v = first; v < last; ++v) {
            float limit = least_jump(mesh_.cell[v] / 2);
            if (relative)
                limit = std::max(limit, rule_.ratio * (glm::length(velocity[v]) + glm::length(velocity_[v])));
            const float jump = square(velocity[v] - velocity_[v]);
            if (jump >= limit * limit) flipped_.push_back(v);
        }
    });
}

// Both lists of edges ascend, so that one pass over each tells what was born and what vanished.
void Detector::list_changes() {
    previous_.swap(cut_);
    cut_.clear(), before_.clear(), vanished_.clear();
    constexpr std::size_t kWord = 8;  // edges that are looked at together, for few are cut
    for (const auto& [first, last] : with_cut_)
        for (std::size_t e = first; e < last;) {
            std::uint64_t word = 1;
            if (e + kWord <= last) std::memcpy(&word, &on_[e], kWord);
            const std::size_t end = std::min(e + kWord, last);
            if (!word) e = end;
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
