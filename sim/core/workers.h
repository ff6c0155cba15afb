#pragma once

#include <memory>
#include <type_traits>

namespace sim {

// A fixed set of threads that divides rows among itself. Each stage writes only its own rows and reads only
// what an earlier stage finished, so results do not depend on the number of threads.
class Workers {
  public:
    // ≥ 1; 1 starts none. Throws std::system_error if there are no more. Without threads (workers_alone.cpp) only 1.
    explicit Workers(int threads);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    int threads() const { return threads_; }

    // Calls stage(first, last) for bands of the rows 0 … rows-1, and returns when all are done. `stage` must
    // not throw.
    template <class Stage>
    void each_band(int rows, Stage&& stage) {
        each_member(rows, [&](int, int first, int last) { stage(first, last); });
    }
    // The same, with the number of the calling thread, 0 … threads()-1.
    template <class Stage>
    void each_member(int rows, Stage&& stage) {
        using Callable = std::remove_reference_t<Stage>;
        run(
            rows,
            [](void* callable, int member, int first, int last) {
                (*static_cast<Callable*>(callable))(member, first, last);
            },
            const_cast<void*>(static_cast<const void*>(&stage)));
    }

  private:
    using Call = void (*)(void*, int, int, int);
    void run(int rows, Call call, void* callable);

    class Crew;
    int threads_ = 1;
    std::unique_ptr<Crew> crew_;  // none if the caller is alone
};

}  // namespace sim
