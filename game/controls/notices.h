#pragma once

#include <array>
#include <cstddef>
#include <string>

namespace game {

// A message to the user: what was loaded, saved or refused, and why.
struct Notice {
    enum class Kind { kInfo, kWarning } kind = Kind::kInfo;
    std::string sentence;
    double told_s = -1e9;  // when it was shown, on the screen's clock
    int times = 1;         // repetitions in a row
};

class Notices {
  public:
    static constexpr std::size_t kKept = 6;
    static constexpr double kInfoStays = 6, kWarningStays = 12;  // s

    // Adds a notice. A repeated sentence that is still visible only increases its count.
    void tell(Notice::Kind kind, std::string sentence, double now_s);

    std::size_t size() const { return size_; }
    const Notice& operator[](std::size_t i) const;  // 0 is the oldest
    // 1 while a notice is fresh, falling to 0 over its last second, 0 when it is over.
    static double strength(const Notice& notice, double now_s);

  private:
    std::array<Notice, kKept> notices_;
    std::size_t first_ = 0, size_ = 0;
};

}  // namespace game
