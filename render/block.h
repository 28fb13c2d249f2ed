// Draws the blocks of numbers of a sheet, its formula and its proof.
#pragma once

#include "render/page.h"
#include "render/sheet.h"

namespace render {

// One below the other from `top` on, in the column from `left` to the right margin. What would come below `bottom`, and
// columns of a table that would lie beyond the margin, are left out: nothing overlaps.
void draw_blocks(const Page& page, const Sheet& sheet, float left, float top, float bottom);

// "label text unit" in a box whose lower right corner is given; without the label where the box would reach beyond
// `left`.
void draw_proof(const Page& page, const std::string& label, const Number& proof, ImVec2 corner, float left);

}  // namespace render
