#include "core/version.h"

namespace loopmend {
const char* version() { return LOOPMEND_VERSION; }
}  // namespace loopmend
