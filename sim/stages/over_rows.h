#pragma once

#include "sim/core/workers.h"
#include "sim/simd/rows.h"
#include "sim/stages/stage_watch.h"
#include "sim/world/blend.h"

namespace sim {

// Runs each stage of a plain step over all rows, or all rows of faces, before the next one begins. Threads
// share the rows. In a mixed world the constants depend on the vertex, and the stage is remade when they
// change. Each stage has a name for the watch.
template <class Number, class Work>
class OverRows {
  public:
    using Constants = decltype(Work::c);

    // `blends`: none in a world of one material.
    OverRows(Workers& workers, Work& w, const std::optional<Blends<Constants>>& blends, StageWatch* watch)
        : workers_(workers), w_(w), blends_(blends ? &*blends : nullptr), watch_(watch) {}

    Span all() const { return {0, w_.nx}; }

    // `stage(w, y)` makes it for a row, `end(y)` is what ends the row.
    template <class Stage, class End>
    void each_row(std::string_view name, Stage&& stage, End&& end) const {
        each_vertex(blends_ ? blends_->flow : nullptr, stage, end);
        done(name);
    }
    template <class Stage>
    void each_row(std::string_view name, Stage&& stage) const {
        each_row(name, stage, [](int) {});
    }
    // The same, with the parameters of the bed (mixture.h).
    template <class Stage, class End>
    void each_row_of_bed(std::string_view name, Stage&& stage, End&& end) const {
        each_vertex(blends_ ? blends_->bed : nullptr, stage, end);
        done(name);
    }
    template <class Stage>
    void each_row_of_bed(std::string_view name, Stage&& stage) const {
        each_row_of_bed(name, stage, [](int) {});
    }
    // Faces have no material, because the vertices determine the fluxes.
    template <class Stage, class End>
    void each_face(std::string_view name, Stage&& stage, End&& end) const {
        each(w_.ny + 1, [&](int y) { along<Number>(all().faces(), stage(y)), end(y); });
        done(name);
    }
    template <class Stage>
    void each_face(std::string_view name, Stage&& stage) const {
        each_face(name, stage, [](int) {});
    }
    // Runs work that is not a stage.
    template <class Do>
    void each_row_do(std::string_view name, Do&& work) const {
        each(w_.ny, work);
        done(name);
    }

  private:
    void done(std::string_view name) const {
        if (watch_) watch_->done(name);
    }

    template <class Do>
    void each(int rows, Do&& work) const {
        workers_.each_band(rows, [&](int first, int last) {
            for (int y = first; y < last; ++y) work(y);
        });
    }

    template <class Stage, class End>
    void each_vertex(const Field<std::uint8_t>* blend, Stage&& stage, End&& end) const {
        if (!blend) {
            each(w_.ny, [&](int y) { along<Number>(all(), stage(w_, y)), end(y); });
            return;
        }
        workers_.each_band(w_.ny, [&](int first, int last) {
            Work w = w_;
            for (int y = first; y < last; ++y) {
                const std::uint8_t* row = blend->row(y);
                for (int x = 0; x < w.nx;) {
                    const int from = x;
                    while (x < w.nx && row[x] == row[from]) ++x;
                    w.c = blends_->constants[row[from]];
                    along<Number>(Span{from, x}, stage(w, y));
                }
                end(y);
            }
        });
    }

    Workers& workers_;
    Work& w_;
    const Blends<Constants>* blends_;
    StageWatch* watch_;
};

}  // namespace sim
