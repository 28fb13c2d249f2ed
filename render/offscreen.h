// The kinds of contexts that draw without a window; each is compiled where its library was found.
#pragma once

#include <memory>

#include "render/context.h"

namespace render {

// Mesa's software rasteriser, drawing into memory: needs neither display nor graphics card.
std::unique_ptr<Context> make_osmesa_context();
// EGL without a surface: a graphics card where there is one, else the software rasteriser.
std::unique_ptr<Context> make_egl_context();

}  // namespace render
