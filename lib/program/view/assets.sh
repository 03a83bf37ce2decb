#!/bin/sh
# Writes the parts of the pages as a module of OCaml: `assets.sh WEB`, with the folder of their sources.
#
# CodeMirror is the editor of the desk: of its files those that web/desk-library names. It is where SCC_CODEMIRROR says,
# where Debian's package libjs-codemirror has it, or where scripts/dependencies.sh put it in an opam switch.
set -eu
web=$1
editor=${SCC_CODEMIRROR:-/usr/share/javascript/codemirror}
[ -r "$editor/lib/codemirror.js" ] || editor=${OPAM_SWITCH_PREFIX:-}/share/scc-codemirror

# text NAME FILE…
text() {
  printf 'let %s = {scc_asset|' "$1"
  shift
  cat "$@"
  printf '|scc_asset}\n\n'
}

script() {
  printf '    ("%s", {scc_asset|' "$(basename "$1")"
  cat "$1"
  printf '|scc_asset});\n'
}

# library ENDING: the files of the editor with that ending, if it is there.
library() {
  [ -r "$editor/lib/codemirror.js" ] || return 0
  sed -n "s|.*\\.$1\$|$editor/&|p" "$web/desk-library"
}

text whole "$web/whole.js"
text page "$web/page.html"
text style "$web/base.css" "$web/page.css"
echo 'let scripts ='
echo '  ['
while read -r name; do script "$web/$name"; done < "$web/scripts"
echo '  ]'
echo

text solid "$web/solid.html"
text solid_style "$web/base.css" "$web/solid.css"
echo 'let solid_scripts ='
echo '  ['
while read -r name; do script "$web/$name"; done < "$web/solid-scripts"
echo '  ]'
echo

text desk "$web/desk.html"
echo 'let desk_styles ='
echo '  ['
for file in $(library css) "$web/base.css" "$web/desk.css"; do
  printf '    {scc_asset|'
  cat "$file"
  printf '|scc_asset};\n'
done
echo '  ]'
echo
echo 'let desk_scripts ='
echo '  ['
for file in $(library js); do script "$file"; done
while read -r name; do script "$web/$name"; done < "$web/desk-scripts"
echo '  ]'
