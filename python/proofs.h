// Certificates and audits for Python.
#pragma once

#include <taut/python/bind.h>

namespace taut::python {

void bind_proofs(py::module_& m);

}  // namespace taut::python
