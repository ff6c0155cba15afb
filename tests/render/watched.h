#pragma once

#include <type_traits>

#include <epoxy/gl.h>

namespace render::test {

inline int gl_objects = 0;  // created while a Watched exists

// Counts the calls of an entry point that creates GL names, during its lifetime. The loader keeps the entry
// points in variables.
template <auto* kEntry>
class Watched {
    using Function = std::remove_pointer_t<decltype(kEntry)>;

  public:
    Watched() {
        behind_ = *kEntry;
        *kEntry = counted(behind_);
    }
    ~Watched() { *kEntry = behind_; }
    Watched(const Watched&) = delete;
    Watched& operator=(const Watched&) = delete;

  private:
    template <class... Args>
    static Function counted(void (*)(Args...)) {
        return [](Args... args) {
            ++gl_objects;
            behind_(args...);
        };
    }
    static inline Function behind_ = nullptr;
};

}  // namespace render::test
