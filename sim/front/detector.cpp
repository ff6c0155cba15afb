#include "sim/front/detector.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "sim/core/check.h"

// The scan (scan.h) looks at all vertices and edges for the least jump that the rule may accept. The rule
// itself then checks the few that the scan finds. Squares of jumps are compared, because a root for each edge
// would cost more than all the rest.

namespace sim::front {
namespace {

using scan::kWord;
using scan::Word;

float square(float x) {
    return x * x;
}
float square(const glm::vec2& v) {
    return v.x * v.x + v.y * v.y;
}

// Calls look(number) for each bit of a word, ascending.
template <class Look>
void each_bit(Word word, const Look& look) {
    for (; word; word &= word - 1) look(std::countr_zero(word));
}

std::size_t words_for(int count) {
    return static_cast<std::size_t>((count + kWord - 1) / kWord);
}

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

Detector::Detector(const Mesh& mesh, const Rule& rule, InstructionSet set)
    : mesh_(mesh),
      rule_(rule),
      kernels_(scan::kernels_for(set)),
      columns_(mesh.columns > 0 ? mesh.columns : mesh.vertices()),
      rows_(columns_ > 0 ? mesh.vertices() / columns_ : 0),
      velocity_(mesh.position.size()),
      slot_(mesh.edge.size(), -1) {
    lay_families();
    const std::size_t words = static_cast<std::size_t>(rows_) * words_for(columns_);
    for (auto* bits : {&above_, &above_before_, &jumps_, &changes_, &others_}) bits->resize(words);
    // Reserve more than any flow needs, so that growing fronts allocate nothing.
    const std::size_t cut = mesh.edge.size() / 8;
    for (std::vector<int>* list : {&cut_, &before_, &flipped_}) list->reserve(cut);
    vanished_.reserve(cut);
}

void Detector::lay_families() {
    int edge = 0;
    std::size_t word = 0;
    const auto add = [&](int columns, int rows, int step) {
        const int end = edge + columns * rows;
        if (end == edge) return;
        const auto length = mesh_.length.begin();
        const float shortest =
            mesh_.columns > 0 ? length[edge] : *std::min_element(length + edge, length + end);
        families_.push_back({edge, columns, rows, step, word, words_for(columns), least_jump(shortest)});
        word += families_.back().words * static_cast<std::size_t>(rows);
        edge = end;
    };
    if (const int nx = columns_; mesh_.columns > 0)
        add(nx - 1, rows_, 1), add(nx, rows_ - 1, nx), add(nx - 1, rows_ - 1, nx + 1);
    else
        add(mesh_.edges(), 1, 0);
    on_.resize(word), was_on_.resize(word);
    constexpr float kAny = std::numeric_limits<float>::max();
    least_jump_ = least_change_ = kAny;
    for (const Family& family : families_)
        least_jump_ = std::min(least_jump_, family.least * std::min(rule_.hold, 1.f));
    for (const float cell : mesh_.cell) least_change_ = std::min(least_change_, least_jump(cell / 2));
}

float Detector::least_jump(float length) const {
    // No jump, no cut, whatever the rule. The square of this speed is still a normal float.
    constexpr float kSomething = 1e-18f;  // m/s
    const float jump = std::max(rule_.jump, kSomething);
    return rule_.kind == Rule::Kind::kRelative ? jump : std::max(rule_.threshold * length, jump);
}

void Detector::update(const Flow& flow) {
    CHECK(flow.velocity.size() == mesh_.position.size());
    CHECK(rule_.kind != Rule::Kind::kLevel || flow.scalar.size() == mesh_.position.size());
    on_.swap(was_on_);
    std::fill(on_.begin(), on_.end(), 0);
    flipped_.clear();
    if (rule_.kind == Rule::Kind::kLevel) {
        find_above(flow.scalar.data());
        find_crossings();
    } else {
        scan(flow.velocity.data());
        find_jumps(flow.velocity.data());
        find_flips(flow.velocity.data());
    }
    list_changes();
    first_ = false;
}

// Marks changed and flipped candidates, then candidate jumps. Rows without any change are skipped.
void Detector::scan(const glm::vec2* velocity) {
    static_assert(sizeof(glm::vec2) == 2 * sizeof(float));
    const std::size_t words = words_for(columns_);
    for (int y = 0; y < rows_; ++y) {
        const std::size_t first = static_cast<std::size_t>(y) * words;
        kernels_.find_changes(&velocity[y * columns_].x, &velocity_[y * columns_].x, columns_, least_change_,
                              &others_[first], &changes_[first]);
        if (mesh_.columns == 0) continue;
        if (y > 0) scan_row(velocity, y - 1);
        if (y + 1 == rows_) scan_row(velocity, y);
    }
}

void Detector::scan_row(const glm::vec2* velocity, int y) {
    const glm::vec2* row = velocity + y * columns_;
    const glm::vec2* above = y + 1 < rows_ ? row + columns_ : row;
    const std::size_t words = words_for(columns_), first = static_cast<std::size_t>(y) * words;
    const Word *others = &others_[first], *others_above = y + 1 < rows_ ? others + words : others;
    const auto changed_at = [&](std::size_t w) { return w < words ? others[w] | others_above[w] : 0; };
    for (std::size_t w = 0; w < words; ++w) {
        const Word at = changed_at(w), changed = at | at >> 1 | changed_at(w + 1) << (kWord - 1);
        if (!changed) continue;
        const int x = static_cast<int>(w) * kWord, count = std::min(columns_ - x, kWord);
        kernels_.find_jumps(&row[x].x, &above[x].x, count, std::min(columns_ - 1 - x, kWord), least_jump_,
                            &changed, &jumps_[first + w]);
    }
}

void Detector::find_jumps(const glm::vec2* velocity) {
    if (mesh_.columns == 0) return find_jumps_one_by_one(velocity);
    each_vertex(jumps_, [&](int x, int y) {
        const int a = y * columns_ + x;
        for (const Family& family : families_)
            if (x < family.columns && y < family.rows) {
                const std::size_t at = family.word_at(x, y);
                const bool was_cut = was_on_[at] >> x % kWord & 1;
                const bool is_cut =
                    jumps_enough(velocity[a], velocity[a + family.step], family.least, was_cut);
                on_[at] |= Word{is_cut} << x % kWord;
            }
    });
}

void Detector::find_jumps_one_by_one(const glm::vec2* velocity) {
    const float least2 = square(least_jump_);
    for (int e = 0; e < mesh_.edges(); ++e) {
        const auto [a, b] = mesh_.edge[e];
        if (square(velocity[b] - velocity[a]) < least2) continue;
        const auto at = static_cast<std::size_t>(e / kWord);
        const bool was_cut = was_on_[at] >> e % kWord & 1;
        const bool is_cut = jumps_enough(velocity[a], velocity[b], least_jump(mesh_.length[e]), was_cut);
        on_[at] |= Word{is_cut} << e % kWord;
    }
}

bool Detector::jumps_enough(const glm::vec2& a, const glm::vec2& b, float least, bool was_cut) const {
    float limit = least;
    if (rule_.kind == Rule::Kind::kRelative)
        limit = std::max(limit, rule_.ratio * (std::sqrt(square(a)) + std::sqrt(square(b))));
    return square(b - a) >= limit * limit * (was_cut ? square(rule_.hold) : 1);
}

void Detector::find_flips(const glm::vec2* velocity) {
    if (!first_)
        each_vertex(changes_, [&](int x, int y) {
            const int v = y * columns_ + x;
            if (jumps_enough(velocity_[v], velocity[v], least_jump(mesh_.cell[v] / 2), false))
                flipped_.push_back(v);
        });
    // The scan updated the previous velocities, except where something may have jumped.
    each_word(changes_, [&](Word word, int x, int y) {
        const int first = y * columns_ + x;
        if (word || first_) std::copy_n(velocity + first, std::min(columns_ - x, kWord), &velocity_[first]);
    });
}

// Calls look(word, x, y) for each word of each row of vertices; (x, y) is the word's first vertex.
template <class Look>
void Detector::each_word(const std::vector<Word>& words, const Look& look) const {
    const Word* word = words.data();
    for (int y = 0; y < rows_; ++y)
        for (int x = 0; x < columns_; x += kWord) look(*word++, x, y);
}

// Calls look(x, y) for each vertex whose bit is set.
template <class Look>
void Detector::each_vertex(const std::vector<Word>& words, const Look& look) const {
    each_word(words,
              [&](Word word, int first, int y) { each_bit(word, [&](int i) { look(first + i, y); }); });
}

void Detector::find_above(const float* scalar) {
    above_.swap(above_before_);
    for (int y = 0; y < rows_; ++y)
        kernels_.find_above(scalar + y * columns_, columns_, rule_.level, &above_[y * words_for(columns_)]);
    if (first_) return;
    for (std::size_t w = 0; w < above_.size(); ++w) changes_[w] = above_[w] ^ above_before_[w];
    each_vertex(changes_, [&](int x, int y) { flipped_.push_back(y * columns_ + x); });
}

void Detector::find_crossings() {
    if (mesh_.columns == 0) return find_crossings_one_by_one();
    const std::size_t words = words_for(columns_);
    for (const Family& family : families_) {
        // Offset from the first word of a row to that of the row where its edges end, and whether they end
        // one column further.
        const std::size_t up = family.step >= columns_ ? words : 0;
        const bool to_next = family.step % columns_ == 1;
        for (int y = 0; y < family.rows; ++y) {
            const Word* row = &above_[static_cast<std::size_t>(y) * words];
            for (int x = 0; x < family.columns; x += kWord) {
                const std::size_t w = static_cast<std::size_t>(x) / kWord;
                Word other = row[up + w];
                if (to_next) other = other >> 1 | (w + 1 < words ? row[up + w + 1] << (kWord - 1) : 0);
                const int left = family.columns - x;
                const Word there_are = left < kWord ? (Word{1} << left) - 1 : ~Word{0};
                on_[family.word_at(x, y)] = (row[w] ^ other) & there_are;
            }
        }
    }
}

void Detector::find_crossings_one_by_one() {
    const auto is_above = [&](int v) { return above_[static_cast<std::size_t>(v / kWord)] >> v % kWord & 1; };
    for (int e = 0; e < mesh_.edges(); ++e)
        on_[static_cast<std::size_t>(e / kWord)] |= (is_above(mesh_.edge[e].a) ^ is_above(mesh_.edge[e].b))
                                                    << e % kWord;
}

void Detector::list_changes() {
    cut_.clear(), before_.clear(), vanished_.clear();
    const Word *on = on_.data(), *was_on = was_on_.data();
    for (const Family& family : families_)
        for (int y = 0; y < family.rows; ++y)
            for (int x = 0; x < family.columns; x += kWord, ++on, ++was_on) {
                if (!(*on | *was_on)) continue;
                const int first = family.first_edge + y * family.columns + x;
                each_bit(*was_on & ~*on, [&](int i) {
                    vanished_.push_back({first + i, std::exchange(slot_[first + i], -1)});
                });
                each_bit(*on, [&](int i) {
                    before_.push_back(std::exchange(slot_[first + i], static_cast<int>(cut_.size())));
                    cut_.push_back(first + i);
                });
            }
}

}  // namespace sim::front
