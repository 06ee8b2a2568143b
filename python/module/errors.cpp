#include <filesystem>

#include "cli/api.hpp"
#include "core/error.hpp"
#include "python/module/bindings.hpp"

namespace reeve::python {
namespace {

py::object text_or_none(const std::optional<std::string>& text) {
  return text ? py::object(py::str(*text)) : py::none();
}

py::object to_python(const core::InputFault& fault);

// The message need not be the fault's own sentence.
py::object to_python(const std::string& message, const core::InputFault& fault) {
  py::tuple parts(fault.parts.size());
  for (std::size_t i = 0; i < fault.parts.size(); ++i) parts[i] = to_python(fault.parts[i]);
  return py::module_::import("reeve.errors")
      .attr("InputError")(message, text_or_none(fault.where), fault.what, text_or_none(fault.value),
                          fault.expected, parts);
}

// With its parts, as the exception of the package has them.
py::object to_python(const core::InputFault& fault) {
  return to_python(core::sentence(fault), fault);
}

void raise(const py::object& error) {
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const cli::api::OptionError& error) {
    raise(to_python(error.what(), error.option()));
  } catch (const core::InputError& error) {
    raise(to_python(error.fault()));
  } catch (const core::OutOfRange& error) {
    raise(py::module_::import("reeve.errors").attr("OutOfRange")(error.what()));
  } catch (const std::filesystem::filesystem_error& error) {
    PyErr_SetString(PyExc_OSError, error.what());
  }
}

}  // namespace

void bind_errors(py::module_&) { py::register_exception_translator(&translate); }

}  // namespace reeve::python
