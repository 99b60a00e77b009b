#pragma once

namespace thiessen::cli {

/// The first seven digits of the commit that the program was built from, with `-dirty` behind them
/// where what is compiled was changed since; `unknown` without a clone. CMake writes its source.
const char* commit();

}  // namespace thiessen::cli
