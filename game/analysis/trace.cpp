#include "game/analysis/trace.h"

#include <fmt/format.h>

namespace game {
namespace {

constexpr double kMicroseconds = 1000;  // per millisecond; the format's unit is the microsecond

// Quotes a string for JSON.
std::string quoted(const std::string& text) {
    return Json(text).dump();
}

// One line per event, because files of a million events are also read and searched by line.
class Events {
  public:
    void name_process(std::size_t process, const std::string& name) {
        add(fmt::format(R"({{"ph":"M","pid":{},"tid":0,"name":"process_name","args":{{"name":{}}}}})",
                        process, quoted(name)));
    }
    void span(std::size_t process, std::string_view name, double begin_ms, double ms, std::int64_t tick) {
        add(fmt::format(
            R"({{"ph":"X","pid":{},"tid":0,"name":"{}","ts":{:.3f},"dur":{:.3f},"args":{{"tick":{}}}}})",
            process, name, begin_ms * kMicroseconds, ms * kMicroseconds, tick));
    }
    void count(std::size_t process, std::string_view name, double at_ms, std::size_t value) {
        add(fmt::format(R"({{"ph":"C","pid":{},"tid":0,"name":"{}","ts":{:.3f},"args":{{"count":{}}}}})",
                        process, name, at_ms * kMicroseconds, value));
    }
    std::string finish() && {
        return "{\"displayTimeUnit\":\"ms\",\"traceEvents\":[\n" + std::move(text_) + "\n]}\n";
    }

  private:
    void add(const std::string& event) {
        if (!text_.empty()) text_ += ",\n";
        text_ += event;
    }
    std::string text_;
};

}  // namespace

std::string trace_of(std::span<const TracedRun> runs) {
    Events events;
    double from_ms = 0;  // start of the run
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const std::size_t process = i + 1;
        events.name_process(process, runs[i].name);
        double end_ms = from_ms;
        for (const PerfRow& row : runs[i].rows) {
            const double begin_ms = from_ms + row.begin_ms;
            events.span(process, "frame", begin_ms, row.frame_ms, row.tick);
            double at_ms = begin_ms;
            for (std::size_t part = 0; part < kPartCount; ++part) {
                if (!row.ms[part]) continue;
                events.span(process, kPartNames[part], at_ms, *row.ms[part], row.tick);
                at_ms += *row.ms[part];
            }
            events.count(process, "active cells", begin_ms, row.active_cells);
            if (row.points) events.count(process, "points of fronts", begin_ms, *row.points);
            end_ms = begin_ms + row.frame_ms;
        }
        from_ms = end_ms;
    }
    return std::move(events).finish();
}

}  // namespace game
