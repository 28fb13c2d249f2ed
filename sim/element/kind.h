// The kinds of elements.
#pragma once

namespace sim {

// Node order: corners first, then the middle of each edge, in the order of VTK (and Abaqus).
//   tri6: 01 12 20 · tet10: 01 12 20 03 13 23 · quad4, hex8: counter-clockwise from below, bottom before top
enum class ElementKind { tri3, tri6, quad4, tet4, tet10, hex8 };

}  // namespace sim
