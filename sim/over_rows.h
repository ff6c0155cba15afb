#pragma once

#include "sim/rows.h"
#include "sim/workers.h"

namespace sim {

// A plain step's way: a stage goes over all rows, or all rows of faces, before the next one begins; the rows
// are shared out among threads.
template <class Number>
class OverRows {
  public:
    OverRows(Workers& workers, int nx, int ny) : workers_(workers), all_{0, nx}, ny_(ny) {}

    Span all() const { return all_; }

    // `stage(y)` makes it for a row, `end(y)` is what ends the row.
    template <class Stage, class End>
    void each_row(Stage&& stage, End&& end) const {
        each(ny_, [&](int y) { along<Number>(all_, stage(y)), end(y); });
    }
    template <class Stage>
    void each_row(Stage&& stage) const {
        each_row(stage, [](int) {});
    }
    template <class Stage, class End>
    void each_face(Stage&& stage, End&& end) const {
        each(ny_ + 1, [&](int y) { along<Number>(all_.faces(), stage(y)), end(y); });
    }
    template <class Stage>
    void each_face(Stage&& stage) const {
        each_face(stage, [](int) {});
    }
    // What is no stage.
    template <class Work>
    void each_row_do(Work&& work) const {
        each(ny_, work);
    }

  private:
    template <class Work>
    void each(int rows, Work&& work) const {
        workers_.each_band(rows, [&](int first, int last) {
            for (int y = first; y < last; ++y) work(y);
        });
    }

    Workers& workers_;
    Span all_;
    int ny_;
};

}  // namespace sim
