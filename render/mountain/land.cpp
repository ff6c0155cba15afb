#include "render/mountain/land.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "assets/shaders/slots.glsl"
#include "render/base/noise.h"
#include "render/base/ramp.h"

namespace render {
namespace {

constexpr int kMostVertices = 512;  // along a side of the lattice that water runs on
constexpr double kTilt = 1e-4;      // m, by which a filled pit falls to its rim from vertex to vertex
constexpr double kRock = 0.95;      // slope of ground that stones break off
constexpr double kTilled = 0.15;    // slope up to which ground is tilled

// The lattice spans the grid. Its vertices are those of the grid, or of a large grid fewer.
class Lattice {
  public:
    explicit Lattice(const Surroundings& around)
        : nx_(along(around.size().x, around)),
          ny_(along(around.size().y, around)),
          apart_(around.size() / glm::dvec2(nx_ - 1, ny_ - 1)),
          step_(std::sqrt(apart_.x * apart_.y)),
          height_(size()) {
        for (std::size_t i = 0; i < size(); ++i) height_[i] = around.rough_height(place(i));
        flood();
        drain();
    }

    std::size_t size() const { return static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_); }
    std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(x);
    }
    int x_of(std::size_t i) const { return static_cast<int>(i % static_cast<std::size_t>(nx_)); }
    int y_of(std::size_t i) const { return static_cast<int>(i / static_cast<std::size_t>(nx_)); }
    glm::dvec2 place(std::size_t i) const { return apart_ * glm::dvec2(x_of(i), y_of(i)); }
    double step() const { return step_; }  // from vertex to vertex, m
    int columns() const { return nx_; }
    int rows() const { return ny_; }

    double height(std::size_t i) const { return height_[i]; }
    std::size_t receiver(std::size_t i) const { return receiver_[i]; }  // itself at the border
    double area(std::size_t i) const { return area_[i]; }               // that drains through it, m²
    // From low to high: each after its receiver.
    std::span<const std::size_t> order() const { return order_; }
    double slope(std::size_t i) const {
        const int x = x_of(i), y = y_of(i);
        const auto z = [&](int i_x, int i_y) {
            return height_[at(std::clamp(i_x, 0, nx_ - 1), std::clamp(i_y, 0, ny_ - 1))];
        };
        return 0.5 * std::hypot(z(x + 1, y) - z(x - 1, y), z(x, y + 1) - z(x, y - 1)) / step_;
    }
    template <class Visit>
    void for_neighbours(std::size_t i, Visit&& visit) const {
        const int x = x_of(i), y = y_of(i);
        for (int j = std::max(y - 1, 0); j <= std::min(y + 1, ny_ - 1); ++j)
            for (int k = std::max(x - 1, 0); k <= std::min(x + 1, nx_ - 1); ++k)
                if (k != x || j != y) visit(at(k, j));
    }

  private:
    static int along(double length, const Surroundings& around) {
        const double most = std::max(around.side() / (kMostVertices - 1), around.cell());
        return std::max(static_cast<int>(std::lround(length / most)), 1) + 1;
    }
    bool is_border(std::size_t i) const {
        return x_of(i) == 0 || y_of(i) == 0 || x_of(i) == nx_ - 1 || y_of(i) == ny_ - 1;
    }
    // Fills pits, from the border inward.
    void flood() {
        using Reached = std::pair<double, std::size_t>;
        std::priority_queue<Reached, std::vector<Reached>, std::greater<>> reached;
        filled_.assign(size(), std::numeric_limits<double>::infinity());
        order_.reserve(size());
        for (std::size_t i = 0; i < size(); ++i)
            if (is_border(i)) reached.emplace(filled_[i] = height_[i], i);
        while (!reached.empty()) {
            const double level = reached.top().first;
            const std::size_t i = reached.top().second;
            reached.pop();
            order_.push_back(i);
            for_neighbours(i, [&](std::size_t beside) {
                if (filled_[beside] < std::numeric_limits<double>::infinity()) return;
                reached.emplace(filled_[beside] = std::max(height_[beside], level + kTilt), beside);
            });
        }
    }
    void drain() {
        receiver_.resize(size());
        area_.assign(size(), step_ * step_);
        for (std::size_t i = 0; i < size(); ++i) {
            receiver_[i] = i;
            if (is_border(i)) continue;
            double steepest = 0;
            for_neighbours(i, [&](std::size_t beside) {
                const bool diagonal = x_of(beside) != x_of(i) && y_of(beside) != y_of(i);
                const double fall = (filled_[i] - filled_[beside]) / (diagonal ? std::sqrt(2.0) : 1.0);
                if (fall > steepest) steepest = fall, receiver_[i] = beside;
            });
        }
        for (auto i = order_.rbegin(); i != order_.rend(); ++i)
            if (receiver_[*i] != *i) area_[receiver_[*i]] += area_[*i];
    }

    int nx_, ny_;
    glm::dvec2 apart_;  // m
    double step_;
    std::vector<double> height_, filled_, area_;
    std::vector<std::size_t> receiver_, order_;
};

// Means over the neighbours, `times` times.
void blur(const Lattice& lattice, std::vector<double>& values, int times) {
    std::vector<double> means(values.size());
    for (; times > 0; --times) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            double sum = 2 * values[i], count = 2;
            lattice.for_neighbours(i, [&](std::size_t beside) { sum += values[beside], ++count; });
            means[i] = sum / count;
        }
        values.swap(means);
    }
}

std::vector<double> moisture_of(const Lattice& lattice) {
    std::vector<double> moist(lattice.size());
    for (std::size_t i = 0; i < moist.size(); ++i)
        moist[i] = std::log(lattice.area(i) / lattice.step() / std::max(lattice.slope(i), 0.02));
    blur(lattice, moist, 3);
    for (double& each : moist) each = ramp(3.2, 8.5, each);
    return moist;
}

std::vector<double> tilled_of(const Lattice& lattice) {
    double lowest = lattice.height(0), highest = lowest;
    for (std::size_t i = 0; i < lattice.size(); ++i)
        lowest = std::min(lowest, lattice.height(i)), highest = std::max(highest, lattice.height(i));
    std::vector<double> tilled(lattice.size());
    for (std::size_t i = 0; i < tilled.size(); ++i)
        tilled[i] = ramp(kTilled, 0.6 * kTilled, lattice.slope(i)) *
                    ramp(0.35, 0.2, (lattice.height(i) - lowest) / std::max(highest - lowest, 1.0));
    blur(lattice, tilled, 2);
    return tilled;
}

// Stones roll from rock down to where it is less steep.
std::vector<double> rubble_of(const Lattice& lattice) {
    const double kept = std::exp2(-lattice.step() / 45);  // of rubble, from vertex to vertex
    std::vector<double> rubble(lattice.size());
    const auto order = lattice.order();
    for (auto i = order.rbegin(); i != order.rend(); ++i) {
        const double slope = lattice.slope(*i);
        rubble[*i] = std::max(rubble[*i], ramp(kRock - 0.1, kRock + 0.1, slope));
        double& below = rubble[lattice.receiver(*i)];
        below = std::max(below, kept * rubble[*i]);
    }
    blur(lattice, rubble, 1);
    return rubble;
}

// A place on a brook.
struct Bed {
    glm::dvec2 at;
    double half;  // of the water's width, m
};

// Widths of mountain brooks grow with the root of the area that they drain.
double half_width(double area) {
    return 0.5 * std::min(0.55 * std::sqrt(area / 10'000), 14.0);
}

// Brooks from their beginnings down to the border or to another brook.
std::vector<std::vector<Bed>> brooks_of(const Lattice& lattice) {
    const double least = std::max(Land::kBrookArea, 12 * lattice.step() * lattice.step());
    std::vector<std::uint8_t> fed(lattice.size()), done(lattice.size());
    for (std::size_t i = 0; i < lattice.size(); ++i)
        if (lattice.area(i) >= least && lattice.receiver(i) != i) fed[lattice.receiver(i)] = 1;
    std::vector<std::vector<Bed>> brooks;
    for (auto head = lattice.order().rbegin(); head != lattice.order().rend(); ++head) {
        if (lattice.area(*head) < least || fed[*head]) continue;
        std::vector<Bed> bed;
        for (std::size_t i = *head;; i = lattice.receiver(i)) {
            const glm::dvec2 p = lattice.place(i);
            const glm::vec2 bends(p / 37.0 + 1000.0);
            const double level = ramp(0.25, 0.05, lattice.slope(i));
            const glm::dvec2 aside(gradient_noise(bends.x, bends.y, 4096, 61),
                                   gradient_noise(bends.x, bends.y, 4096, 62));
            bed.push_back({p + (4 + 14 * level) * aside, half_width(lattice.area(i))});
            if (done[i] || lattice.receiver(i) == i) break;
            done[i] = 1;
        }
        if (bed.size() > 3) brooks.push_back(std::move(bed));
    }
    return brooks;
}

// Cuts the corners of a line (Chaikin 1974); its ends stay.
std::vector<Bed> rounded(std::vector<Bed> bed, int times) {
    for (; times > 0; --times) {
        std::vector<Bed> finer{bed.front()};
        finer.reserve(2 * bed.size());
        for (std::size_t i = 0; i + 1 < bed.size(); ++i)
            for (const double share : {0.25, 0.75})
                finer.push_back({glm::mix(bed[i].at, bed[i + 1].at, share),
                                 glm::mix(bed[i].half, bed[i + 1].half, share)});
        finer.push_back(bed.back());
        bed = std::move(finer);
    }
    return bed;
}

// The land's texels, and how they lie on the lattice.
class LandTexels {
  public:
    LandTexels(const Lattice& lattice, int most_along)
        : along_(std::clamp((most_along - 1) / (std::max(lattice.columns(), lattice.rows()) - 1), 1, 8)),
          lattice_(lattice),
          spacing_(lattice.place(lattice.size() - 1) /
                   glm::dvec2(along_ * (lattice.columns() - 1), along_ * (lattice.rows() - 1))) {
        land_.columns = along_ * (lattice.columns() - 1) + 1;
        land_.rows = along_ * (lattice.rows() - 1) + 1;
        away_.assign(static_cast<std::size_t>(land_.columns) * static_cast<std::size_t>(land_.rows),
                     static_cast<float>(LAND_FAR));
    }

    void add(const std::vector<Bed>& bed) {
        for (std::size_t i = 0; i + 1 < bed.size(); ++i) add(bed[i], bed[i + 1]);
    }

    // The texels as cultivate() needs them.
    TexelGrid grid() const { return {land_.columns, land_.rows, spacing_}; }
    const std::vector<float>& to_brook() const { return away_; }
    std::vector<float> at_texels(const std::vector<double>& field) const {
        std::vector<float> values;
        values.reserve(away_.size());
        for (int y = 0; y < land_.rows; ++y)
            for (int x = 0; x < land_.columns; ++x)
                values.push_back(static_cast<float>(between(field, x, y)));
        return values;
    }

    Land with(const std::vector<double>& moisture, const Cultivation& cultivation,
              const std::vector<double>& rubble) && {
        land_.texels.reserve(4 * away_.size());
        for (int y = 0; y < land_.rows; ++y)
            for (int x = 0; x < land_.columns; ++x) {
                const std::size_t i = grid().at(x, y);
                put((LAND_FAR - static_cast<double>(away_[i])) / (LAND_FAR + LAND_NEAR));
                put(between(moisture, x, y));
                land_.texels.push_back(cultivation.uses[i]);
                put(between(rubble, x, y));
            }
        return std::move(land_);
    }

  private:
    void put(double share) {
        land_.texels.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0))));
    }
    double between(const std::vector<double>& field, int x, int y) const {
        const int i = std::min(x / along_, lattice_.columns() - 2),
                  j = std::min(y / along_, lattice_.rows() - 2);
        const double u = static_cast<double>(x - i * along_) / along_,
                     v = static_cast<double>(y - j * along_) / along_;
        return glm::mix(glm::mix(field[lattice_.at(i, j)], field[lattice_.at(i + 1, j)], u),
                        glm::mix(field[lattice_.at(i, j + 1)], field[lattice_.at(i + 1, j + 1)], u), v);
    }
    // Distances from a piece of a brook.
    void add(const Bed& from, const Bed& to) {
        const double reach = LAND_FAR + std::max(from.half, to.half);
        const glm::ivec2 first = glm::max(glm::ivec2((glm::min(from.at, to.at) - reach) / spacing_), 0),
                         last = glm::min(glm::ivec2((glm::max(from.at, to.at) + reach) / spacing_),
                                         glm::ivec2(land_.columns, land_.rows) - 1);
        const glm::dvec2 along = to.at - from.at;
        const double length2 = std::max(glm::dot(along, along), 1e-9);
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x) {
                const glm::dvec2 p = spacing_ * glm::dvec2(x, y) - from.at;
                const double t = std::clamp(glm::dot(p, along) / length2, 0.0, 1.0);
                const double away = glm::length(p - t * along) - glm::mix(from.half, to.half, t);
                float& nearest = away_[grid().at(x, y)];
                nearest = std::min(nearest, static_cast<float>(away));
            }
    }

    int along_;  // texels from vertex to vertex
    const Lattice& lattice_;
    glm::dvec2 spacing_;  // m
    Land land_;
    std::vector<float> away_;  // m, from the water of the nearest brook
};

}  // namespace

double Land::to_brook(glm::dvec2 at) const {
    if (empty()) return LAND_FAR;
    const glm::dvec2 last(columns - 1, rows - 1), texel = glm::clamp(at / size * last, glm::dvec2(0), last);
    const glm::ivec2 first = glm::min(glm::ivec2(texel), glm::ivec2(last) - 1);
    const glm::dvec2 within = texel - glm::dvec2(first);
    const auto nearness = [&](int x, int y) {
        return static_cast<double>(
                   texels[4 * (static_cast<std::size_t>(first.y + y) * static_cast<std::size_t>(columns) +
                               static_cast<std::size_t>(first.x + x))]) /
               255;
    };
    return LAND_FAR - (LAND_FAR + LAND_NEAR) * glm::mix(glm::mix(nearness(0, 0), nearness(1, 0), within.x),
                                                        glm::mix(nearness(0, 1), nearness(1, 1), within.x),
                                                        within.y);
}

std::uint8_t Land::use(glm::dvec2 at) const {
    if (empty()) return 0;
    const glm::dvec2 last(columns - 1, rows - 1);
    const glm::ivec2 texel(glm::round(glm::clamp(at / size * last, glm::dvec2(0), last)));
    return texels[4 * (static_cast<std::size_t>(texel.y) * static_cast<std::size_t>(columns) +
                       static_cast<std::size_t>(texel.x)) +
                  2];
}

Land land_of(const Surroundings& around, const Settlement& settlement, int most_along) {
    if (around.empty()) return {};
    const Lattice lattice(around);
    LandTexels texels(lattice, most_along);
    for (const std::vector<Bed>& bed : brooks_of(lattice)) texels.add(rounded(bed, 3));
    Cultivation cultivation =
        cultivate(around, settlement, texels.grid(), texels.at_texels(tilled_of(lattice)), texels.to_brook());
    Land land = std::move(texels).with(moisture_of(lattice), cultivation, rubble_of(lattice));
    land.planted = std::move(cultivation.planted);
    land.size = around.size();
    land.fingerprint = around.fingerprint() + static_cast<std::uint64_t>(land.columns);
    for (std::size_t i = 2; i < land.texels.size(); i += 4)
        land.fingerprint = (land.fingerprint ^ land.texels[i]) * 0x100000001b3u;
    return land;
}

}  // namespace render
