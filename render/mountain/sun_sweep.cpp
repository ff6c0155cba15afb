#include "render/mountain/sun_sweep.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "render/base/same_inside.h"
#include "sim/core/check.h"

namespace render {
namespace {

// The part of the way from the sun to the block that is swept.
constexpr double kSweepReach = 1.8;  // longer sides
constexpr int kSweepSteps = 48;
constexpr int kRowsAtOnce = 16;  // whose heights are summed together: a cache line, if rows are columns

// The rough heights of the surroundings in the axes of a sweep, interpolated and clamped as a texture is.
class Beyond {
  public:
    Beyond(std::span<const float> heights, const glm::vec3& place, float cell, bool turned)
        : heights_(heights.data()), scale_(cell / place.z), turned_(turned) {
        CHECK(heights.size() == static_cast<std::size_t>(kSide) * kSide);
        origin_ = glm::vec2(place) / place.z;
    }

    float at(double column, double row) const {
        const auto x = static_cast<float>(turned_ ? row : column),
                   y = static_cast<float>(turned_ ? column : row);
        const float u = std::clamp(x * scale_ - origin_.x, 0.f, kSide - 1.f);
        const float v = std::clamp(y * scale_ - origin_.y, 0.f, kSide - 1.f);
        const int i = std::min(static_cast<int>(u), kSide - 2), j = std::min(static_cast<int>(v), kSide - 2);
        const float* south = heights_ + j * kSide + i;
        const float* north = south + kSide;
        const float across = u - static_cast<float>(i), up = v - static_cast<float>(j);
        const float low = south[0] + across * (south[1] - south[0]);
        const float high = north[0] + across * (north[1] - north[0]);
        return low + up * (high - low);
    }

  private:
    static constexpr int kSide = Surroundings::kRough;

    const float* heights_;
    glm::vec2 origin_{0};
    float scale_;
    bool turned_;
};

// Raises ceilings to heights.
void raise(float* ceiling, const float* height, int count) {
    for (int k = 0; k < count; ++k) ceiling[k] = std::max(ceiling[k], height[k]);
}

// Raises ceilings to heights between vertices, at a part of the way from each to the next.
void raise_between(float* ceiling, const float* height, float part, int count) {
    for (int k = 0; k < count; ++k)
        ceiling[k] = std::max(ceiling[k], height[k] + part * (height[k + 1] - height[k]));
}

void lower(std::span<float> ceiling, float fall, float base) {
    for (float& z : ceiling) z = std::max(z - fall, base);
}

}  // namespace

void SunSweep::run(const sim::View& world, const Surroundings* around, const FrameBlock& frame) {
    const Course course = course_of(world, around, frame);
    const bool is_new = !is_known(course, world);
    if (is_new) {
        if (course_.grid != course.grid) {
            const auto most = static_cast<std::size_t>(most_rays(course.grid)) *
                              static_cast<std::size_t>(most_rows(course.grid));
            for (std::vector<float>* values : {&now_, &before_, &outside_}) values->reserve(most);
        }
        course_ = course;
        site_ = world.site;
        survey(around);
        survey_drains(around);
    }
    now_.swap(before_);
    now_.resize(static_cast<std::size_t>(course.rays) * static_cast<std::size_t>(course.rows));
    sweep(world);
    find_changes(is_new);
}

SunSweep::Course SunSweep::course_of(const sim::View& world, const Surroundings* around,
                                     const FrameBlock& frame) {
    Course course;
    course.grid = world.grid;
    if (around && !around->empty()) {
        course.beyond = glm::vec3(frame.beyond);
        course.surroundings = around->fingerprint();
    }
    course.shear = static_cast<double>(frame.sweep.x);
    course.first_ray = static_cast<double>(frame.sweep.y);
    course.fall = frame.sweep.z;
    course.base = frame.ground.y;
    course.turned = frame.sweep.w > 0.5f;
    course.backwards = frame.haze.z > 0.5f;
    course.rays = frame.size.z;
    course.rows = frame.size.w;
    course.columns = course.turned ? world.grid.ny : world.grid.nx;
    return course;
}

bool SunSweep::is_known(const Course& course, const sim::View& world) const {
    return course_ == course && same_inside(site_, world.site);
}

SunSweep::Crossing SunSweep::crossing(int parity, int step) const {
    const double from = column(parity, step), whole = std::floor(from);
    const int left = static_cast<int>(whole), end = course_.columns - 1 - left;
    const int first = std::clamp(-left, 0, number(parity));
    // The last vertex belongs to the grid, what is beyond it does not.
    const int last = std::clamp(from > whole ? end : end + 1, first, number(parity));
    return {first, last, left, static_cast<float>(from - whole)};
}

void SunSweep::survey(const Surroundings* around) {
    const auto [grid, place, surroundings, shear, first_ray, fall, base, turned, backwards, rays, rows,
                columns] = course_;
    outside_.clear();
    for (const int parity : {0, 1}) {
        start_[parity].assign(number(parity), base);
        ceiling_[parity].resize(number(parity));
    }
    if (surroundings == 0) return;
    const Beyond beyond(around->rough_heights(), place, grid.dx, turned);
    const double stride = kSweepReach * std::max(rows, columns) / kSweepSteps;  // rows
    for (int n = kSweepSteps; n > 0; --n)
        for (const int parity : {0, 1}) {
            const double step = -n * stride, at = column(parity, step);
            const double row = backwards ? rows - 1 - step : step;
            for (int k = 0; k < number(parity); ++k)
                start_[parity][k] = std::max(start_[parity][k], beyond.at(at + k, row));
            lower(start_[parity], fall * static_cast<float>(stride), base);
        }
    for (int step = 0; step < rows; ++step)
        for (const int parity : {0, 1}) {
            const auto [first, last, left, part] = crossing(parity, step);
            const double at = column(parity, step);
            for (int k = 0; k < first; ++k) outside_.push_back(beyond.at(at + k, row(step)));
            for (int k = last; k < number(parity); ++k) outside_.push_back(beyond.at(at + k, row(step)));
        }
}

void SunSweep::survey_drains(const Surroundings* around) {
    drains_.clear();
    for (int step = 0; step < course_.rows; ++step)
        for (int c = 0; c < course_.columns; ++c) {
            const int x = course_.turned ? row(step) : c, y = course_.turned ? c : row(step);
            if (site_.row(y)[x] == sim::Site::kDrain) drains_.push_back({step, c, course_.base});
        }
    if (course_.surroundings == 0) return;
    const Beyond beyond(around->rough_heights(), course_.beyond, course_.grid.dx, course_.turned);
    for (Drain& drain : drains_) drain.height = beyond.at(drain.column, row(drain.step));
}

void SunSweep::sweep(const sim::View& world) {
    for (const int parity : {0, 1})
        std::copy(start_[parity].begin(), start_[parity].end(), ceiling_[parity].begin());
    const float* outside = outside_.data();
    for (int step = 0; step < course_.rows; ++step) {
        store(step);
        if (step % kRowsAtOnce == 0) find_heights(world, step);
        const float* heights = heights_.data() + (step % kRowsAtOnce) * (course_.columns + 1);
        for (const int parity : {0, 1}) {
            float* ceiling = ceiling_[parity].data();
            const auto [first, last, left, part] = crossing(parity, step);
            raise_between(ceiling + first, heights + left + first, part, last - first);
            if (course_.surroundings != 0) {
                const int after = number(parity) - last;
                raise(ceiling, outside, first);
                raise(ceiling + last, outside + first, after);
                outside += first + after;
            }
            lower(ceiling_[parity], course_.fall, course_.base);
        }
    }
}

// Computes the heights of some rows from this step on, each with one more column, equal to the last.
void SunSweep::find_heights(const sim::View& world, int step) {
    const int columns = course_.columns, wide = columns + 1, end = std::min(step + kRowsAtOnce, course_.rows);
    heights_.resize(static_cast<std::size_t>(kRowsAtOnce) * static_cast<std::size_t>(wide));
    if (course_.turned) {
        const int low = std::min(row(step), row(end - 1)), count = end - step;
        const int way = course_.backwards ? -wide : wide;
        float* const first = heights_.data() + (row(step) == low ? 0 : (count - 1) * wide);
        for (int y = 0; y < columns; ++y) {
            const float *b = world.bedrock.row(y) + low, *d = world.depth.row(y) + low,
                        *r = world.rolling.row(y) + low;
            float* to = first + y;
            for (int i = 0; i < count; ++i, to += way) *to = b[i] + d[i] + r[i];
        }
    } else {
        for (int s = step; s < end; ++s) {
            const float *b = world.bedrock.row(row(s)), *d = world.depth.row(row(s)),
                        *r = world.rolling.row(row(s));
            float* to = heights_.data() + (s - step) * wide;
            for (int x = 0; x < columns; ++x) to[x] = b[x] + d[x] + r[x];
        }
    }
    for (auto drain = std::lower_bound(drains_.begin(), drains_.end(), step,
                                       [](const Drain&d, int s) { return d.step < s; });
         drain != drains_.end() && drain->step < end; ++drain)
        heights_[(drain->step - step) * wide + drain->column] = drain->height;
    for (int s = 0; s < end - step; ++s) heights_[s * wide + columns] = heights_[s * wide + columns - 1];
}

// Stores the ceilings of a step, rays of even and odd number in turn.
void SunSweep::store(int step) {
    const float *even = ceiling_[0].data(), *odd = ceiling_[1].data();
    float* to = now_.data() + static_cast<std::size_t>(step) * static_cast<std::size_t>(course_.rays);
    const int pairs = number(1);
    for (int k = 0; k < pairs; ++k) to[2 * k] = even[k], to[2 * k + 1] = odd[k];
    if (number(0) > pairs) to[2 * pairs] = even[pairs];
}

void SunSweep::find_changes(bool all) {
    first_changed_ = 0, last_changed_ = course_.rows - 1;
    if (all) return;
    const auto same = [this](int step) {
        const auto width = static_cast<std::size_t>(course_.rays),
                   at = static_cast<std::size_t>(step) * width;
        return std::memcmp(&now_[at], &before_[at], width * sizeof(float)) == 0;
    };
    while (first_changed_ <= last_changed_ && same(first_changed_)) ++first_changed_;
    while (last_changed_ > first_changed_ && same(last_changed_)) --last_changed_;
}

}  // namespace render
