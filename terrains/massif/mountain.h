#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "terrains/massif/level.h"
#include "terrains/massif/massif_numbers.h"
#include "terrains/massif/plan.h"

namespace terrains::massif {

// Makes the ground level by level. One object makes one mountain.
class Mountain {
  public:
    Mountain(const Massif& recipe, std::uint64_t seed);

    // The level for a grid of `squares`: finer than the grid up to kDrawn, at least as fine up to kFinest.
    Level make(int squares);
    // Of the rock at a vertex, if the ground there were so high: 0 to 1.
    double hardness(const Level& g, std::size_t a, double height) const;
    // Snow lies in hollows and on ledges. Wind takes it from ribs, and steep rock sheds it.
    Values snow(const Level& g) const;

  private:
    static constexpr int kCoarsest = 64, kFinest = 1024, kDrawn = 256;  // squares
    static constexpr double kErosion = 0.2;  // Braun and Willett's K Δt, in units that suit m = 0.5
    // Above this share of the square, more water no longer makes a channel gentler: debris flows carve it.
    static constexpr double kSteep = 1.2e-3;

    // ---- rock.cpp: what the mountain is made of ----

    // The pair of a hard and a soft bed at a point: 0 to 1 upwards, the hard one up to `thick`.
    struct Bed {
        double t, thick, strength;
    };
    Bed bed_at(const Level& g, std::size_t a, double height) const;
    // Fields that depend on place only.
    void lay_out(Level& g) const;
    // More uplift makes spurs and summits, less the shoulder above the trough, none the valley floor.
    void lay_out_uplift(Level& g) const;
    // Joints make winding lines of weak rock. The couloir follows such a line between walls of sound rock.
    void lay_out_rock(Level& g) const;
    // Beyond kDrawn squares the fields are interpolated.
    void inherit_layout(const Level& g, Level& fine) const;
    // Hard beds stand out as cliffs, soft ones retreat to ledges: within a pair of beds the height is shifted
    // upwards or downwards, so that the slope as a whole is kept. Crags roughen bare rock.
    void weather(Level& g) const;
    // Slope that the rock bears over some tens of metres. Summits are sound rock, their feet are broken.
    double steepest(const Level& g, int a, double hard) const;

    // ---- erosion.cpp: what water and gravity do ----

    // A wedge with some unevenness and a first trace of the couloir.
    void start(Level& g) const;
    // One step of time: uplift, streams, angles of rest, debris and creep.
    void step(Level& g, double time, bool with_debris);
    // Slope at which running water carries debris on: the angle of rest in dry places, less where water gathers.
    double carrying_slope(double drainage) const;
    void erode(Level& g, double time);
    // Debris breaks off cliffs, follows the flow, and stays where the slope is too gentle to carry it.
    void drop_debris(Level& g, double time);
    // Soil and debris creep: smooths gentle ground and debris, hardly rock.
    void creep(Level& g, double time);

    // ---- forms.cpp: what ice and the couloir add once the drainage has settled ----

    void finish_valley(Level& g);
    // The walls of a trough rise from the floor as a parabola and cut off the ends of the ribs.
    void carve_trough(Level& g) const;
    // Cirques: bowls with a gentle floor and a headwall, dug where the ground below the crest is lowest.
    void carve_cirques(Level& g) const;
    // Heights along the bed of the couloir, which falls all the way.
    void trace_couloir(const Level& g);
    // A bed of debris between rock walls. It opens to a bowl at the top.
    void carve_couloir(Level& g) const;
    // A cone of debris below the mouth of the couloir, as far as the river.
    void build_fan(Level& g) const;
    static void raise_with_debris(Level& g, std::size_t a, double height);

    // ---- mountain.cpp: from level to level ----

    // Adjusts the uplift so that the summits reach the wanted height.
    void steer(const Level& g);
    // Scales the ground to the wanted height.
    void stretch(Level& g) const;
    // Samples heights and debris of `from` at places that are a little off, so that channels, which run along the
    // grid's eight directions, wind. `to` has as many squares or twice as many.
    void bend(const Level& from, Level& to) const;
    // Goes on to a level of twice as many squares.
    void refine(Level& g);

    double floor_height(double x) const;  // m; x in units of the length
    double highest(const Level& g) const;
    // Visits every vertex with its place in units of the length.
    template <class Visit>
    void for_places(const Level& g, Visit visit) const {
        for (int j = 0; j < g.side; ++j) {
            const double y = static_cast<double>(j) / g.squares;
            const Plan::Crossing couloir = plan_.crossing(y);
            for (int i = 0; i < g.side; ++i)
                visit(std::size_t(j) * g.side + i, static_cast<double>(i) / g.squares, y, couloir);
        }
    }

    const Massif& r_;
    Plan plan_;
    std::uint64_t seed_, steps_ = 0;
    Noise beds_{seed_, 15};
    static constexpr int kTrace = 64;
    std::array<double, kTrace + 1> trace_{};  // heights along the bed of the couloir
    double soft_, hard_, lift_, dip_x_ = 0, dip_y_ = 0;
};

}  // namespace terrains::massif
