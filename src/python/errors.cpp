#include "core/input_error.hpp"
#include "python/bindings.hpp"

#include <exception>

namespace vesica {

namespace {

/// The classes are Python's, so that the parts of the package that need no compiled module raise them too.
void raise(const char* type, const char* text) {
    const pybind11::object found = pybind11::module_::import("vesica.errors").attr(type);
    PyErr_SetString(found.ptr(), text);
}

} // namespace

void bind_errors(const pybind11::module_&) {
    pybind11::register_exception_translator([](std::exception_ptr thrown) {
        try {
            if (thrown)
                std::rethrow_exception(thrown);
        } catch (const InputError& error) {
            raise("InputError", error.what());
        } catch (const RunError& error) {
            raise("RunError", error.what());
        }
    });
}

} // namespace vesica
