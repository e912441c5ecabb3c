#include <taut/geometry/detail/crew.h>
// In a page (web/wasm/CMakeLists.txt) there is no oneTBB, and one thread: crew.cpp is left out.
#ifdef TAUT_IN_PAGE

namespace taut::detail {

void work_together(unsigned jobs, void (*work)(void*), void* context) {
  for (unsigned i = 0; i < jobs; ++i) work(context);
}

int cores() { return 1; }

}  // namespace taut::detail

#endif
