#pragma once

namespace thiessen {

/// The page's files of this folder, as the build puts them into the library (resources.cmake), so
/// that nothing is looked for when a page is written: page.html, page.css, and the files of its
/// script one after the other.
extern const char* const page_html;
extern const char* const page_css;
extern const char* const page_script;

}  // namespace thiessen
