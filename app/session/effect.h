// What a change of a key does to a run that is under way.
#pragma once

#include "app/scene/keys.h"

namespace app {

enum class Effect {
  look,     // only the picture changes
  motion,   // the run goes on with it
  start,    // the run goes on; it tells at the next reset
  restart,  // not while bodies move: it waits for the restart
};

Effect effect_of(const Key& key);

// "applies at once", "waits for a restart": for people.
const char* effect_text(Effect effect);

}  // namespace app
