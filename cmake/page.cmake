# cmake -DFOLDER=web/page -DOUTPUT=page_text.cpp -P page.cmake: one self-contained page of its parts, as a string in C++.
file(READ ${FOLDER}/page.html page)
file(READ ${FOLDER}/style.css style)
set(script)
foreach(part planner model sheet tools film main)
  file(READ ${FOLDER}/${part}.js text)
  string(REPLACE "\"use strict\";\n" "" text "${text}")
  string(APPEND script "${text}")
endforeach()
string(REPLACE "@taut_style@" "${style}" page "${page}")
string(REPLACE "@taut_script@" "\"use strict\";\n${script}" page "${page}")

# Compilers need not take longer literals than 64 KB: pieces, one behind the other.
string(LENGTH "${page}" left)
set(at 0)
set(pieces)
while(left GREATER 0)
  string(SUBSTRING "${page}" ${at} 8000 piece)
  string(APPEND pieces "    R\"taut_page(${piece})taut_page\"\n")
  math(EXPR at "${at} + 8000")
  math(EXPR left "${left} - 8000")
endwhile()
file(WRITE ${OUTPUT} "// Made by cmake/page.cmake of web/page.
#include <taut/web/page.h>

namespace taut::web {

std::string_view page_template() {
  return
${pieces}      ;
}

}  // namespace taut::web
")
