#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/mat2x2.hpp>
#include <glm/vec2.hpp>

#include "sim/front/remesh_reference.h"
#include "sim/front/tracker.h"
#include "sim/front/upstream.h"

namespace sim::front {

// How texture layers limit stretch.
struct LayerRule {
    float shortest_s = 1;      // latency of the first layer, ≥ 0.25; each further one lasts twice as long
    float deformation = 0.5f;  // d*: tolerated stretch, as a logarithm, ≥ 0
    // False: fronts exactly as in the paper. A vertex that a front has passed keeps the coordinates of its
    // former side, and coordinates are mixed across a front. For comparison.
    bool reseed = true;
};

// Texture coordinates advected with a flow, in layers of different latency after Neyret (Advected textures,
// 2003). Each layer has two phases that are renewed in turn while the other is visible. Unlike in Neyret's
// method, a renewed phase takes the mean displacement of its region, the vertices that no front separates,
// not an arbitrary one. So only stretch is reset, and in a region that moves rigidly both phases look the
// same.
//
// A view: it does not change the flow. The coordinates of ground at rest stay bit-identical.
class TextureLayers {
  public:
    static constexpr int kLatencies = 3;
    static constexpr int kSheets = 2 * kLatencies;  // sets of coordinates; index: 2 · latency + phase

    // For each sheet, the offset to add to a vertex's position to get its texture coordinates, m. 0 where
    // nothing ever moved.
    using Offsets = std::array<glm::vec2, kSheets>;
    // For each sheet, the gradient of the offset on the vertex's own side; columns ∂/∂x and ∂/∂y.
    using Gradients = std::array<glm::mat2, kSheets>;
    // How visible the sheets are at a vertex.
    struct Mix {
        std::array<float, kLatencies> second{};  // share of each layer's second phase, 0 … 1
        float latency = kLatencies - 1;          // layer, 0 … kLatencies − 1; fractions blend two
    };

    // The mesh must outlive the layers.
    TextureLayers(const Mesh& mesh, const LayerRule& rule);

    // Advances by `dt` seconds, > 0, in two stages. `tracker` must already be at the new moment, with the
    // same velocities, one for each vertex, m/s. Results are bit-identical for any number of workers.
    void advance(const Tracker& tracker, std::span<const glm::vec2> velocity, double dt, Workers& workers) {
        carry(tracker, velocity, dt, workers);
        settle(tracker, dt, workers);
    }
    // Advects coordinates with the flow, reassigns them where fronts passed, and renews phases that are due.
    void carry(const Tracker& tracker, std::span<const glm::vec2> velocity, double dt, Workers& workers);
    // Updates the blend of the sheets and the gradients beside fronts.
    void settle(const Tracker& tracker, double dt, Workers& workers);

    std::span<const Offsets> offsets() const { return now_.offset; }  // per vertex
    std::span<const Mix> mix() const { return now_.mix; }             // per vertex
    // True if anything ever moved at a vertex.
    bool has_moved(int vertex) const { return now_.offset[vertex] != Offsets{}; }
    // Vertices in the order of their numbers, this many to a group. A group is untouched while all its offsets and
    // mixes are those of new layers, bit by bit: a reader may skip it. Where anything moved, it is touched for good.
    static constexpr std::size_t kGroup = 64;
    std::span<const std::uint8_t> touched() const {
        return touched_;
    }  // 1 or 0 per group; the last may be smaller
    // Vertices beside a front, ascending, and their gradients.
    std::span<const int> beside_front() const { return now_.beside; }
    std::span<const Gradients> gradients() const { return now_.gradient; }

    // Offset at a vertex of the cut mesh, extrapolated on its side by equation (9).
    glm::vec2 offset(const CutVertex& vertex, int sheet) const;
    // Share of a sheet in the blend at a vertex; the shares of all sheets add up to 1.
    float weight(int vertex, int sheet) const;

    // The state that is not recomputed in each step; saved to go back to it.
    struct Memory {
        double time = 0;         // s
        std::int64_t steps = 0;  // done
        std::vector<Offsets> offset;
        std::vector<Mix> mix;
        std::vector<std::array<float, kLatencies>> deformation;  // per vertex and layer: recent maximum
        std::vector<int> moving;  // vertices that moved in the previous step, ascending
        std::vector<int> beside;
        std::vector<Gradients> gradient;

        static constexpr std::size_t kBytesPerVertex =
            sizeof(Offsets) + sizeof(Mix) + kLatencies * sizeof(float) + sizeof(int);
    };
    const Memory& memory() const { return now_; }
    void restore(const Memory& memory);

    double latency_s(int latency) const { return static_cast<double>(rule_.shortest_s) * (1 << latency); }
    // Time since a sheet was renewed, s.
    double age_s(int sheet) const;

  private:
    void find_touched();
    void tear(const Detector& detector);
    void find_slopes(const Detector& detector, Workers& workers);
    void follow(std::span<const glm::vec2> velocity, double dt, Workers& workers);
    void pull_stranded(const Detector& detector, std::span<const glm::vec2> velocity, double dt);
    void reseed(const Detector& detector);
    void lay_down(const Detector& detector);
    void renew(const Detector& detector, double before);
    void find_regions(const Detector& detector);
    // Adds the change of a moving vertex's offsets over `way`.
    void add_slope(int vertex, const glm::vec2& way, Offsets& sum) const;
    void fade(double dt);
    void choose_latency(const Detector& detector, double dt, Workers& workers);
    void find_front_gradients(const Detector& detector, Workers& workers);
    bool is_renewed(int sheet, double before) const;

    const Mesh& mesh_;
    LayerRule rule_;
    Upstream upstream_;
    Memory now_;

    std::vector<std::uint8_t> touched_;
    std::vector<std::uint8_t> torn_;  // per triangle: it is cut
    std::vector<int> torn_list_;
    std::vector<std::uint8_t> at_tear_;  // per vertex: one of its edges is cut, or was a step ago
    std::vector<int> torn_vertices_;
    std::vector<int> place_;         // per vertex: index in `moving`, −1 at rest
    std::vector<int> came_to_rest_;  // since the previous step, ascending
    struct Slope {
        Offsets x, y;  // change of offsets along x and y, per m
    };
    std::vector<Slope> slope_;        // per moving vertex
    std::vector<glm::mat2> inverse_;  // per vertex, of all its spokes: for the slope
    std::vector<Offsets> carried_;    // per moving vertex
    std::vector<std::uint8_t> is_stranded_;
    std::vector<int> stranded_;
    std::vector<int> region_;  // per moving vertex: a member of its region, toward the first
    std::vector<int> number_;  // per moving vertex: number of its region
    int regions_ = 0;
    struct Sum {
        std::array<glm::dvec2, kSheets> offset{};
        double count = 0;
    };
    std::vector<Sum> sum_;  // per region
    std::vector<int> due_;
    std::vector<float> latency_;  // per vertex that is due
    std::vector<int> slot_;       // per vertex: index in `beside`, −1 if none
    std::vector<int> beside_before_;
    std::vector<Gradients> gradient_before_;
};

}  // namespace sim::front
