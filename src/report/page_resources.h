#pragma once

namespace thiessen {

/// The files page.html, page.css and page.js of this folder, as the build puts them into the
/// library (resources.cmake), so that nothing is looked for when a page is written.
extern const char* const page_html;
extern const char* const page_css;
extern const char* const page_js;

}  // namespace thiessen
