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

// How textures are kept from being drawn out.
struct LayerRule {
    float shortest_s = 1;      // latency of the first layer, ≥ 0.25; each further one lasts twice as long
    float deformation = 0.5f;  // d*: the stretch, as a logarithm, that a person lets pass, ≥ 0
    // False: fronts as the paper has them to the letter. A vertex that a front has passed keeps the
    // coordinates of the side on which it was, and what lies across a front is mixed in. To show what it is
    // worth.
    bool reseed = true;
};

// Texture coordinates that travel with a flow: after Neyret (Advected textures, 2003) layers of different
// latency, each of two phases that are renewed in turn while the other is seen. Unlike there a renewed phase
// takes up the mean displacement of its region, where no front separates vertices, instead of an arbitrary
// one: only what is drawn out goes back, and where a region moves as a whole both phases show the same.
//
// A view: it changes nothing of the flow. Ground at rest keeps its coordinates, to the bit.
class TextureLayers {
  public:
    static constexpr int kLatencies = 3;
    static constexpr int kSheets = 2 * kLatencies;  // sets of coordinates; 2 · latency + phase

    // Of each sheet what is added to a vertex's place to give its texture coordinates, m. 0 where nothing
    // ever moved.
    using Offsets = std::array<glm::vec2, kSheets>;
    // Of each sheet how the offset changes around a vertex on its side; columns ∂/∂x and ∂/∂y.
    using Gradients = std::array<glm::mat2, kSheets>;
    // What of the sheets is seen at a vertex.
    struct Mix {
        std::array<float, kLatencies> second{};  // share of each layer's second phase, 0 … 1
        float latency = kLatencies - 1;          // which layer, 0 … kLatencies − 1; between two a mixture
    };

    // The mesh must outlive it.
    TextureLayers(const Mesh& mesh, const LayerRule& rule);

    // To `dt` seconds later, > 0, in two stages. `tracker` has been advanced to that moment with these
    // velocities, one for each vertex, m/s. However many workers: the same bits.
    void advance(const Tracker& tracker, std::span<const glm::vec2> velocity, double dt, Workers& workers) {
        carry(tracker, velocity, dt, workers);
        settle(tracker, dt, workers);
    }
    // Coordinates with the flow, to the sides that fronts left them on, and back where they are renewed.
    void carry(const Tracker& tracker, std::span<const glm::vec2> velocity, double dt, Workers& workers);
    // What is seen of them, and how they go on to the fronts.
    void settle(const Tracker& tracker, double dt, Workers& workers);

    std::span<const Offsets> offsets() const { return now_.offset; }  // of each vertex
    std::span<const Mix> mix() const { return now_.mix; }             // of each vertex
    // Whether anything ever moved at a vertex.
    bool has_moved(int vertex) const { return now_.offset[vertex] != Offsets{}; }
    // Vertices beside a front, ascending, and the gradients there.
    std::span<const int> beside_front() const { return now_.beside; }
    std::span<const Gradients> gradients() const { return now_.gradient; }

    // Of a vertex of the cut mesh, carried on from its side.
    glm::vec2 offset(const CutVertex& vertex, int sheet) const;
    // Share of a sheet in what is seen at a vertex; those of all sheets add up to 1.
    float weight(int vertex, int sheet) const;

    // All that is not worked out anew in each step: to come back to.
    struct Memory {
        double time = 0;         // s
        std::int64_t steps = 0;  // done
        std::vector<Offsets> offset;
        std::vector<Mix> mix;
        std::vector<std::array<float, kLatencies>> deformation;  // of each vertex and layer, lately at most
        std::vector<int> moving;  // vertices that did in the step before, ascending
        std::vector<int> beside;
        std::vector<Gradients> gradient;

        static constexpr std::size_t kBytesPerVertex =
            sizeof(Offsets) + sizeof(Mix) + kLatencies * sizeof(float) + sizeof(int);
    };
    const Memory& memory() const { return now_; }
    void restore(const Memory& memory);

    double latency_s(int latency) const { return static_cast<double>(rule_.shortest_s) * (1 << latency); }
    // Since a sheet was renewed, s.
    double age_s(int sheet) const;

  private:
    void tear(const Detector& detector);
    void find_slopes(const Detector& detector, Workers& workers);
    void follow(std::span<const glm::vec2> velocity, double dt, Workers& workers);
    void pull_stranded(const Detector& detector, std::span<const glm::vec2> velocity, double dt);
    void reseed(const Detector& detector);
    void lay_down(const Detector& detector);
    void renew(const Detector& detector, double before);
    void find_regions(const Detector& detector);
    // Adds how far a vertex that moves has its offsets change on the way from it.
    void add_slope(int vertex, const glm::vec2& way, Offsets& sum) const;
    void fade(double dt);
    void choose_latency(const Detector& detector, double dt, Workers& workers);
    void find_front_gradients(const Detector& detector, Workers& workers);
    bool is_renewed(int sheet, double before) const;

    const Mesh& mesh_;
    LayerRule rule_;
    Upstream upstream_;
    Memory now_;

    std::vector<std::uint8_t> torn_;  // of each triangle: it is cut
    std::vector<int> torn_list_;
    std::vector<std::uint8_t> at_tear_;  // of each vertex: an edge there is cut, or was a step ago
    std::vector<int> torn_vertices_;
    std::vector<int> place_;         // of each vertex its place among those that move, −1: it rests
    std::vector<int> came_to_rest_;  // since the step before, ascending
    struct Slope {
        Offsets x, y;  // by how much offsets change along x and y, per m
    };
    std::vector<Slope> slope_;        // of each that moves
    std::vector<glm::mat2> inverse_;  // of each vertex its whole fan's, for the slope
    std::vector<Offsets> carried_;    // of each that moves
    std::vector<std::uint8_t> is_stranded_;
    std::vector<int> stranded_;
    std::vector<int> region_;  // of each that moves, a place of its region: toward the first
    std::vector<int> number_;  // of each that moves, its region's
    int regions_ = 0;
    struct Sum {
        std::array<glm::dvec2, kSheets> offset{};
        double count = 0;
    };
    std::vector<Sum> sum_;  // over each region
    std::vector<int> due_;
    std::vector<float> latency_;  // of each that is due
    std::vector<int> slot_;       // of each vertex its place among those beside a front, −1: it has none
    std::vector<int> beside_before_;
    std::vector<Gradients> gradient_before_;
};

}  // namespace sim::front
