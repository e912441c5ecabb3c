// Loads the server behind a page where it is asked for.
#pragma once

#include <taut/cli/view/page_server.h>

namespace taut::cli {

/// Is the server's module there? It is built where cpp-httplib is.
bool can_serve();

/// What the module says (page_server.h). Precondition: can_serve(). Throws InputError where it throws, or is no module.
std::size_t serve(const PageServing& serving);

}  // namespace taut::cli
