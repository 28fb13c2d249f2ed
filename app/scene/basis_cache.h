// Bases that were made before, in files that are called after all that they follow from: making one takes seconds, and
// a minute or two of a large body; reading it takes none, and has the same bits.
#pragma once

#include <filesystem>
#include <optional>

#include "app/scene/document.h"

namespace app {

// Where programs of this user keep what they can make again: $XDG_CACHE_HOME/ritz, else ~/.cache/ritz [XDG Base
// Directory Specification]; empty where neither is known.
std::filesystem::path cache_folder();

// The file of the bases of a document.
std::filesystem::path basis_file(const std::filesystem::path& cache, const Document& document);

// Gives the bodies of a document their vectors, and says how many seconds these took when they were made; nothing where
// there are none. A file that is damaged, or that another one was renamed to, is not trusted: a remark of the document
// tells that what it holds is made anew.
std::optional<double> take_bases(const std::filesystem::path& cache, Document& document);

// Leaves the vectors of a document there, and removes files that were not used for longest where there are too many. A
// remark tells where they cannot be written.
void keep_bases(const std::filesystem::path& cache, Document& document, double seconds);

}  // namespace app
