// Draws the blocks of numbers of a sheet, its formula and its proof.
#pragma once

#include "render/page.h"
#include "render/sheet.h"

namespace render {

// One below the other from `top` on, in the column from `left` to the right margin.
void draw_blocks(const Page& page, const Sheet& sheet, float left, float top);

// "label text unit" in a box whose lower right corner is given.
void draw_proof(const Page& page, const std::string& label, const Number& proof, ImVec2 corner);

}  // namespace render
