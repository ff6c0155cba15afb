#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "game/base/number.h"
#include "game/base/outcome.h"
#include "game/scene/scene.h"
#include "sim/core/grid.h"
#include "sim/world/command.h"

namespace game::python {

namespace py = pybind11;

// What Python gets as couloir.Error: the sentence that the program prints, and its exit status.
struct Error : std::runtime_error {
    explicit Error(const Failure& failure) : std::runtime_error(failure.sentence), status(failure.status) {}
    int status;
};

template <class T>
T value_of(Outcome<T> outcome) {
    if (!outcome) throw Error(outcome.error());
    if constexpr (!std::is_void_v<T>) return std::move(*outcome);
}
inline Error refusal(const std::string& sentence) {
    return Error({Failure::kUnusable, sentence});
}

// The value, if it is within the range. Throws Error.
template <class Number>
Number checked(Number value, const Range<Number>& range, std::string_view name) {
    if (!(value >= range.least && value <= range.most))
        throw refusal(fmt::format("{} is {}, outside {}", name, value, to_text(range)));
    return value;
}

// Numbers of Python, which are copied, as a contiguous array.
template <class Number>
using Numbers = py::array_t<Number, py::array::c_style | py::array::forcecast>;

// An array that shares the memory of its owner, and cannot be written.
py::array read_only(py::array array);
// A field without its halo, as such an array of ny × nx, which keeps its owner.
py::array array_of(const sim::Field<float>& field, const py::object& owner);
// The same of a value for each vertex.
template <class Number>
py::array array_of(const sim::Grid& grid, const Number* values, const py::object& owner) {
    return read_only({py::dtype::of<Number>(), {grid.ny, grid.nx}, values, owner});
}

// A command of this kind from keyword arguments named as in a recording, but for `layer`, which is `as` there. What is left
// out has its usual value, if there is one. Throws Error.
sim::Command command_from(const sim::CommandInfo& info, const py::kwargs& arguments);
// Its arguments, units and ranges, for help().
std::string help_of(const sim::CommandInfo& info);

// The keyword arguments of whatever opens a world. Throws Error.
struct OpeningArguments {
    std::optional<int> grid;
    std::optional<std::string> material, model, size_class, crs;
    std::optional<py::dict> set;
    int threads = 1;
};
Overrides overrides_from(const OpeningArguments& arguments);
// Throws Error if so many are not allowed.
int checked_threads(int threads);

// Marks something as in use by a thread that is going to let others run. Made and unmade while it holds Python's lock. Throws
// Error, with this sentence, if another thread uses it.
class Busy {
  public:
    Busy(bool& flag, const char* sentence) : flag_(flag) {
        if (flag) throw refusal(sentence);
        flag = true;
    }
    ~Busy() { flag_ = false; }
    Busy(const Busy&) = delete;
    Busy& operator=(const Busy&) = delete;

  private:
    bool& flag_;
};

// Lets other threads of Python run while it exists. Long work calls look() now and then.
class WhilePythonRuns {
  public:
    // Every tenth of a second, whether the user pressed Ctrl+C. Throws KeyboardInterrupt, or what a handler of a signal threw.
    void look();

  private:
    py::gil_scoped_release released_;
    std::chrono::steady_clock::time_point looked_ = std::chrono::steady_clock::now();
};

}  // namespace game::python
