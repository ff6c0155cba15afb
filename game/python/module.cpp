#include <exception>
#include <string>
#include <utility>

#include "game/base/process.h"
#include "game/base/version.h"
#include "game/python/fronts.h"
#include "game/python/runs.h"
#include "game/python/world.h"

// Python's `import couloir`. docs/python.md is its manual, and couloir.pyi has every signature.
PYBIND11_MODULE(couloir, module) {
    using namespace game::python;
    module.doc() = "Avalanches and landslides on terrain; docs/python.md is the manual.";
    static const py::handle error =
        py::exception<Error>(module, "Error").release();  // lives as long as Python
    py::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown) std::rethrow_exception(std::move(thrown));
        } catch (const Error& refused) {
            py::object raised = error(std::string(refused.what()));
            raised.attr("status") = refused.status;
            PyErr_SetObject(error.ptr(), raised.ptr());
        }
    });
    add_worlds(module);
    add_fronts(module);
    add_recordings(module);
    add_ensembles(module);
    module.attr("__version__") = game::kVersionNumber;
}
