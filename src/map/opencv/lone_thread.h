#pragma once

namespace thiessen {

/// Has OpenCV work on the thread that calls it alone, from now on. Its own threads save no time on
/// pieces as small as ours, and where the machine has none left it gives up.
void draw_on_one_thread();

}  // namespace thiessen
