#include "sim/front/tracker.h"

#include <algorithm>
#include <array>

#include "sim/core/check.h"
#include "sim/front/hold.h"
#include "sim/front/point_estimator.h"

namespace sim::front {
namespace {

constexpr std::array<std::string_view, 4> kSources{"half", "paper", "fit", "level"};

std::unique_ptr<PointEstimator> locator_of(const Mesh& mesh, const Rule& rule, PointSource source) {
    switch (source) {
        case PointSource::kHalf:
            break;
        case PointSource::kPaper:
            return paper_estimator(mesh);
        case PointSource::kFit:
            return fit_estimator(mesh);
        case PointSource::kLevel:
            return level_estimator(mesh, rule.level);
    }
    return nullptr;
}

}  // namespace

std::string_view to_string(PointSource source) {
    return kSources[static_cast<std::size_t>(source)];
}

std::optional<PointSource> source_named(std::string_view name) {
    for (std::size_t i = 0; i < kSources.size(); ++i)
        if (kSources[i] == name) return static_cast<PointSource>(i);
    return std::nullopt;
}

Tracker::Tracker(const Mesh& mesh, const Rule& rule, PointSource source, bool hold)
    : detector_(mesh, rule),
      hold_(hold ? std::make_unique<PointHold>(mesh, rule) : nullptr),
      source_(source),
      estimator_(locator_of(mesh, rule, source)) {
    for (std::vector<Point>* list : {&points_, &previous_}) list->reserve(mesh.edge.size() / 8);
}

Tracker::~Tracker() = default;

void Tracker::advance(const Flow& flow, double dt, Workers& workers) {
    CHECK(dt > 0);
    time_ += dt;
    detector_.update(hold_ ? hold_->delay(flow, time_, dt, detector_, points_) : flow);
    previous_.swap(points_);
    points_.clear();
    for (std::size_t i = 0; i < detector_.cut().size(); ++i) {
        const int before = detector_.before()[i];
        Point point{detector_.cut()[i], 0.5f, 0, 0};
        if (before >= 0) {
            point = previous_[before];
            point.age += static_cast<float>(dt);
        }
        points_.push_back(point);
    }
    if (estimator_)
        estimator_->locate({detector_, flow, time_, dt, previous_, hold_.get(), workers}, points_);
    outrun_ = count_outrun(dt);
}

int Tracker::count_outrun(double dt) const {
    const auto vanished = detector_.vanished();
    // Of the edges that the front left through a vertex, the longest time that it was on one, in steps; 0:
    // none.
    const auto steps_to = [&](int vertex) {
        double longest = 0;
        for (const auto& spoke : mesh().around(vertex)) {
            const auto gone =
                std::lower_bound(vanished.begin(), vanished.end(), spoke.edge,
                                 [](const Detector::Gone& one, int edge) { return one.edge < edge; });
            if (gone != vanished.end() && gone->edge == spoke.edge)
                longest = std::max(longest, previous_[gone->before].age / dt + 1);
        }
        return longest;
    };
    return static_cast<int>(std::count_if(detector_.flipped().begin(), detector_.flipped().end(), [&](int v) {
        const double steps = steps_to(v);
        return steps > 0 && steps < 1.5;
    }));
}

glm::vec2 Tracker::position(const Point& point) const {
    return mesh().position[mesh().edge[point.edge].a] + point.f * mesh().along(point.edge);
}

}  // namespace sim::front
